"""Where one comes from: streets, compass, roundabouts, behind others; what hides whom; how far ahead one comes out."""

import pytest


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("A truck leaves a side street on the right and turns left across ego's path.", "crossing_right"),
        ("A car comes out of a side road on the left and turns right in front of ego.", "crossing_left"),
        ("A van turns out of the road on the right.", "crossing_right"),
        ("A cyclist crosses the intersection from ego's left while ego goes straight.", "crossing_left"),
        ("Ego circulates in the roundabout when a car enters from the next entry without yielding.", "crossing_right"),
        ("A car enters the roundabout in front of ego without giving way.", "crossing_right"),
        ("A taxi at the right-hand kerb pulls away without looking.", "parked"),
    ],
)
def test_where_a_vehicle_comes_from(read, text: str, position: str) -> None:
    assert read(text)["O1"].spec.placement.position == position


@pytest.mark.parametrize(
    "text",
    [
        "A truck 80 m ahead slows from 90 km/h to a standstill.",
    ],
)
def test_who_comes_into_view_is_not_ego(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects if o.spec.type in ("car", "truck")]


@pytest.mark.parametrize(
    ("text", "side"),
    [
        ("A pedestrian crosses from the north to the south side while ego drives east.", "left"),
        ("Ego drives north. A pedestrian walks across the road from east to west.", "right"),
        ("The westbound ego stops for a child who runs from the south side of the road.", "left"),
    ],
)
def test_people_by_compass(read, text: str, side: str) -> None:
    assert read(text)["O1"].spec.placement.side == side


@pytest.mark.parametrize(
    "text",
    [
        "From behind an oncoming truck a motorcycle pulls out to overtake.",
        "An oncoming truck is ahead of ego. A car behind the truck pulls out and overtakes it.",
    ],
)
def test_out_from_behind_an_oncoming_one(read, text: str) -> None:
    assert [(p.action, p.target) for p in read(text)["O2"].spec.phases][-1] == ("overtake", "O1")


@pytest.mark.parametrize(
    ("text", "hidden"),
    [
        ("Ego's view of the cyclist is blocked by a parked van.", "bicycle"),
        ("The stopped bus obstructs the view of a pedestrian who crosses in front of it.", "pedestrian"),
        ("A motorcycle is masked by the van ahead of ego.", "motorcycle"),
        ("A truck in the next lane hides a crossing pedestrian from ego.", "pedestrian"),
        ("A bus at the stop on the right blocks the view of a child.", "child"),
    ],
)
def test_hidden(read, text: str, hidden: str) -> None:
    spec = next(o.spec for o in read(text).objects if o.spec.type == hidden)
    assert spec.placement.hidden_by == "O1"


def test_where_the_hidden_are(read) -> None:
    s = read("The driver could not see the child because of a parked bus on the left.")
    assert (s["O2"].spec.placement.position, s["O2"].spec.placement.side) == ("roadside", "left")
    s = read("A motorcycle is masked by the van ahead of ego.")
    assert (s["O2"].spec.placement.position, s["O2"].spec.placement.of) == ("ahead", "O1")
    s = read("A truck in the next lane hides a crossing pedestrian from ego.")
    assert [p.action for p in s["O2"].spec.phases] == ["cross_road"]


def test_a_passenger_crosses(read) -> None:
    s = read("Ego passes a bus at a stop; a passenger crosses the road from in front of the bus.")
    assert [o.spec.type for o in s.objects] == ["bus", "pedestrian"]


@pytest.mark.parametrize(
    ("text", "away"),
    [
        ("A child runs onto the road 20 m in front of ego.", 20.0),
        ("30 m ahead of ego a dog runs across the road.", 30.0),
        ("A car pulls out of a parking space 25 m ahead.", 25.0),
    ],
)
def test_how_far_ahead_one_comes_out(read, text: str, away: float) -> None:
    trigger = read(text)["O1"].spec.phases[0].trigger
    assert trigger is not None and (trigger.kind, trigger.value) == ("distance", away)


def test_beside_ego_on_the_ramp_is_no_cut_in(read) -> None:
    s = read("Ego drives on the acceleration lane and a truck drives next to it in the right lane of the motorway.")
    assert not s["O1"].spec.phases and s["O1"].spec.placement.along == "abreast"


@pytest.mark.parametrize(
    "text",
    [
        "Ego and a van approach each other on a country road.",
        "VUT and target approach each other head-on, both at 50 km/h.",
        "Two-way road. The ego car and a truck drive towards each other.",
    ],
)
def test_towards_each_other(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "A cyclist rides across ego's path from the right.",
        "From behind a bus in the opposite lane a bicycle rides across ego's lane from left to right.",
        "A boy on a bike crosses the road from the left.",
    ],
)
def test_a_bicycle_crosses_where_no_road_does(read, text: str) -> None:
    s = read(text)
    bike = next(o.spec for o in s.objects if o.spec.type == "bicycle")
    assert bike.placement.position in ("roadside", "sidewalk") and bike.phases[0].action == "cross_road"


def test_around_the_bend(read) -> None:
    s = read("On a winding mountain road, a motorcyclist comes around the bend in ego's lane.")
    assert (s["O1"].spec.placement.position, s["O1"].spec.placement.facing) == ("ahead", "against")
    s = read("Ego drives on a country road. A lorry appears round the bend and drifts over the line.")
    assert s["O1"].spec.placement.position == "oncoming_lane"


def test_over_a_carriageway(read) -> None:
    s = read("Ego crosses a dual carriageway at a junction; a car comes from the right at 80 km/h.")
    assert [p.action for p in s["E"].spec.phases] == ["go_straight"]
    s = read("A truck crosses the main road at the junction from the left. Ego brakes.")
    assert s["O1"].spec.placement.position == "crossing_left"


@pytest.mark.parametrize(("text", "lanes"), [
    ("Ego drives on a four-lane divided highway behind a truck.", 2),
    ("Ego follows a car on a three-lane motorway.", 3),
    ("Ego follows a car on a four-lane undivided road.", 2),
])  # fmt: skip
def test_lanes_each_way(read, text: str, lanes: int) -> None:
    assert read(text)["R"].spec.lanes == lanes

"""Who a title names, who goes first, who comes towards whom, and what hides somebody."""

import pytest


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Crossing vehicle. At a T-junction a pickup comes from the left and does not stop for the ego.", ["truck"]),
        ("Crossing vehicle does not stop. A van comes from the left while the ego goes straight.", ["van"]),
        ("Overtaking motorcycle. The ego drives at 80 km/h; a motorcycle passes it.", ["motorcycle"]),
        ("Wrong-way vehicle. The ego is on a motorway when a van comes towards it in its lane.", ["van"]),
        ("Vehicle ahead brakes. A truck behind ego hits it.", ["car", "truck"]),
        ("Lead vehicle brakes. A truck behind ego hits it.", ["car", "truck"]),
    ],
)
def test_who_a_title_names(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


@pytest.mark.parametrize(
    "text",
    [
        "The ego waits at the stop line to turn left; an oncoming bus goes straight and passes first.",
        "At an unsignalised junction a car comes from the right and goes first; the ego turns left after it.",
        "At a four-way stop, a truck on the left drives first, then the ego proceeds.",
    ],
)
def test_who_goes_first(read, text: str) -> None:
    s = read(text)
    assert s["E"].spec.reaction == "yield" and s["E"].spec.react_to == "O1"


@pytest.mark.parametrize(
    "text",
    ["The ego and a truck approach each other.", "A van and the ego drive towards each other on a rural road."],
)
def test_towards_each_other(read, text: str) -> None:
    assert read(text).objects[0].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "A bus stands in the opposite lane. From behind it, a cyclist rides across the ego's lane from the left.",
        "A bus is parked on the right. From in front of it, a child runs onto the road.",
    ],
)
def test_from_behind_it(read, text: str) -> None:
    assert read(text).objects[1].spec.placement.hidden_by == "O1"


@pytest.mark.parametrize("verb", ["forces its way into the gap", "squeezes into the space", "slips into a small gap"])
def test_into_the_gap(read, verb: str) -> None:
    s = read(f"The other car {verb} between ego and the truck ahead.")
    assert [p.action for p in s.objects[0].spec.phases] == ["cut_in"]


def test_what_it_starts_at(read) -> None:
    s = read("The lead vehicle starts 25 m in front of the ego.")
    assert s.objects[0].spec.placement.gap == 25


def test_a_fare_is_picked_up(read) -> None:
    s = read("A taxi ahead of ego stops to pick up a fare; ego passes it on the left and then goes back.")
    assert len(s.objects) == 1 and [p.action for p in s["E"].spec.phases] == ["overtake"]


def test_zips_over_the_crossing(read) -> None:
    s = read("A person on an e-scooter zips over the zebra crossing from right to left.")
    assert [p.action for p in s.objects[0].spec.phases] == ["cross_road"]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        (
            "Cut-in by a slower vehicle. With ALKS active at 60 km/h on a motorway of two lanes, a passenger car doing "
            "40 km/h in the lane on the right begins a lane change in front of the ALKS vehicle.",
            ["car"],
        ),
        (
            "Vehicle changing lanes, same direction. The host, driving at 55 mph in the right lane, moves over to the "
            "left lane although a car is coming up from behind there.",
            ["car"],
        ),
        ("Bicyclist, longitudinal: straight road, bicycle at 15 km/h ahead in the lane of the VUT.", ["bicycle"]),
        ("Slow truck ahead. A car overtakes ego.", ["truck", "car"]),
        ("Parked vehicle on the right. A car pulls out in front of ego.", ["car", "car"]),
    ],
)
def test_who_is_only_in_the_title(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_let_by_before_the_lane_change(read) -> None:
    s = read(
        "On a motorway ego is in the right lane. An SUV is coming up from behind in the lane to the left, so the ego "
        "slows down, lets the SUV go by and changes to that lane behind it."
    )
    assert [p.action for p in s["E"].spec.phases] == ["yield", "lane_change"]


def test_stops_until_the_ambulance_is_past(read) -> None:
    s = read(
        "An ambulance comes up from the rear in the same lane. The automated vehicle shall keep to the right, come to "
        "a stop and remain there until the ambulance has gone by."
    )
    assert [p.action for p in s["E"].spec.phases] == ["stop"]


@pytest.mark.parametrize(
    ("text", "phases"),
    [
        ("Ego brakes. A car behind it runs into its rear end.", [("brake", None)]),
        ("Ego brakes hard; the car behind hits it.", [("brake", 6.0)]),
    ],
)
def test_brakes_with_nobody_ahead(read, text: str, phases: list) -> None:
    assert [(p.action, p.rate) for p in read(text)["E"].spec.phases] == phases


def test_stops_before_contact(read) -> None:
    s = read(
        "The VUT backs up at 6 km/h. An adult stands 8 m behind it. The car shall stop before touching the person."
    )
    assert [o.spec.placement.position for o in s.objects] == ["behind"]
    assert "collide" not in [p.action for p in s["E"].spec.phases]
    assert [o.spec.type for o in read("The VUT stops before hitting the pedestrian.").objects] == ["pedestrian"]

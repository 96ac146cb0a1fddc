"""Who is meant: the former and the latter, "its driver", somebody in the other direction; and who is not there."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


def test_who_is_ahead_of_the_lead_is_another(read) -> None:
    s = read("The truck ahead of the lead vehicle is stationary, and the lead vehicle swings out to reveal it.")
    assert [o.spec.type for o in s.objects] == ["car", "truck"] and s["O2"].spec.placement.of == "O1"


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("A lorry approaches the junction from the opposite direction and turns right.", "opposite_approach"),
        ("In the opposite carriageway a truck drives at 60 km/h with a car right behind it.", "oncoming_lane"),
        ("A taxi overtakes a cyclist on a narrow road while ego comes from the opposite direction.", "oncoming_lane"),
        ("At a junction a car waits in the opposite left-turn lane. It turns in front of ego.", "opposite_approach"),
    ],
)
def test_in_the_other_direction(read, text: str, position: str) -> None:
    assert read(text)["O1"].spec.placement.position == position


@pytest.mark.parametrize(
    "text",
    [
        "A car approaches from the opposite direction in ego's lane.",
        "An oncoming car drives in the ego lane.",
    ],
)
def test_met_in_ones_own_lane(read, text: str) -> None:
    place = read(text)["O1"].spec.placement
    assert (place.position, place.facing) == ("ahead", "against")


@pytest.mark.parametrize(
    "text",
    [
        "An oncoming car strays over the centre line into ego's lane.",
        "Ego stays in its lane while an oncoming bus passes.",
    ],
)
def test_met_in_the_other_lane(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "oncoming_lane"


@pytest.mark.parametrize(
    "text",
    [
        "No pedestrians and cyclists are near. Ego drives through the village at 50 km/h.",
    ],
)
def test_nobody_of_a_list_that_is_denied(read, text: str) -> None:
    assert not read(text).objects


@pytest.mark.parametrize(
    "text",
    [
        "A truck from the left is not required to yield at the junction.",
    ],
)
def test_what_one_need_not_do_is_no_offence(read, text: str) -> None:
    assert acts(read(text)["O1"]) == ["go_straight"]


def test_sideways_overlap_is_no_crossing(read) -> None:
    s = read("The VUT drives at 50 km/h towards a stationary GVT with a lateral overlap of 50 %.")
    assert s["O1"].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    ("text", "positions"),
    [
        ("A cyclist rides in the left lane, another in the right lane.", ["left_lane", "right_lane"]),
        ("A pedestrian is on the left. Ego drives at 30 km/h.", ["roadside"]),
    ],
)
def test_beside_ego(read, text: str, positions: list[str]) -> None:
    assert [o.spec.placement.position for o in read(text).objects] == positions


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The pushy driver close behind the ego, in a pickup, runs into its rear end.", "truck"),
        ("The driver behind us in a van hits our rear.", "van"),
    ],
)
def test_the_driver_behind(read, text: str, kind: str) -> None:
    spec = read(text)["O1"].spec
    assert (spec.type, spec.placement.position, acts(read(text)["O1"])) == (kind, "behind", ["collide"])


def test_she_is_the_woman(read) -> None:
    s = read(
        "The autonomous car turns left. A sedan trails close behind it, its driver annoyed. A woman walks across the "
        "street. The car goes on after she has reached the other pavement."
    )
    assert s["O1"].spec.placement.position == "behind"


def test_one_on_either_side_of_ego(read) -> None:
    s = read("Ego follows a truck, with one car keeping pace on its left and another one on its right.")
    assert [o.spec.placement.position for o in s.objects] == ["ahead", "left_lane", "right_lane"]
    s = read("A van tailgates the AV, whips out into the left lane, overtakes and dives back in right ahead of the AV.")
    assert s["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize(
    ("text", "oncoming"),
    [
        ("Ego drives on a road with two lanes each way and a median between them.", False),
        ("The carriageways are separated by a barrier. Ego follows a car.", False),
        ("Ego drives on a road without a median.", None),
    ],
)
def test_a_median(read, text: str, oncoming: bool | None) -> None:
    assert read(text)["R"].spec.oncoming is oncoming


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("The vehicle ahead brakes. Ego follows at 50 km/h.", "brake"),
        ("Ego drives at 50 km/h. The vehicle ahead stops.", "stop"),
        ("Without any warning the car in front stops.", "stop"),
    ],
)
def test_the_vehicle_ahead_is_not_ego(read, text: str, action: str) -> None:
    s = read(text)
    assert acts(s["O1"]) == [action] and action not in acts(s["E"])


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("The other vehicle, a white van, was 30 ft ahead.", "ahead"),
        ("The car behind is only one car length away.", "behind"),
        ("With a gap of just 8 m to the vehicle in front, the ego vehicle travels at 90 km/h.", "ahead"),
        ("Beyond the crosswalk, a bus is waiting at a stop.", "parked"),
        ("At a distance of 60 m from the crosswalk ego sees a child on the left-hand pavement.", "sidewalk"),
    ],
)
def test_the_only_other_one(read, text: str, position: str) -> None:
    s = read(text)
    assert len(s.objects) == 1 and s["O1"].spec.placement.position == position


def test_comes_towards_ego(read) -> None:
    place = read("A van comes towards ego at 40 km/h in the middle of a narrow road.")["O1"].spec.placement
    assert (place.position, place.facing) == ("ahead", "against")
    s = read("The car behind the lorry pulls out to overtake it just as ego approaches from the other side.")
    assert s["O1"].spec.placement.position == "oncoming_lane"


def test_how_far_from_the_crosswalk_is_no_gap(read) -> None:
    s = read("At a distance of 60 m from the crosswalk ego sees a child on the left-hand pavement.")
    assert (s["O1"].spec.placement.gap, s["O1"].spec.placement.side) == (None, "left")


def test_the_one_on_the_right(read) -> None:
    s = read("Two pedestrians stand at the crossing. The one on the right steps out.")
    assert [acts(o) for o in s.objects] == [["stationary"], ["cross_road"]]
    assert s["O2"].spec.placement.side == "right"


def test_pulls_out_of_a_side_road(read) -> None:
    s = read("Ego approaches a T-junction. A tractor waits on the side road on the right. It pulls out.")
    assert (s["O1"].spec.placement.position, acts(s["O1"])) == ("crossing_right", ["turn_left"])

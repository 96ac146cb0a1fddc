"""One step of what somebody does is another, later, or left out; the other steps stay."""

import pytest

from tests.interpret.demanded import changed

TRUCK = (
    "Ego drives at 90 km/h on a three-lane motorway. A truck ahead of ego changes to the left lane after 3 s. "
    "Then it changes to the right lane again after 6 s. A car follows ego."
)
CAR = "Ego follows a car at 60 km/h. The car brakes, then accelerates, then brakes again and stops."
CUTS = "Ego drives at 50 km/h. A car overtakes ego and cuts in."


def phases(s) -> list[str]:
    return [
        f"{p.action}{f' {p.side}' if p.side else ''}{f' {p.duration:g} s' if p.duration else ''}"
        f"{f' at {p.trigger.value:g}' if p.trigger else ''}"
        for p in s["O1"].spec.phases
    ]


FIRST, SECOND = "cut_out left at 3", "cut_in right at 6"


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("wait 2 s more before the second lane change", [FIRST, "cut_in right at 8"]),
        ("the second lane change 2 s later", [FIRST, "cut_in right at 8"]),
        ("the last lane change should come 1 s sooner", [FIRST, "cut_in right at 5"]),
        ("delay the first lane change by 1 s", ["cut_out left at 4", SECOND]),
        ("the truck should wait longer before it goes back", [FIRST, "cut_in right at 8"]),
        ("the second lane change should be after 9 s", [FIRST, "cut_in right at 9"]),
        ("skip the second lane change", [FIRST]),
        ("only one lane change", [FIRST]),
        ("the truck brakes in between", [FIRST, "brake", SECOND]),
        ("make the truck brake before the second lane change", [FIRST, "brake", SECOND]),
        ("the truck brakes after the second lane change", [FIRST, SECOND, "brake"]),
    ],
)
def test_lane_changes(read, text: str, steps: list[str]) -> None:
    s = changed(read(TRUCK), text)
    assert phases(s) == steps
    assert s["R"].spec.lanes == 3


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("the second braking a bit later", ["brake", "accelerate", "keep_lane 2 s", "stop"]),
        ("delay the acceleration by 3 s", ["brake", "keep_lane 3 s", "accelerate", "stop"]),
        ("remove the second brake", ["brake", "accelerate"]),
        ("skip the acceleration", ["brake", "stop"]),
    ],
)
def test_braking_and_going_on(read, text: str, steps: list[str]) -> None:
    assert phases(changed(read(CAR), text)) == steps


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("the car brakes after cutting in", ["overtake", "cut_in right", "brake"]),
        ("the cut-in 3 s later", ["overtake", "keep_lane 3 s", "cut_in right"]),
        ("the overtaking 3 s later", ["overtake at 3", "cut_in right"]),
    ],
)
def test_one_of_two(read, text: str, steps: list[str]) -> None:
    assert phases(changed(read(CUTS), text)) == steps


def test_the_harder_one_is_the_last(read) -> None:
    rates = [p.rate for p in changed(read(CAR), "make the last brake harder")["O1"].spec.phases]
    assert rates[0] is None
    assert rates[-1] > 3.0


def test_a_wait_before_the_only_turn_is_a_wait(read) -> None:
    s = read("Ego approaches an intersection at 40 km/h and turns right. A bus comes from the left.")
    steps = changed(s, "ego should wait for 3 seconds before turning")["E"].spec.phases
    assert "wait" in [p.action for p in steps]


def test_a_lane_change_is_no_lane(read) -> None:
    s = changed(read(TRUCK), "two lanes")
    assert s["R"].spec.lanes == 2
    assert phases(s) == [FIRST, SECOND]


BACK = "Ego drives at 80 km/h on a motorway. A truck in the right lane beside ego drifts into ego's lane."


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("the truck comes back to its lane afterwards", ["lane_change right"]),
        ("the truck goes back again after 8 s", ["lane_change right at 8"]),
        ("truck returns to the right lane 3 s later", ["keep_lane 3 s", "lane_change right"]),
        ("the truck moves back into its own lane", ["lane_change right"]),
    ],
)
def test_back_to_its_lane(read, text: str, steps: list[str]) -> None:
    s = read(BACK)
    assert phases(changed(s, text)) == [*phases(s), *steps]


def test_who_is_hidden_by_a_new_one_that_stands_on_his_side(read) -> None:
    s = read("Ego drives at 25 km/h. A man steps out from behind a bus on the left.")
    now = changed(s, "a van parked in front of him so he can't be seen")
    assert now["O2"].spec.placement.hidden_by == "O3"
    assert now["O3"].spec.placement.side == "left"


def test_who_comes_out_on_the_other_side_is_hidden_by_those_there(read) -> None:
    s = read(
        "On a one-way street with parked cars on both sides, ego drives at 25 km/h. "
        "A man steps out between two parked cars on the left."
    )
    place = changed(s, "he steps out on the right")["O3"].spec.placement
    assert (place.side, place.hidden_by) == ("right", "O2")

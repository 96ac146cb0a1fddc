"""What testers' notes, tickets and lessons leave to the reader: traffic in a lane, signals, edges, who catches up."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "light"),
    [
        ("Ego approaches a signal at 70 km/h which turns yellow when ego is 55 m away.", "yellow"),
        ("The signal changes to red while ego is 30 m before the stop line.", "red"),
    ],
)
def test_a_signal_is_a_traffic_signal(read, text: str, light: str) -> None:
    s = read(text)
    assert (s.settings.spec.light, s.place.spec.control) == (light, "signal")


def test_who_gives_a_signal_is_at_no_light(read) -> None:
    s = read("A van gives a signal and changes to the left lane ahead of ego.")
    assert s.place.spec.control is None and s.settings.spec.light is None


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("Oncoming lane occupied by a convoy of three cars. Ego wants to pass a pallet in its lane.", "oncoming_lane"),
    ],
)
def test_who_fills_a_lane(read, text: str, position: str) -> None:
    assert position in [o.spec.placement.position for o in read(text).objects]


@pytest.mark.parametrize("text", ["Ego closes in on a taxi.", "Ego catches up with a taxi."])
def test_whom_ego_catches_up_with_is_ahead(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    "text",
    ["Ego 60 km/h, a cyclist ahead on the right edge.", "A cyclist rides along the right-hand edge ahead of ego."],
)
def test_who_is_at_the_edge(read, text: str) -> None:
    at = read(text)["O1"].spec.placement
    assert (at.position, at.side) == ("partly_in_lane", "right")


@pytest.mark.parametrize(
    "text",
    [
        "The learner driver approaches a zebra crossing. A woman is waiting on the left.",
    ],
)
def test_who_learns_to_drive_is_ego(read, text: str) -> None:
    assert [o.spec.type for o in read(text).objects] == ["pedestrian"]


def test_a_pupil_on_foot_is_a_child(read) -> None:
    assert read("A pupil runs across the road in front of ego.")["O1"].spec.type == "child"


def test_how_a_child_moves_is_no_step_of_its_own(read) -> None:
    s = read("Child (running, 5 km/h) comes out from behind two parked cars on the nearside. VUT 20 to 60 km/h.")
    assert acts(s["O2"]) == ["cross_road"]
    s = read("Pedestrian at a zebra. Ego 30 km/h. The pedestrian starts walking when ego is 25 m away and crosses.")
    assert any(p.trigger is not None and p.trigger.value == 25 for p in s["O1"].spec.phases)
    s = read("A boy is running along the pavement and then crosses the road.")
    assert acts(s["O1"]) == ["move_along", "cross_road"]


def test_who_goes_right_out_of_the_left_lane_changes_lanes(read) -> None:
    s = read("Ego is on the left lane at 130. It can only go right, where a truck is driving with 85.")
    assert acts(s.ego) == ["lane_change"] and s.place.spec.kind != "intersection"
    assert acts(read("Ego is in the left lane and goes right at the junction.").ego) == ["turn_right"]

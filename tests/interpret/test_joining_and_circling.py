"""Roundabouts and ramps, lights that are on, numbers without a unit, who runs after what."""

import pytest


@pytest.mark.parametrize("how", ["high beams", "headlights", "hazard lights", "indicator"])
def test_lights_that_are_on_do_not_hide_the_verb(read, how: str) -> None:
    s = read(f"An oncoming car with its {how} on turns left in front of the ego.")
    assert [p.action for p in s["O1"].spec.phases] == ["turn_left"]


@pytest.mark.parametrize(
    "text",
    [
        "At the roundabout the ego yields to a motorcycle already circulating.",
        "Ego enters a roundabout in which a van is already circulating.",
        "Ego approaches a roundabout; a truck is already in the roundabout and ego gives way to it.",
    ],
)
def test_who_circles_comes_from_the_left(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "crossing_left"


@pytest.mark.parametrize("ahead", ["in front of a truck", "ahead of a lorry", "just before a bus"])
def test_ego_joins_ahead_of_who_is_on_the_motorway(read, ahead: str) -> None:
    place = read(f"Ego joins the motorway from the on-ramp {ahead}.")["O1"].spec.placement
    assert (place.position, place.along) == ("left_lane", "behind")


def test_a_speed_set_off_by_a_comma(read) -> None:
    s = read("A tractor creeps along at 20 km/h; ego, at 75, has to brake sharply.")
    assert s.ego.spec.speed == pytest.approx(75 / 3.6, abs=0.1)


def test_what_is_left_of_a_gap_is_no_stop(read) -> None:
    s = read("A minibus in the left lane comes over, leaving only 6 m.")
    assert [p.action for p in s["O1"].spec.phases] == ["cut_in"] and s["O1"].spec.placement.gap == 6.0


@pytest.mark.parametrize(
    "text",
    ["A ball rolls onto the road and a child runs after it.", "A dog runs onto the road and a boy follows it."],
)
def test_who_runs_after_it_is_on_the_road_too(read, text: str) -> None:
    assert [p.action for p in read(text).objects[-1].spec.phases] == ["cross_road"]

"""Crossings on foot, signals in other words, and who is in which arm of a junction."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "Ego must stop before the crossing because a boy walks across.",
        "Four children cross. Ego stops 3 m before the crossing.",
        "A mother with a pram waits at the crossing; ego slows down.",
    ],
)
def test_people_at_a_crossing_make_it_a_crosswalk(read, text: str) -> None:
    road = read(text)["R"].spec
    assert (road.kind, road.crosswalk) == ("crosswalk", True)


@pytest.mark.parametrize(
    "text",
    [
        "Ego turns left at the crossing while a pedestrian crosses the side road.",
        "At the crossing a van comes from the left. Ego brakes.",
        "Ego stops at the level crossing. A man walks across the road.",
        "A man is crossing the road. Ego stops.",
    ],
)
def test_other_crossings_are_no_crosswalks(read, text: str) -> None:
    assert read(text)["R"].spec.crosswalk is None


def test_signals_that_are_out_and_signals_ahead(read) -> None:
    assert read("With the traffic lights out, a pickup from the right does not stop.")["R"].spec.control == "none"
    changing = read("The light ahead goes from green to red; ego stops behind a bus.")
    assert changing["G"].spec.light == "red"
    assert (changing["R"].spec.kind, changing["R"].spec.control) == ("intersection", "signal")
    assert read("Ego approaches a give-way; a van comes from the left.")["R"].spec.control == "yield"
    assert read("EB van stopped at sign, then pulls out. Ego is SB.")["R"].spec.control == "stop"


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("Ego and a van arrive at a four-way stop, the van on ego's right. Ego lets it go.", "crossing_right"),
        ("A car waiting at the yield sign on the left pulls out in front of ego.", "crossing_left"),
    ],
)
def test_who_is_on_one_side_at_a_junction_is_in_another_arm(read, text: str, where: str) -> None:
    structure = read(text)
    assert structure.objects[0].spec.placement.position == where
    assert structure["R"].spec.lanes is None


@pytest.mark.parametrize(
    "text",
    [
        "Ego waits at the red light and there is a motorcycle to its left.",
    ],
)
def test_who_waits_beside_ego_is_in_the_next_lane(read, text: str) -> None:
    structure = read(text)
    assert structure.objects[0].spec.placement.position == "left_lane"
    assert structure["R"].spec.lanes == 2


def test_a_cyclist_on_the_crosswalk_crosses(read) -> None:
    bike = read("Ego turns right and yields to a bike in the crosswalk.").objects[0].spec
    assert bike.placement.position == "intersection_exit"
    assert [p.action for p in bike.phases] == ["cross_road"]


def test_who_keeps_circling_comes_from_the_left(read) -> None:
    structure = read("A car in the roundabout keeps circling and ego, entering, has to brake.")
    assert structure.objects[0].spec.placement.position == "crossing_left"

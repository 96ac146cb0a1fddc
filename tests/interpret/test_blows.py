"""Blows of crash reports: in what order, in whose lane, beside whom, backwards, over the middle of the road."""

import pytest


def actions(spec) -> list[str]:
    return [p.action for p in spec.phases]


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("V1 was turning left at the light when it struck V2.", "turn_left"),
        ("V1 was changing lanes to the right when it struck V2.", "lane_change"),
        ("V1 was backing out of a driveway when it struck V2, which was driving past.", "reverse"),
    ],
)
def test_what_it_was_doing_comes_before_the_blow(read, text: str, first: str) -> None:
    assert actions(read(text).ego.spec) == [first, "collide"]


@pytest.mark.parametrize(
    ("text", "lane"),
    [
        ("V1 hit the rear of a truck that was stopped in the right lane.", "rightmost"),
        ("A truck was standing in the left lane. V1 rammed into it.", "leftmost"),
        ("V2 was stopped in the left lane of the interstate. V1 ran into it.", "leftmost"),
    ],
)
def test_who_runs_into_what_stands_is_in_its_lane(read, text: str, lane: str) -> None:
    s = read(text)
    assert s.place.spec.ego_lane == lane and s["O1"].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    "text",
    [
        "V1 was going straight when V2 changed lanes to the right and sideswiped it.",
        "V1 was in the left lane. V2, in the right lane, merged at the last moment and sideswiped V1.",
        "V2, in the left lane, changed lanes and sideswiped V1.",
    ],
)
def test_who_comes_over_beside_ego_does_not_pass_it(read, text: str) -> None:
    s = read(text)
    assert actions(s["O1"].spec) == ["cut_in", "collide"] and s["O1"].spec.speed == s.ego.spec.speed


def test_backwards_into_another(read) -> None:
    s = read("V1 rolled backward into V2, which was stopped behind it.")
    assert actions(s.ego.spec) == ["reverse", "collide"] and s["O1"].spec.placement.position == "behind"


def test_a_rear_door_is_a_side(read) -> None:
    s = read("The AV crossed the intersection when a pickup ran the red light and struck the AV's left rear door.")
    assert s["O1"].spec.placement.position == "crossing_left"


@pytest.mark.parametrize(
    "text",
    [
        "A pedestrian was walking in the roadway with traffic. V1 struck him.",
        "Two men were walking on the road ahead of V1. V1 hit one of them.",
        "A man was walking in the street. V1 hit him.",
    ],
)
def test_on_foot_in_the_road(read, text: str) -> None:
    assert actions(read(text)["O1"].spec) == ["move_along"]


def test_across_the_highway(read) -> None:
    s = read("A flatbed was crossing the highway from a farm road. V1 hit its side.")
    assert s.place.spec.kind == "intersection" and s["O1"].spec.placement.position.startswith("crossing")


def test_already_on_the_roundabout(read) -> None:
    s = read("V1 entered the roundabout and was struck by V2, which was already in it.")
    assert s["O1"].spec.placement.position == "crossing_left"


def test_waiting_for_a_space_is_not_parked(read) -> None:
    assert (
        read("V2 stopped to wait for a parking space. V1 ran into its rear.")["O1"].spec.placement.position == "ahead"
    )


@pytest.mark.parametrize(
    "text",
    [
        "V3 stopped and V2 stopped behind it. V1 struck the back of V2, and V2 was pushed into the back of V3.",
        "V2 stopped behind V3. V1 ran into the rear of V2, which was pushed into V3.",
        "Unit 2 was stopped behind Unit 3. Unit 1 hit the rear of Unit 2. Unit 2 was pushed into the rear of Unit 3.",
    ],
)
def test_who_is_only_pushed_on_stands(read, text: str) -> None:
    s = read(text)
    v2 = next(o for o in s.objects if o.spec.name == "v2")
    assert actions(v2.spec)[:1] in (["stop"], ["stationary"]) and "collide" not in actions(v2.spec)
    assert s.ego.spec.phases[-1].target == v2.id

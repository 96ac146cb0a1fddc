"""Who gets past somebody unnamed, who tips over, who steers where no junction is, what is not let happen."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "done"),
    [
        ("The bus ahead overtakes.", ["cut_out"]),
        ("The ego has to wait as the car in front moves out to overtake as well.", ["cut_out"]),
        ("The cyclist ahead swerves left around an opening car door.", ["swerve"]),
    ],
)
def test_who_is_ahead_does_not_overtake_ego(read, text: str, done: list[str]) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("ahead", done)


@pytest.mark.parametrize(
    "text",
    [
        "A van rolls over in front of the ego.",
        "The truck ahead of ego tips onto its side.",
        "The car in front of the ego flips over.",
    ],
)
def test_who_tips_over_loses_control(read, text: str) -> None:
    assert actions(read(text).objects[0]) == ["lose_control"]


@pytest.mark.parametrize(
    "text",
    [
        "The ego reacts by braking and steering to the left.",
        "A box lies in the lane; ego steers left.",
        "Ego steers to the left because a dog stands in the lane.",
    ],
)
def test_who_steers_aside_where_no_junction_is_swerves(read, text: str) -> None:
    structure = read(text)
    assert "swerve" in actions(structure["E"]) and structure.place.spec.kind != "intersection"


@pytest.mark.parametrize(
    "text",
    [
        "The ego runs a yellow light and a left-turning car hits it.",
        "A left-turning van hits the ego at the junction.",
        "At the lights ego goes straight on and a left-turning taxi collides with it.",
    ],
)
def test_a_left_turning_car_turns_before_it_hits(read, text: str) -> None:
    spec = read(text).objects[0].spec
    assert (spec.placement.position, [p.action for p in spec.phases]) == ("opposite_approach", ["turn_left", "collide"])


def test_who_is_not_let_merge_does_not(read) -> None:
    s = read("The ego is on the on-ramp and a truck in the right lane does not let it merge.")
    assert actions(s.objects[0]) == []


def test_who_brakes_too_late_behind_hits_ego(read) -> None:
    s = read("A truck behind the ego brakes too late and ego is hit from behind.")
    assert actions(s["E"]) == []
    assert actions(s.objects[0]) == ["brake", "collide"] and len(s.objects) == 1

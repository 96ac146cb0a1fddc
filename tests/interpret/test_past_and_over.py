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
        "The ego reacts by braking and steering to the left.",
        "A box lies in the lane; ego steers left.",
        "Ego steers to the left because a dog stands in the lane.",
    ],
)
def test_who_steers_aside_where_no_junction_is_swerves(read, text: str) -> None:
    structure = read(text)
    assert "swerve" in actions(structure["E"]) and structure.place.spec.kind != "intersection"


def test_who_is_not_let_merge_does_not(read) -> None:
    s = read("The ego is on the on-ramp and a truck in the right lane does not let it merge.")
    assert actions(s.objects[0]) == []

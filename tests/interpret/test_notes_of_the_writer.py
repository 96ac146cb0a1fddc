"""Notes without a subject tell what their writer did; participles before a clause about somebody else are ego's."""

import pytest


def actions(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Lost control on a wet bend, left the road to the right and hit a tree.", ["leave_road", "collide"]),
        ("Crossed the centre line and collided with an oncoming lorry.", ["oncoming", "collide"]),
        ("Changed lanes to the left and hit a car in the blind spot.", ["lane_change", "collide"]),
        ("Ran off the road to the right and struck a guardrail.", ["leave_road", "collide"]),
    ],
)
def test_a_note_without_subject_is_of_ego(read, text: str, expected: list[str]) -> None:
    assert actions(read(text)["E"]) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("While reversing, a child was struck.", ["reverse", "collide"]),
        ("Having stopped at the lights, a car ran into the back of me.", ["stop"]),
        ("After turning right, a pedestrian crosses in front of the ego.", ["turn_right"]),
    ],
)
def test_a_participle_that_the_subject_cannot_do_is_egos(read, text: str, expected: list[str]) -> None:
    assert actions(read(text)["E"]) == expected

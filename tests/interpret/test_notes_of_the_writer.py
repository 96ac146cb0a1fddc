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


def test_who_was_hit_did_not_do_what_the_note_tells(read) -> None:
    structure = read("Going straight on, braked for a cat, was hit from behind by a van.")
    assert structure["E"].spec.reaction == "brake"
    assert actions(structure.objects[1]) == ["collide"]


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


def test_who_stands_behind_the_verb(read) -> None:
    spec = read("Parked on the left was a van.").objects[0].spec
    assert (spec.placement.position, spec.placement.side) == ("parked", "left")

"""Verbs behind a relative clause that go on with the clause before it."""

import pytest


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("V1 was following a van that was braking for a light and struck it in the rear.", ["follow", "collide"]),
    ],
)
def test_ego_goes_on_with_what_the_clause_told_of(read, text: str, actions: list[str]) -> None:
    s = read(text)
    assert [(p.action, p.target) for p in s.ego.spec.phases] == [(a, "O1") for a in actions]
    assert len(s.objects) == 1


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives behind a car that overtakes a cyclist and hits him.",
        "A bus follows a car that passes ego and hits it.",
        "Ego waits for a van that reaches a cyclist and overtakes him.",
    ],
)
def test_who_meets_another_in_the_relative_clause_goes_on_with_that(read, text: str) -> None:
    s = read(text)
    assert not {"overtake", "collide"} & {p.action for p in s.ego.spec.phases}

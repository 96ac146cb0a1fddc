"""Verbs behind a relative clause that go on with the clause before it."""

import pytest


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("Ego follows a tractor that is going at 25 km/h and overtakes it.", ["follow", "overtake"]),
        ("Ego approaches a cyclist who wears a helmet and passes him.", ["overtake"]),
        ("V1 was following a van that was braking for a light and struck it in the rear.", ["follow", "collide"]),
        ("Ego sees a dog that runs onto the road and hits it.", ["collide"]),
        ("Ego follows a tractor that is pulling a hay wagon and overtakes it.", ["follow", "overtake"]),
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

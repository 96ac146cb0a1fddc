"""Verbs that only begin or bring about a deed leave its time and its doer as they are."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter

BEGUN = (
    "begins to {b}",
    "starts {g}",
    "suddenly starts to {b}",
    "proceeds to {b}",
    "decides to {b}",
    "has to {b}",
    "is about to {b}",
    "initiates {g}",
    "commences {g}",
    "ends up {g}",
    "will {b}",
    "would {b}",
)
DEEDS = (
    ("the car ahead", "brake", "brakes", "braking"),
    ("a car in the left lane", "cut in in front of ego", "cuts in in front of ego", "cutting in in front of ego"),
    ("a pedestrian on the right", "cross the road", "crosses the road", "crossing the road"),
)
WHEN = (
    "After ten seconds {}.",
    "When ego is 20 m away, {}.",
    "Ten seconds later {}.",
    "As soon as ego is within 20 m, {}.",
    "Ego drives at 50 km/h and after ten seconds {}.",
)


def phases(text: str) -> list[list[tuple[str, object]]]:
    structure = EmbeddedInterpreter().interpret(text[0].upper() + text[1:]).structure
    return [[(p.action, p.trigger) for p in o.spec.phases] for o in structure.objects]


@pytest.mark.parametrize("begun", BEGUN)
@pytest.mark.parametrize(("who", "bare", "does", "doing"), DEEDS)
def test_the_deed_keeps_its_time(who: str, bare: str, does: str, doing: str, begun: str) -> None:
    said = begun.format(b=bare, g=doing)
    for when in WHEN:
        plain = phases(when.format(f"{who} {does}"))
        assert plain[-1][-1][1] is not None
        assert phases(when.format(f"{who} {said}")) == plain, when.format(f"{who} {said}")


def test_what_would_happen_on_a_condition_does_not_happen() -> None:
    assert phases("A car drives ahead of ego. If ego did not brake, it would stop.") == [[]]
    assert phases("A car drives ahead of ego. It would have stopped.") == [[]]

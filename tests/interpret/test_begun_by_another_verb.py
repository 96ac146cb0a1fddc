"""Verbs that only begin or bring about a deed leave its time and its doer as they are."""

from c2s_engine.interpret import EmbeddedInterpreter


def phases(text: str) -> list[list[tuple[str, object]]]:
    structure = EmbeddedInterpreter().interpret(text[0].upper() + text[1:]).structure
    return [[(p.action, p.trigger) for p in o.spec.phases] for o in structure.objects]


def test_what_would_happen_on_a_condition_does_not_happen() -> None:
    assert phases("A car drives ahead of ego. If ego did not brake, it would stop.") == [[]]
    assert phases("A car drives ahead of ego. It would have stopped.") == [[]]

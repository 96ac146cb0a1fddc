"""Lanes and roads that are closed, in the words people have for it."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


def types(text: str) -> set[str]:
    return {o.spec.type for o in EmbeddedInterpreter().interpret(text).structure.objects}


@pytest.mark.parametrize(
    "text",
    [
        "One lane is closed because of maintenance work.",
        "One of the lanes is shut.",
        "The lane ahead is blocked off due to road works.",
        "Ego drives at 50 km/h; the lane is barricaded.",
    ],
)
def test_a_lane_is_closed(text: str) -> None:
    assert types(text) == {"lane_closure"}


def test_what_closes_it_where_it_is_told() -> None:
    assert types("The right lane is closed for roadworks and ego merges left.") == {"construction_zone"}
    assert types("The road ahead is closed. Ego has to turn around.") == {"barrier"}
    assert types("The lane is closed to trucks. Ego follows a van.") == {"van"}

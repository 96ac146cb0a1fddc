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

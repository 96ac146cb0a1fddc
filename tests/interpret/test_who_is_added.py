"""Somebody or something new, told in a hurry: signs, what is missing, and who has no article."""

import pytest

from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

SCENE = "Ego drives at 80 km/h on a country road. A cyclist rides 60 m ahead. A car comes towards ego."


def added(before: Structure, text: str):
    turn = route(text, before)
    assert turn.kind == "edit" and turn.edits, turn
    now = before
    for edit in turn.edits:
        now = apply(now, edit)
    new = [cid for cid in now.ids if cid not in before]
    assert len(new) == 1 and all(now[cid].spec == before[cid].spec for cid in before.ids if cid != "R")
    return now[new[0]].spec


@pytest.mark.parametrize(
    ("text", "limit", "side"),
    [
        ("need a 70 speed sign on the right roadside", 19.44, "right"),
        ("put up a speed limit sign of 30 km/h", 8.33, "right"),
    ],
)
def test_speed_signs(read, text: str, limit: float, side: str) -> None:
    spec = added(read(SCENE), text)
    assert spec.type == "speed_sign" and spec.limit == pytest.approx(limit, abs=0.01) and spec.placement.side == side


def test_other_signs(read) -> None:
    assert added(read(SCENE), "add a stop sign").type == "stop_sign"
    assert added(read(SCENE), "set up a warning sign 30 m ahead").placement.gap == 30


@pytest.mark.parametrize(
    ("text", "kind", "position"),
    [
        ("it misses a van behind ego", "van", "behind"),
        ("we still need a van behind us", "van", "behind"),
        ("dog runs out from the right", "animal", "roadside"),
    ],
)
def test_who_is_missing(read, text: str, kind: str, position: str) -> None:
    spec = added(read(SCENE), text)
    assert (spec.type, spec.placement.position) == (kind, position)

"""How fast somebody is to be, in the words of those who test: m/s."""

import pytest

from c2s_engine.interpret.turn import route
from c2s_engine.structure.edits import apply

SCENE = "Ego follows a bus at 54 km/h. The bus drives at 45 km/h and a girl crosses from the right at 5 km/h."


@pytest.mark.parametrize(
    ("text", "cid", "speed"),
    [
        ("ego drives at most 36", "E", 10.0),
        ("bus at 36", "O1", 10.0),
        ("speed up ego by 18 km/h", "E", 20.0),
        ("take 9 km/h off the bus", "O1", 10.0),
        ("add 9 km/h to the speed of the bus", "O1", 15.0),
        ("ego 20 percent slower", "E", 12.0),
        ("half the speed for ego", "E", 7.5),
        ("ego a bit faster", "E", 16.8),
        ("the bus drives at the same speed as ego", "O1", 15.0),
        ("the bus is 18 km/h slower than ego", "O1", 10.0),
        ("the girl runs", "O2", 2.8),
        ("ego should be going 72 km/h, not 54", "E", 20.0),
    ],
)
def test_how_fast(read, text: str, cid: str, speed: float) -> None:
    before = after = read(SCENE)
    for edit in route(text, before).edits:
        after = apply(after, edit)
    assert after[cid].spec.speed == pytest.approx(speed, abs=0.06)
    assert all(after[c].spec == before[c].spec for c in before.ids if c != cid)


def test_both(read) -> None:
    structure = read(SCENE)
    for edit in route("lower the speeds of both vehicles to 36 km/h", structure).edits:
        structure = apply(structure, edit)
    assert [structure[c].spec.speed for c in ("E", "O1")] == [10.0, 10.0]

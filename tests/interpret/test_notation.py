"""Shorthand and tables: what they are spelt out to, and the scene that is read from them."""

from typing import Any

import pytest

from c2s_engine.interpret.reading import notation
from c2s_engine.interpret.reading.rewritten import Rewritten
from c2s_engine.structure.components import Structure


def signs(text: str) -> str:
    return Rewritten(text, notation.signs(text)).text


def spec(structure: Structure, cid: str) -> Any:
    return structure[cid].spec


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("car ahead -> brakes", "car ahead. brakes"),
        ("ego 50 / van 60", "ego 50. van 60"),
        ("at 50 km / h", "at 50 km / h"),
        ("van w/ trailer w/o lights", "van with trailer without lights"),
        ("suv R lane +15m", "suv right lane 15 m ahead"),
        ("v_ego = 50 km/h, dx = 20 m", "ego speed 50 km/h, gap 20 m"),
        ("northbound in the southbound lanes", "the wrong way in the opposite lane"),
    ],
)
def test_signs_become_words(text: str, words: str) -> None:
    assert signs(text) == words


def test_a_table_is_read_row_by_row(read) -> None:
    s = read(
        "| Field | Value |\n|---|---|\n| Weather | fog |\n| Ego speed | 40 km/h |\n| Actor | cyclist |\n"
        "| Actor position | right side, 25 m ahead |\n| Actor action | swerves left |\n| Ego reaction | brakes |"
    )
    assert spec(s, "G").weather == ("fog",)
    assert spec(s, "E").reaction == "brake" and round(spec(s, "E").speed * 3.6) == 40
    assert spec(s, "O1").type == "bicycle" and spec(s, "O1").placement.gap == 25
    assert spec(s, "O1").placement.side == "right"


def test_notes_in_bare_commas_have_each_their_own_subject(read) -> None:
    s = read("bus ahead 30, ego 50, van on left lane 70, bus brakes hard")
    found = {c.spec.type: c.spec for c in s.objects}  # type: ignore[union-attr]
    assert set(found) == {"bus", "van"}
    assert [p.action for p in found["bus"].phases] == ["brake"] and not found["van"].phases  # type: ignore[union-attr]
    assert found["van"].placement.position == "left_lane"  # type: ignore[union-attr]


def test_one_colon_makes_no_table() -> None:
    assert notation.fields("Note: the car brakes.") == []

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


def test_one_colon_makes_no_table() -> None:
    assert notation.fields("Note: the car brakes.") == []

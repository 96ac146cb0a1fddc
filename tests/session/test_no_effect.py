"""Directions of a change that nobody has whom it moved."""

import pytest

from c2s_engine.interpret.learned.notation import parse
from c2s_engine.interpret.learned.quantities import si
from c2s_engine.report.gather import structure_of
from c2s_engine.session.no_effect import _directions, _negated, _nobody
from c2s_engine.structure.objects import types


def scene(van: str) -> object:
    said = f"R: road\nE: car speed=50km/h\nO1: van {van}\nO2: car at=oncoming_lane"
    return structure_of({"G": {}, "T": {}, **si(parse(said))}, "")


@pytest.mark.parametrize(("text", "van", "named"), [
    ("O1 starts 40 m behind ego", "at=ahead gap=40m", ["behind"]),
    ("O1 starts 40 m behind ego", "at=behind gap=40m", []),
    ("O1 starts 40 m ahead of ego", "at=ahead gap=40m", []),
    ("the one behind the oncoming car waits", "at=ahead gap=12m", []),
])  # fmt: skip
def test_a_direction_that_was_not_taken_is_named(text: str, van: str, named: list[str]) -> None:
    found = _directions(text, scene(van), scene("at=ahead gap=12m"))  # type: ignore[arg-type]
    assert [text[slice(*span)] for span in found] == named


@pytest.mark.parametrize(("text", "named"), [
    ("make it two cyclists", ["cyclists"]), ("the driver brakes", []), ("the van waits for the other rider", []),
])  # fmt: skip
def test_who_rides_or_walks_and_is_nobody_of_s_is_named(text: str, named: list[str]) -> None:
    assert [text[slice(*span)] for span in _nobody(text, types(scene("at=ahead")))] == named  # type: ignore[arg-type]


@pytest.mark.parametrize(("text", "van", "named"), [
    ("the van is a truck and does not brake", "at=ahead ; brake", ["not brake"]),
    ("the van is a truck and doesn't brake", "at=ahead ; brake", ["n't brake"]),
    ("the van is a truck and does not brake", "at=ahead", []),
])  # fmt: skip
def test_what_is_not_to_be_done_and_still_is_is_named(text: str, van: str, named: list[str]) -> None:
    before = scene(van.replace("ahead", "behind"))
    assert [text[slice(*span)] for span in _negated(text, scene(van), before)] == named  # type: ignore[arg-type]

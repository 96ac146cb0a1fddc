"""The last turn corrected: another one, another value, side or type was meant; what only sounds like it is an edit."""

import pytest

from c2s_engine.interpret.turn import PreviousTurn, route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

SCENE = (
    "Ego drives at 50 km/h on a road behind a white car. A red car overtakes ego and cuts in. "
    "A cyclist rides on the right ahead."
)


def twice(before: Structure, first: str, then: str) -> Structure:
    now = before
    for edit in route(first, before).edits:
        now = apply(now, edit)
    for edit in route(then, now, PreviousTurn(first, before)).edits:
        now = apply(now, edit)
    return now


def once(before: Structure, text: str) -> Structure:
    for edit in route(text, before).edits:
        before = apply(before, edit)
    return before


@pytest.mark.parametrize(
    ("first", "then", "meant"),
    [
        ("make the car slower", "no the red one", "make the red car slower"),
        ("make the car slower", "not that one, the cyclist", "make the cyclist slower"),
        ("make the car slower", "I meant ego", "make ego slower"),
        ("remove the red car", "wrong car, the white one", "remove the white car"),
        ("set the white car to 70", "that was the wrong one, do it to the red car", "set the red car to 70"),
        ("the white car at 30 km/h", "sorry, 40", "the white car at 40 km/h"),
        ("the white car brakes after 3 s", "i meant 5 s", "the white car brakes after 5 s"),
        ("the white car changes to the left lane", "no, right", "the white car changes to the right lane"),
        ("make the cyclist slower", "no, faster", "make the cyclist faster"),
        ("make the white car slower", "i meant 5 kph slower", "make the white car 5 kph slower"),
        ("add a truck behind ego", "no, i meant a bus", "add a bus behind ego"),
        ("add a truck behind ego", "no, in front", "add a truck in front of ego"),
        ("add a truck 30 m behind ego", "no, 5 m closer", "add a truck 25 m behind ego"),
        ("add a truck 30 m behind ego", "10 m further away", "add a truck 40 m behind ego"),
    ],
)
def test_what_was_meant(read, first: str, then: str, meant: str) -> None:
    before = read(SCENE)
    specs = [(c.id, c.spec) for c in twice(before, first, then).components]
    assert specs == [(c.id, c.spec) for c in once(before, meant).components]


@pytest.mark.parametrize("then", ["the other car should be a bus", "the red car at 60", "add a van too", "undo"])
def test_no_correction(read, then: str) -> None:
    before = read(SCENE)
    first = route("make the white car slower", before)
    now = before
    for edit in first.edits:
        now = apply(now, edit)
    turn = route(then, now, PreviousTurn("make the white car slower", before))
    assert not turn.corrects
    assert turn == route(then, now)


def test_which_of_several_is_asked(read) -> None:
    before = read(SCENE)
    now = once(before, "make ego slower")
    turn = route("no, the other one", now, PreviousTurn("make ego slower", before))
    assert not turn.edits
    assert "O1, O2, O3" in turn.reply

"""Demands for all of a sort, for both, for two who exchange something: each of them, and nobody else."""

import pytest

from c2s_engine.interpret.turn import route
from tests.interpret.demanded import changed

CARS = (
    "Ego drives at 50 km/h on a road behind a white car. A red car overtakes ego and cuts in. "
    "A cyclist rides on the right ahead."
)
LANES = "Ego drives at 90 km/h on a three-lane motorway. A truck drives ahead in the same lane. A car follows ego."


@pytest.mark.parametrize("text", ["the car overtakes both", "the car overtakes both of us"])
def test_whom_one_overtakes_who_overtakes_both(read, text: str) -> None:
    phases = changed(read(LANES), text)["O2"].spec.phases
    assert [(p.action, p.target) for p in phases] == [("overtake", "ego"), ("overtake", "O1")]


def test_and_then_does_something_else(read) -> None:
    s = changed(read(LANES), "the car overtakes both and cuts in")
    assert [p.action for p in s["O2"].spec.phases] == ["overtake", "overtake", "cut_in"]
    assert s["O1"].spec == read(LANES)["O1"].spec


@pytest.mark.parametrize("text", ["swap the speeds of the two cars"])
def test_speeds_swapped(read, text: str) -> None:
    s = read(CARS)
    now = changed(s, text)
    assert (now["O1"].spec.speed, now["O2"].spec.speed) == (s["O2"].spec.speed, s["O1"].spec.speed)
    assert now["O3"].spec == s["O3"].spec


def test_speeds_that_are_the_same_are_not_swapped(read) -> None:
    turn = route("swap the speeds", read("Ego drives at 50 km/h behind a truck. A bus comes the other way."))
    assert not turn.edits
    assert "the same" in turn.reply


def test_a_share_of_all_speeds(read) -> None:
    s = read(CARS)
    assert changed(s, "increase all speeds by 10 %")["E"].spec.speed == pytest.approx(s["E"].spec.speed * 1.1, abs=0.05)


@pytest.mark.parametrize(
    "text", ["why does the truck not brake?", "why doesn't the car overtake?", "does the car brake"]
)
def test_a_question_is_no_edit(read, text: str) -> None:
    assert route(text, read(LANES)).kind == "question"

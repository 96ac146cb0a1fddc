"""What a turn of the chat is taken for, and what becomes of a correction."""

import math
from pathlib import Path
from typing import Any

import pytest
import yaml

from c2s_engine.interpret.learned import Answer, ReaderError
from c2s_engine.interpret.learned.change import prompt
from c2s_engine.interpret.learned.edits import after
from c2s_engine.interpret.learned.notation import parse
from c2s_engine.interpret.learned.reader import structure_of
from c2s_engine.interpret.turn import PreviousTurn, route
from c2s_engine.structure.components import Structure

TEXT = "Ego drives at 50 km/h. A van ahead brakes, and a child crosses."
SAID = "R: road\nE: car speed=50km/h\nO1: van at=ahead ; brake\nO2: child at=roadside ; cross_road"
SCENE = structure_of(parse(SAID), TEXT)
CASES = yaml.safe_load((Path(__file__).parent / "turns.yaml").read_text(encoding="utf-8"))


class Model:
    """Answers as it is told, by what was typed."""

    def __init__(self, **says: str):
        self.says = says

    def answer(self, asked: str) -> Answer:
        said = next((said for what, said in self.says.items() if asked.endswith(what.replace("_", " "))), "none")
        return Answer(said, 1, 1)


@pytest.mark.parametrize("case", CASES, ids=[c["say"][:50] for c in CASES])
def test_what_a_turn_is_taken_for(monkeypatch: pytest.MonkeyPatch, case: dict[str, Any]) -> None:
    model = Model(**{case["say"].replace(" ", "_"): case["says"]} if "says" in case else {})
    asked = []
    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", lambda: asked.append(1) or model)
    turn = route(case["say"], SCENE)
    assert turn.kind == case["kind"] and turn.reply == case.get("reply", turn.reply)
    assert bool(turn.edits) is (turn.kind == "edit" and "reply" not in case)
    assert bool(asked) is ("says" in case), "the model is asked of changes alone"


@pytest.mark.parametrize(("text", "likely", "asks"), [
    ("remove the second one", 0.9, False), ("remove the second one", 0.5, True), ("remove O2", 0.5, False),
    ("remove the rain", 0.9, True), ("delete the traffic light", 0.9, True), ("no, the other one", 0.9, True),
    ("no, delete the other one", 0.9, False), ("delete it", 0.9, True),
])  # fmt: skip
def test_nobody_is_removed_who_may_not_be_meant(
    monkeypatch: pytest.MonkeyPatch, text: str, likely: float, asks: bool
) -> None:
    class Unsure:
        def answer(self, asked: str) -> Answer:
            return Answer("-O2", 1, 1, (("-O2", math.log(likely)),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Unsure)
    turn = route(text, SCENE)
    assert bool(turn.edits) is not asks
    assert ("Which one is to be removed?" in turn.reply and "example “remove O2”;" in turn.reply) is asks


@pytest.mark.parametrize("text", [
    "Unit 1 was going straight at 30 mph. Unit 2 pulled out of a driveway on the right without looking.",
    "NPC 7 cuts in ahead of ego.", "a pedestrian crosses",
])  # fmt: skip
def test_the_first_text_of_a_session_is_a_scenario_whoever_it_names(text: str) -> None:
    assert route(text, Structure()).kind == route(text, None).kind == "scenario"
    assert route("what is a typology?", None).kind == "question"


def test_a_correction_is_read_with_what_it_corrects_upon_the_scene_before(monkeypatch: pytest.MonkeyPatch) -> None:
    first = "make the van slower"
    told = {"make_the_van_slower": "O1: speed=30km/h", "make_the_van_slower_//_no,_the_child": "O2: speed=3km/h"}
    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", lambda: Model(**told))
    now = after(SCENE, route(first, SCENE).edits)
    turn = route("no, the child", now, PreviousTurn(first, SCENE))
    assert turn.corrects and after(now, turn.edits)["O1"].spec == SCENE["O1"].spec
    assert after(now, turn.edits)["O2"].spec.speed == pytest.approx(0.833)
    again = route("the van is a truck", now, PreviousTurn(first, SCENE))
    assert not again.corrects


def test_where_the_model_cannot_be_asked_that_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def loaded() -> Any:
        raise ReaderError("It is not installed")

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", loaded)
    turn = route("make the van a truck", SCENE)
    assert not turn.edits and turn.reply == "It is not installed. S can be changed in its pane, too."


def test_what_the_planner_chose_is_not_shown_to_the_model() -> None:
    assert prompt(SCENE, "the van\nis a truck").endswith("> the van is a truck")


@pytest.mark.parametrize(("text", "kind"), [
    ("A child runs out between two parked cars on the right, and ego brakes hard for it.", "scenario"),
    ("The child runs out between two parked cars on the right, and ego brakes hard for it.", "edit"),
])  # fmt: skip
def test_a_scene_of_its_own_is_no_change_of_which_the_model_is_not_sure(
    monkeypatch: pytest.MonkeyPatch, text: str, kind: str
) -> None:
    class Guesses:
        def answer(self, asked: str) -> Answer:
            return Answer("O2: ; cross_road ; stop", 1, 1, (("O2", -0.9),))

    monkeypatch.setattr("c2s_engine.interpret.learned.change.loaded", Guesses)
    assert route(text, SCENE).kind == kind

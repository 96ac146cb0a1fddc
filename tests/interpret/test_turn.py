"""Turns upon S: what they are taken for, and that edits touch only what was meant."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import pytest

from c2s_engine.interpret import InterpreterFault
from c2s_engine.interpret.turn import Turn, route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField, apply
from c2s_engine.structure.specs import Condition


@pytest.fixture(scope="module")
def scene(request) -> Structure:
    read = request.getfixturevalue("read")
    return read(
        "In rain, the lead car brakes hard 30 m ahead of ego on a straight road, and a pedestrian crosses from the right."
    )


def after(turn: Turn, structure: Structure) -> Structure:
    for edit in turn.edits:
        structure = apply(structure, edit)
    return structure


def changed(before: Structure, now: Structure) -> set[str]:
    both = [c.id for c in now.components if c.id in before]
    return {c for c in both if before[c].spec != now[c].spec} | (set(before.ids) ^ set(now.ids))


@pytest.mark.parametrize(
    ("text", "component", "path", "value"),
    [
        ("make the lead a truck", "O1", "type", "truck"), ("remove the rain", "G", "weather", ()), ("two cyclists instead", "O2", "count", 2), ("20 m further away", "O1", "placement.gap", 50.0),
         ("on a motorway", "R", "kind", "motorway"), ("at night", "G", "time", "night"), ("ego at 50 km/h", "E", "speed", 13.89),
        ("replace the pedestrian with a child", "O2", "type", "child"), ("use Town03", "G", "map", "Town03"), ("the lead drives 20 km/h", "O1", "speed", 5.56), ("ego should not brake", "E", "reaction", "none"),
        ("run for 30 s", "T", "duration", 30.0), ("Can you make the lead a van?", "O1", "type", "van"), ("what if it were a motorway?", "R", "kind", "motorway"), ("What if the lead were a bus?", "O1", "type", "bus"), ("set the gap to 40 m", "O1", "placement.gap", 40.0), ("with three lanes", "R", "lanes", 3),
    ],
)  # fmt: skip
def test_a_change_touches_only_what_was_meant(
    scene: Structure, text: str, component: str, path: str, value: object
) -> None:
    turn = route(text, scene)
    assert turn.kind == "edit" and turn.reply
    now = after(turn, scene)
    assert changed(scene, now) == {component}
    found: object = now[component].spec
    for name in path.split("."):
        found = getattr(found, name)
    assert found == value


def test_a_gap_is_told_by_which_it_is_and_what_it_was(scene: Structure) -> None:
    turn = route("set the gap to 40 m", scene)
    assert turn.reply == "O1 (lead): gap 40 m; that is the gap at the start of O1, which was 30 m"


def test_adding(scene: Structure) -> None:
    now = after(route("add a parked van on the right, 20 m ahead", scene), scene)
    assert (
        changed(scene, now) == {"O3"} and now["O3"].spec.type == "van" and now["O3"].spec.placement.position == "parked"
    )


def test_two_demands_in_one_turn(scene: Structure) -> None:
    now = after(route("make it night and remove the pedestrian", scene), scene)
    assert changed(scene, now) == {"G", "O2"}


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("undo", "undo"), ("Undo that.", "undo"), ("redo", "redo"), ("what does O1 do?", "question"), ("Why does the lead brake?", "question"), ("explain the reaction of ego", "question"),
        ("A car cuts in from the left in front of the ego vehicle on a three-lane motorway at dusk.", "scenario"), ("blah blub", "edit"), ("", "edit"),
        
    ],
)  # fmt: skip
def test_what_a_turn_is_taken_for(scene: Structure, text: str, kind: str) -> None:
    assert route(text, scene).kind == kind


def test_what_is_not_understood_says_what_would_do(scene: Structure) -> None:
    turn = route("make it somehow nicer", scene)
    assert turn.kind == "edit" and not turn.edits and "such as" in turn.reply


def test_without_a_scene_everything_told_is_one() -> None:
    assert route("a pedestrian crosses", None).kind == "scenario"
    assert route("what is a typology?", None).kind == "question"


@pytest.mark.parametrize(
    "text",
    [
        "Unit 1 was going straight at 30 mph. Unit 2 pulled out of a driveway on the right without looking. It hit Unit 2.",
        "Vehicle 1 was travelling north at 80 km/h. Vehicle 2, a pickup, crossed the centre line and struck vehicle 1.",
        "NPC 7 cuts in ahead of ego.", "P-1 stepped out and the POV braked.", "Sarah drives behind driver B at a junction.",
    ],
)  # fmt: skip
def test_the_first_text_of_a_session_is_a_scenario_whoever_it_names(text: str) -> None:
    assert route(text, Structure()).kind == route(text, None).kind == "scenario"


CRASH = (
    "V1, a sedan, was travelling northbound on a two-lane rural road at 45 mph. V2, a pickup truck, was southbound and "
    "drifted left across the centerline. V1 steered right but the front of V2 struck the left side of V1."
)


@pytest.mark.parametrize(
    "text",
    [
        "V2 hits ego's left side with its front left corner", "V2 hits V1's left side with its front left corner",
        "V2 only drifts over the line 30 m before V1", "Unit 2 runs into the left side of ego 30 m before the bend",
        "The pickup, which comes towards ego at night, hits a wall behind ego",
    ],
)  # fmt: skip
def test_who_is_there_makes_a_text_a_change(read, text: str) -> None:
    assert route(text, read(CRASH)).kind == "edit"


@pytest.mark.parametrize(
    "text",
    [
        "V1, a van, was travelling west on a motorway at 60 mph. V2, a motorcycle, followed V1. V2 struck the rear of V1.",
        "Ego drives at 50 km/h in a town. A cyclist rides out from the right in front of ego, and ego brakes.",
    ],
)  # fmt: skip
def test_what_tells_of_others_is_another_description(read, text: str) -> None:
    assert route(text, read(CRASH)).kind == "scenario"


def test_what_s_refuses_is_told_as_why(scene: Structure) -> None:
    far = Condition(kind="distance", other="O1", minimum=100.0)
    bound = apply(scene, SetField(component="T", path="require", value=[far.model_dump()]))
    with pytest.raises(InterpreterFault, match="^O1 is referred to by T: change that first. Nothing was changed.$"):
        route("remove the lead", bound)
    turn = route("make it night and remove the lead", bound)
    assert changed(bound, after(turn, bound)) == {"G"} and "not done: O1 is referred to by T" in turn.reply

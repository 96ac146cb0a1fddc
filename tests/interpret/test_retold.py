"""Changes that are told like a scene: read amid what is there, they touch whom they name and nobody else."""

import pytest

from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

STREET = (
    "In heavy rain, ego follows a car at 50 km/h on a two-lane urban road. The car brakes hard and a pedestrian "
    "crosses from the right."
)
JUNCTION = (
    "Ego approaches a signalised intersection at 40 km/h. A truck crosses from the left and a motorcycle follows ego."
)


def turned(structure: Structure, text: str) -> Structure:
    turn = route(text, structure)
    assert turn.kind == "edit"
    for edit in turn.edits:
        structure = apply(structure, edit)
    return structure


def actions(structure: Structure, cid: str) -> list[str]:
    return [p.action for p in structure[cid].spec.phases]


def untouched(before: Structure, after: Structure, *changed: str) -> bool:
    return all(c.spec == before[c.id].spec for c in after.components if c.id in before and c.id not in changed)


@pytest.mark.parametrize(
    ("scene", "text", "cid", "found"),
    [
        (STREET, "the lead should stop completely", "O1", ["stop"]),
        (STREET, "the car cuts in from the right", "O1", ["cut_in"]),
        (STREET, "then the pedestrian also stops", "O2", ["cross_road", "stop"]),
        (STREET, "make the pedestrian run", "O2", ["cross_road"]),
        (JUNCTION, "motorcycle overtakes the ego before the junction", "O2", ["overtake"]),
        (JUNCTION, "can the truck turn left?", "O1", ["turn_left"]),
        (JUNCTION, "the truck should run the red light", "O1", ["run_red", "go_straight"]),
        (JUNCTION, "the motorcycle must not follow ego", "O2", []),
    ],
)
def test_what_somebody_does(read, scene, text, cid, found):
    before = read(scene)
    after = turned(before, text)
    assert actions(after, cid) == found
    assert untouched(before, after, cid, "R")


def test_a_trigger_is_added_to_what_is_done_anyway(read):
    before = read(STREET)
    (phase,) = turned(before, "let the car brake when the pedestrian is 10 m away")["O1"].spec.phases
    assert (phase.action, phase.rate, phase.trigger.kind) == ("brake", before["O1"].spec.phases[0].rate, "distance")


@pytest.mark.parametrize(
    "text", ["add a parked van that hides the pedestrian", "the pedestrian should come from behind a parked van"]
)
def test_a_new_one_is_linked_with_those_that_are_there(read, text):
    before = read(STREET)
    after = turned(before, text)
    (new,) = set(after.ids) - set(before.ids)
    assert after[new].spec.type == "van" and after["O2"].spec.placement.hidden_by == new
    assert after.ids.index(new) < after.ids.index("O2") and untouched(before, after, "O2")


def test_another_of_the_same_type_is_another_one(read):
    before = read(STREET)
    after = turned(before, "and another car behind ego, tailgating")
    (new,) = set(after.ids) - set(before.ids)
    assert after[new].spec.placement.position == "behind" and untouched(before, after)


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("everyone 10 km/h slower", {"E": 30, "O2": 30}),
        ("slow everything down", {"E": 30, "O2": 30}),
        ("increase ego's speed by 10 km/h", {"E": 50, "O2": 40}),
        ("raise the speed of ego to 60 km/h", {"E": 60, "O2": 40}),
        ("the motorcycle is faster, 60 km/h", {"E": 40, "O2": 60}),
        ("the motorcycle drives 20 km/h faster", {"E": 40, "O2": 60}),
        ("ego speed 70", {"E": 70, "O2": 40}),
    ],
)
def test_speeds_to_have_and_differences_of_speed(read, text, speeds):
    after = turned(read(JUNCTION), text)
    assert {cid: round(after[cid].spec.speed * 3.6) for cid in speeds} == speeds


@pytest.mark.parametrize(
    ("text", "cid", "kind", "count"),
    [
        ("same but with a bus", "O1", "bus", 1),
        ("Same scenario with a van instead of the truck", "O1", "van", 1),
        ("three trucks", "O1", "truck", 3),
    ],
)
def test_types_and_counts(read, text, cid, kind, count):
    spec = turned(read(JUNCTION), text)[cid].spec
    assert spec.type == kind and getattr(spec, "count", None) == count


def test_what_is_said_of_the_new_one_counts_too(read):
    after = turned(read(STREET), "the car in front should be a police car with 60 km/h")
    assert (after["O1"].spec.type, round(after["O1"].spec.speed * 3.6)) == ("police_car", 60)
    assert round(turned(read(STREET), "the pedestrian is a child running")["O2"].spec.speed * 3.6) > 5

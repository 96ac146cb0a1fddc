"""Demands in the words of those who test: what each touches, and that the rest stays."""

from typing import Any

import pytest

from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

STREET = "In heavy rain ego follows a taxi at 50 km/h. The taxi brakes hard and a woman crosses from the right."
JUNCTION = "Ego approaches a signalised intersection at 40 km/h and turns left. An oncoming lorry goes straight on."
MOTORWAY = (
    "On a three-lane motorway ego drives at 110 km/h in the middle lane. A van ahead brakes. A car overtakes ego."
)


def value_of(structure: Structure, path: str) -> Any:
    cid, _, rest = path.partition(".")
    found: Any = structure[cid].spec
    for name in rest.split("."):
        if name == "actions":
            return [p.action for p in found.phases]
        triggers = [p.trigger for p in getattr(found, "phases", ()) if p.trigger]
        part = found[int(name)] if name.isdigit() else getattr(found, name, None)
        found = triggers[0] if name == "trigger" else part
    return found


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (
            STREET,
            "let the taxi brake after 4 s, and make the woman walk faster, about 8 km/h",
            {"O2.speed": 2.22},
        ),
        (STREET, "make ego a bus and reduce its speed to 30 km/h", {"E.type": "bus", "E.speed": 8.33}),
        (STREET, "replace the rain by fog", {"G.weather": ("fog",)}),
        (STREET, "please only light rain", {"G.weather": ("rain",)}),
        (STREET, "instead of the taxi use a bus which stops", {"O1.type": "bus", "O1.actions": ["stop"]}),
        (STREET, "use vehicle.audi.tt for ego", {"E.model": "vehicle.audi.tt"}),
        (STREET, "the taxi drives 35", {"O1.speed": 9.72}),
        (STREET, "the woman waits until ego is 15 m away, only then she crosses", {"O2.trigger.value": 15.0}),
        (STREET, "the woman must not cross before the taxi has stopped", {"O2.trigger.of": "O1"}),
        (STREET, "the taxi should be 25 m ahead, drive 40 km/h and brake after 6 s", {"O1.speed": 11.11}),
        (STREET, "reduce the speed limit to 70", {"R.speed_limit": 19.44}),
        (JUNCTION, "the lorry runs its red light while ego has green", {"G.light": "green"}),
        (
            JUNCTION,
            "ego goes straight on and the lorry turns left",
            {"R.manoeuvre": "straight", "O1.actions": ["turn_left"]},
        ),
        (JUNCTION, "only three roads meet there", {"R.arms": 3}),
        (JUNCTION, "ego has to react to it with an emergency brake", {"E.reaction": "brake", "E.hard": True}),
        (MOTORWAY, "put ego in the right lane", {"R.ego_lane": "rightmost"}),
        (
            MOTORWAY,
            "let the overtaking car cut in in front of ego and brake hard",
            {"O2.actions": ["overtake", "cut_in", "brake"]},
        ),
        (MOTORWAY, "ego is more slow by ten kilometer per hour", {"E.speed": 27.78}),
        (MOTORWAY, "the car shall cut in, then brake to 90 km/h", {"O2.actions": ["cut_in", "brake"]}),
        (MOTORWAY, "change the van into a bus and let it drive 80 km/h", {"O1.type": "bus", "O1.speed": 22.22}),
        (MOTORWAY, "increase everyone's speed by 18 km/h", {"E.speed": 35.56, "O1.speed": 35.56}),
        (STREET, "let both the taxi and ego drive 30 km/h", {"O1.speed": 8.33, "E.speed": 8.33}),
        (JUNCTION, "ego has to stop first", {"E.actions": ["stop", "turn_left"]}),
        (STREET, "make the taxi brake harder", {"O1.phases.0.rate": 9.0}),
        (STREET, "braking of the taxi with 3 m/s2 only", {"O1.phases.0.rate": 3.0}),
        (JUNCTION, "ego has no green light", {"G.light": "red"}),
        (STREET, "woman: from left, 9 km/h, starts when ego is at 25 m", {"O2.speed": 2.5, "O2.trigger.value": 25.0}),
        (MOTORWAY, "replace the van by a tanker, 72 km/h", {"O1.type": "truck", "O1.speed": 20.0}),
        (STREET, "The woman is too slow for us, let her walk at 9 km/h.", {"O2.speed": 2.5}),
        (STREET, "My boss wants to see a cyclist rather than the woman", {"O2.type": "bicycle"}),
        (STREET, "Since we test in town, ego should go 36 and the taxi 18", {"E.speed": 10.0, "O1.speed": 5.0}),
        (
            JUNCTION,
            "As the lorry always stops for us, make it ignore its red light.",
            {"O1.actions": ["run_red", "go_straight"]},
        ),
        (JUNCTION, "the light should be red for ego at first", {"G.light": "red"}),
        (JUNCTION, "swap the lorry for a motorbike at 72 km/h", {"O1.type": "motorcycle", "O1.speed": 20.0}),
        (MOTORWAY, "let the van be slower, around 72", {"O1.speed": 20.0}),
    ],
)
def test_what_is_demanded(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    before = read(scene)
    turn = route(text, before)
    assert turn.kind == "edit", turn
    after = before
    for edit in turn.edits:
        after = apply(after, edit)
    for path, wanted in expected.items():
        found = value_of(after, path)
        assert found == pytest.approx(wanted, abs=0.06) if isinstance(wanted, float) else found == wanted
    assert len(after.objects) == len(before.objects)


@pytest.mark.parametrize(
    ("scene", "text", "gone"),
    [
        (STREET, "i dont need the woman", "O2"),
        (STREET, "leave out the taxi", "O1"),
    ],
)
def test_who_goes(read, scene: str, text: str, gone: str) -> None:
    structure = read(scene)
    for edit in route(text, structure).edits:
        structure = apply(structure, edit)
    assert gone not in structure and len(structure.objects) == 1


@pytest.mark.parametrize(
    ("text", "stays"),
    [
        ("have ego stop for the woman and go on afterwards", "O2"),
        ("the woman waits at the kerb until the taxi has passed, then crosses", "O1"),
        ("let the woman cross when ego is 20 m away", "E"),
    ],
)
def test_who_is_only_named_beside_others_stays(read, text: str, stays: str) -> None:
    before = after = read(STREET)
    for edit in route(text, before).edits:
        after = apply(after, edit)
    assert after[stays].spec == before[stays].spec


@pytest.mark.parametrize(
    "text",
    [
        "the tractor on the right should merge before the van",
    ],
)
def test_who_is_not_there_changes_nobody(read, text: str) -> None:
    turn = route(text, read(MOTORWAY))
    assert turn.kind != "edit" or not turn.edits

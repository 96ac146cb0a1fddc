"""Changes as they are noted in a hurry: bare values, short orders, complaints, slips and corrections."""
# ruff: noqa: E501  (tables of cases stay on one line)

from typing import Any

import pytest

from c2s_engine.structure.components import Structure
from tests.interpret.demanded import changed

TOWN = (
    "In heavy rain ego follows a lorry at 50 km/h on a two-lane urban road. The lorry brakes hard and a man crosses "
    "from the right sidewalk."
)
CROSS = (
    "At a four-way stop a police car comes from the right and runs the stop sign while ego goes straight on at "
    "30 km/h. A dog stands on the left sidewalk."
)
ROW = (
    "Ego passes three parked cars on the right at 30 km/h. A boy runs out from behind them. A bus comes the other way."
)
FAST = (
    "On a three-lane motorway ego drives at 120 km/h in the middle lane. A van 30 m ahead slows down. A car on the "
    "left at 140 km/h overtakes ego."
)


def value_of(structure: Structure, path: str) -> Any:
    cid, _, rest = path.partition(".")
    if cid not in structure:
        return "gone"
    found: Any = structure[cid].spec
    if rest == "actions":
        return [p.action for p in found.phases]
    if rest.startswith("trigger."):
        return next(getattr(p.trigger, rest.partition(".")[2]) for p in found.phases if p.trigger)
    for name in rest.split(".") if rest else ():
        found = found[int(name)] if name.isdigit() else getattr(found, name)
    return found


def becomes(before: Structure, text: str, expected: dict[str, Any]) -> None:
    """A demand changes these fields, and no other component."""
    now = changed(before, text)
    for path, wanted in expected.items():
        found = value_of(now, path)
        assert found == pytest.approx(wanted, abs=0.06) if isinstance(wanted, float) else found == wanted, path
    named = {path.partition(".")[0] for path in expected}
    others = set(before.ids) & set(now.ids) - named
    assert all(before[cid].spec == now[cid].spec for cid in others)
    assert named >= set(before.ids) ^ set(now.ids)


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (TOWN, "front lorry 60 not 50", {"O1.speed": 16.67}),
        (TOWN, "ego = van", {"E.type": "van"}),
        (TOWN, "lead: car", {"O1.type": "car"}),
        (TOWN, "ego 40, lorry 35", {"E.speed": 11.11, "O1.speed": 9.72}),
        (FAST, "more distance to the van, 70", {"O1.placement.gap": 70.0}),
        (FAST, "gap to the van doubled", {"O1.placement.gap": 60.0}),
        (CROSS, "70 for the police car, not 50", {"O1.speed": 19.44}),
    ],
)
def test_bare_values(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)


@pytest.mark.parametrize(
    ("scene", "text", "gone"),
    [
        (CROSS, "del the dog", ["O2"]),
        (CROSS, "dog is pointless, kill", ["O2"]),
        (CROSS, "the animal must go", ["O2"]),
        (ROW, "bus not required here", ["O3"]),
        (ROW, "dont need the bus", ["O3"]),
        (ROW, "remove O2 and O3", ["O2", "O3"]),
        (ROW, "the bus blocks the view so remove it", ["O3"]),
    ],
)
def test_who_goes(read, scene: str, text: str, gone: list[str]) -> None:
    before = read(scene)
    now = changed(before, text)
    assert set(before.ids) - set(now.ids) == set(gone) and set(now.ids) <= set(before.ids)


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (ROW, "ego too slow.. 50", {"E.speed": 13.89}),
        (ROW, "i think the boy is too fast, 6 is better", {"O2.speed": 1.67}),
        (FAST, "30 m is too close at this speed, make it 60", {"O1.placement.gap": 60.0}),
        (TOWN, "the rain is too strong, only drizzle", {"G.weather": ("rain",)}),
        (TOWN, "hi, it is for my thesis: i need the rain much lighter", {"G.weather": ("rain",)}),
        (TOWN, "no i meant the man should be faster not the lorry", {"O2.speed": 1.82}),
        (TOWN, "man comes frm the left, not from right", {"O2.placement.side": "left"}),
        (CROSS, "its an ambulance, not a police car", {"O1.type": "ambulance"}),
        (ROW, "boy walks, doesnt run", {"O2.speed": 1.4}),
    ],
)
def test_complaints_and_corrections(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (TOWN, "can't the thing in front of us be a van", {"O1.type": "van"}),
        (FAST, "the left one 160", {"O2.speed": 44.44}),
        (ROW, "the one coming towards us is too slow, 60 km/h", {"O3.speed": 16.67}),
        (CROSS, "cops from the left", {"O1.placement.position": "crossing_left"}),
        (CROSS, "the cops 80 km/h", {"O1.speed": 22.22}),
    ],
)
def test_who_is_only_described(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (TOWN, "the lorry brakes later", {"O1.trigger.kind": "time", "O1.trigger.value": 2.0}),
        (TOWN, "man starts 3 s later", {"O2.trigger.kind": "time", "O2.trigger.value": 3.0}),
        (TOWN, "the man comes too early", {"O2.trigger.kind": "time"}),
        (
            TOWN,
            "the walker is always over when we arrive!! he should wait and only start when ego is 25 m away from him",
            {"O2.trigger.kind": "distance", "O2.trigger.value": 25.0},
        ),
        (
            FAST,
            "its braking begins when the TTC between the van and ego falls to 3 s, not from the beginning",
            {"O1.trigger.kind": "ttc", "O1.trigger.value": 3.0},
        ),
        (FAST, "the van brakes when the gap is 15 m", {"O1.trigger.value": 15.0, "O1.placement.gap": 30.0}),
        (CROSS, "dog crosses when ego is 10 m away", {"O2.trigger.value": 10.0, "O2.placement.side": "left"}),
    ],
)
def test_when(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)


def test_when_ego_does_something(read) -> None:
    before = read("Ego turns left at an intersection. A motorcycle follows ego.")
    now = changed(before, "the rider gets impatient and overtakes ego exactly when ego begins turning left")
    trigger = now["O1"].spec.phases[0].trigger
    assert (trigger.kind, trigger.of, trigger.action) == ("action", "ego", "turn_left")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("van brakes not down to zero, only to 60 km/h and soft, with 2 m/s2", {"speed": 16.67, "rate": 2.0}),
        ("the van should not stop, it just slows to 90", {"speed": 25.0}),
        ("the van does not come to a full stop, only to 80 km/h", {"speed": 22.22}),
    ],
)
def test_down_to(read, text: str, expected: dict[str, float]) -> None:
    phase = changed(read(FAST), text)["O1"].spec.phases[0]
    assert {name: getattr(phase, name) for name in expected} == pytest.approx(expected, abs=0.06)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("police car turns left", {"O1.actions": ["run_stop", "turn_left"]}),
        ("ego stops at the stop sign", {"E.actions": ["stop", "go_straight"]}),
        ("ego runs the stop sign too", {"E.actions": ["run_stop", "go_straight"]}),
        ("cops should stop first", {"O1.actions": ["stop", "go_straight"]}),
        ("let ego go left here", {"E.actions": ["turn_left"], "R.manoeuvre": "left"}),
        ("dog is ok but make it two", {"O2.count": 2}),
        ("no stop signs", {"R.control": "none"}),
    ],
)
def test_at_the_junction(read, text: str, expected: dict[str, Any]) -> None:
    becomes(read(CROSS), text, expected)


@pytest.mark.parametrize("text", ["left car level with ego", "put the car beside ego", "car abreast of us, not behind"])
def test_level_with_ego(read, text: str) -> None:
    place = changed(read(FAST), text)["O2"].spec.placement
    assert (place.position, place.along) == ("left_lane", "abreast")


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        
        
        
        
        (TOWN, "not a man but a dog", {"O2.type": "animal"}),
        
        (TOWN, "rain ok, but at night", {"G.weather": ("heavy_rain",), "G.time": "night"}),
        (FAST, "please increase the gap by 15 m", {"O1.placement.gap": 45.0}),
        
        (FAST, "the van is too near for 120 km/h. In real life nobody drives like that. Give it 60 m.", {"O1.placement.gap": 60.0}),
        
        (TOWN, "lead = motorcycle @ 45 km/h", {"O1.type": "motorcycle", "O1.speed": 12.5}),
        
        
        (ROW, "when the boy starts, the bus brakes", {"O3.trigger.of": "O2", "O3.trigger.action": "cross_road"}),
    ],
)  # fmt: skip
def test_what_else_is_demanded(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)

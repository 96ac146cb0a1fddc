"""Changes as testers type them, without a verb, in one breath or by what they call things: what becomes of S."""

from typing import Any

import pytest

from c2s_engine.structure.components import Structure
from tests.interpret.demanded import MOTORWAY, ROW, changed

STREET = "Ego follows a taxi at 50 km/h. The taxi brakes hard and a woman crosses from the right."
JUNCTION = (
    "Ego approaches a signalised intersection at 40 km/h and turns left. An oncoming lorry goes straight on. "
    "A motorcycle follows ego."
)
STOP = "At a four-way stop a police car comes from the right and runs the stop sign while ego goes straight on."


def value_of(structure: Structure, path: str) -> Any:
    cid, _, rest = path.partition(".")
    found: Any = structure[cid].spec
    if rest == "actions":
        return [p.action for p in found.phases]
    if rest == "trigger":
        return next((p.trigger.of, p.trigger.action) for p in found.phases if p.trigger)
    for name in rest.split("."):
        found = found[int(name)] if name.isdigit() else getattr(found, name)
    return found


def becomes(before: Structure, text: str, expected: dict[str, Any]) -> None:
    """A demand changes these fields, and nobody comes or goes."""
    now = changed(before, text)
    for path, wanted in expected.items():
        found = value_of(now, path)
        assert found == pytest.approx(wanted, abs=0.06) if isinstance(wanted, float) else found == wanted
    assert now.ids == before.ids


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (STREET, "the braking is too hard, make it gentle, about 2 m/s²", {"O1.phases.0.rate": 2.0}),
        (STREET, "the road should be one-way with three lanes, ego in the rightmost", {"R.ego_lane": "rightmost"}),
        (STREET, "swap it: woman from the left and the taxi in the left lane", {"O1.placement.position": "left_lane"}),
        (STREET, "make everything 9 km/h slower", {"E.speed": 11.39, "O1.speed": 11.39, "O2.speed": 1.4}),
        (JUNCTION, "move the motorcycle to the adjacent left lane", {"O2.placement.position": "left_lane"}),
        (MOTORWAY, "the left car cuts in between ego and the van and brakes", {"O2.actions": ["cut_in", "brake"]}),
        (MOTORWAY, "let the van be a lorry with a trailer that does 72", {"O1.type": "truck", "O1.speed": 20.0}),
        (STREET, "the driver of the taxi falls asleep and drifts to the right", {"O1.actions": ["drift"]}),
        (STREET, "double the distance between ego and the taxi", {"O1.placement.gap": 50.0, "E.speed": 13.89}),
        (STREET, "Is it possible to have the taxi brake at 3 m/s2?", {"O1.phases.0.rate": 3.0}),
        (STREET, "why don't we make the taxi a van?", {"O1.type": "van"}),
        (JUNCTION, "Shouldn't the lorry run the red light?", {"O1.actions": ["run_red", "go_straight"]}),
        (STREET, "once more with a child instead", {"O2.type": "child"}),
        (STREET, "let's say the taxi is a lorry", {"O1.type": "truck"}),
        (ROW, "the parked cars are on the left and the boy comes from there", {"O2.placement.side": "left"}),
        (STREET, "because the camera is blind in the dark it has to be night", {"G.time": "night"}),
        (
            STREET,
            "Ego shall not follow the taxi but overtake it before the woman steps out.",
            {"E.actions": ["overtake"], "O2.actions": ["cross_road"]},
        ),
        (
            JUNCTION,
            "According to our spec the lorry must be a car at 36 km/h and it does not slow down.",
            {"O1.type": "car", "O1.speed": 10.0},
        ),
        (
            MOTORWAY,
            "make the van an articulated lorry doing 72, and increase the distance to 100 m",
            {"O1.speed": 20.0, "O1.placement.gap": 100.0},
        ),
        (
            STOP,
            "make the police car come from the left, with its siren on, at 72 km/h and ignore the stop sign",
            {"O1.speed": 20.0, "O1.actions": ["run_stop", "go_straight"]},
        ),
        (ROW, "Ego drives 54 although 30 is allowed there.", {"E.speed": 15.0}),
        (ROW, "boy stops in the middle of the street", {"O2.actions": ["cross_road", "stop"]}),
        (ROW, "bus in ego's lane", {"O3.placement.position": "ahead"}),
        (STOP, "the police car stops properly", {"O1.actions": ["stop", "go_straight"]}),
        (
            STREET,
            "instead of a woman, a cyclist coming from the left",
            {"O2.type": "bicycle", "O2.placement.side": "left"},
        ),
    ],
)
def test_what_it_becomes(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (
            JUNCTION,
            "The lorry should have a car behind it.",
            {"O3.placement.of": "O1", "O3.placement.position": "behind"},
        ),
        (
            JUNCTION,
            "a pedestrian crosses the exit while ego is turning, coming from the left side",
            {"O3.placement.side": "left"},
        ),
        (ROW, "the second of the parked cars pulls out", {"O1.count": 2, "O4.placement.position": "parked"}),
        (STREET, "add a cyclist between ego and the taxi", {"O3.placement.position": "ahead"}),
        (MOTORWAY, "roadworks in the right lane", {"O3.placement.position": "right_lane"}),
        (
            JUNCTION,
            "from the right comes an ambulance which does not care about the light",
            {"O3.actions": ["run_red", "go_straight"]},
        ),
    ],
)
def test_who_comes_besides(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    before = read(scene)
    now = changed(before, text)
    assert {path: value_of(now, path) for path in expected} == expected
    assert len(now.ids) == len(before.ids) + 1


@pytest.mark.parametrize(
    ("scene", "text", "gone", "stays"),
    [
        (STREET, "would you mind removing the woman?", "O2", "O1"),
        (STREET, "The taxi is a distraction here. Take it out and leave the rest.", "O1", "O2"),
        (STREET, "there must not be any woman", "O2", "O1"),
    ],
)
def test_who_goes_and_who_stays(read, scene: str, text: str, gone: str, stays: str) -> None:
    now = changed(read(scene), text)
    assert gone not in now and stays in now


@pytest.mark.parametrize(
    ("text", "name", "gap"),
    [
        ("Ego, a car, drives at 50 km/h. A car is 30 m ahead of ego. The car is in the left lane.", "left_lane", 30.0),
        ("Ego follows a truck. A cyclist rides between ego and the truck.", "ahead", None),
        ("Ego overtakes a cyclist before an oncoming car arrives.", "ahead", None),
    ],
)
def test_where_they_are(read, text: str, name: str, gap: float | None) -> None:
    first = next(o for o in read(text).objects if o.spec.type in ("car", "bicycle"))
    assert (first.spec.placement.position, first.spec.placement.of, first.spec.placement.gap) == (name, "ego", gap)


@pytest.mark.parametrize(
    ("text", "actions"),
    [
        ("A pedestrian stops in the middle of the crosswalk.", ["cross_road", "stop"]),
        ("A child stops halfway across the street.", ["cross_road", "stop"]),
        ("A pedestrian stops at the kerb.", ["stop"]),
        ("A car from the left does not stop at the signal.", ["run_red", "go_straight"]),
    ],
)
def test_what_they_do(read, text: str, actions: list[str]) -> None:
    assert [p.action for p in read(text).objects[0].spec.phases] == actions


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (STREET, "three women instead of one, 1.5 m apart", {"O2.count": 3, "O2.spacing": 1.5}),
        (STREET, "the woman starts crossing in the moment the taxi begins to brake", {"O2.trigger": ("O1", "brake")}),
        (
            JUNCTION,
            "Lorry => ambulance. It runs the red light.",
            {"O1.type": "ambulance", "O1.phases.0.action": "run_red"},
        ),
        (
            MOTORWAY,
            "the van brakes harder: 7 m/s2, down to 54 km/h",
            {"O1.phases.0.rate": 7.0, "O1.phases.0.speed": 15.0},
        ),
        (MOTORWAY, "all of this in a left hand bend", {"R.curve": "left"}),
        (ROW, "five parked cars with 2 m between them", {"O1.count": 5, "O1.spacing": 2.0}),
        (ROW, "parked cars and boy both on the left side", {"O1.placement.side": "left", "O2.placement.side": "left"}),
        (ROW, "End the run as soon as ego has stopped.", {"T.terminate_when.0.kind": "stopped"}),
        (ROW, "ego should be motorcycle with 90 km/h", {"E.type": "motorcycle", "E.speed": 25.0}),
        (ROW, "bus 20 m closer, 9 km/h faster", {"O3.placement.gap": 5.0}),
        (
            STOP,
            "police 72 km/h, ego 45 km/h, snow, run takes 25 s",
            {"O1.speed": 20.0, "E.speed": 12.5, "T.duration": 25.0},
        ),
        (STREET, "swap the woman for a child, on the left sidewalk", {"O2.type": "child", "O2.placement.side": "left"}),
    ],
)
def test_notes_of_several_demands(read, scene: str, text: str, expected: dict[str, Any]) -> None:
    becomes(read(scene), text, expected)

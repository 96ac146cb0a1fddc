"""Who is added to a scene comes with all that is said of him, and nobody else changes."""

import pytest

from c2s_engine.interpret.turn import route
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import apply

STREET = "Ego drives at 45 km/h on a city street behind a bus. A woman crosses from the right."
PARKED = "Ego passes two cars parked on the right at 30 km/h. A boy runs out from behind them."


def turned(before: Structure, text: str) -> Structure:
    turn = route(text, before)
    assert turn.kind == "edit", turn
    after = before
    for edit in turn.edits:
        after = apply(after, edit)
    for component in before.objects:
        assert after[component.id].spec == component.spec
    return after


@pytest.mark.parametrize(
    ("scene", "text", "expected"),
    [
        (
            STREET,
            "there should be a second woman who comes from the left at walking pace",
            {"type": "pedestrian", "placement.side": "left", "action": "cross_road"},
        ),
        (
            STREET,
            "One more pedestrian, an old man, crosses from the left, very slowly, about 2 km/h, so ego has to wait.",
            {"type": "pedestrian", "placement.side": "left", "speed": 0.56, "action": "cross_road"},
        ),
        (
            STREET,
            "a lorry in the left lane next to ego, same speed",
            {"type": "truck", "placement.position": "left_lane", "placement.along": "abreast", "speed": 12.5},
        ),
        (
            STREET,
            "I'd like to have two taxis in the left lane, both at 60 km/h, so that ego cannot pass",
            {"type": "car", "count": 2, "placement.position": "left_lane", "speed": 16.67},
        ),
        (PARKED, "add a cat that runs over the road too", {"type": "animal", "action": "cross_road"}),
        (PARKED, "a motorbike overtakes ego on the left at 70 km/h", {"type": "motorcycle", "action": "overtake"}),
        (
            PARKED,
            "add a van that is double-parked in ego's lane, ego has to go around it",
            {"type": "van", "action": "stationary"},
        ),
    ],
)
def test_with_all_that_is_said(read, scene: str, text: str, expected: dict[str, object]) -> None:
    before = read(scene)
    after = turned(before, text)
    assert len(after.objects) == len(before.objects) + 1
    found = next(c.spec for c in after.objects if c.id not in before)
    for path, wanted in expected.items():
        value = found
        if path == "action":
            assert wanted in [p.action for p in found.phases]
            continue
        for name in path.split("."):
            value = getattr(value, name)
        assert value == pytest.approx(wanted, abs=0.06) if isinstance(wanted, float) else value == wanted


@pytest.mark.parametrize("text", ["the bus has its hazard lights on", "the woman wears a red coat and a hat"])
def test_those_who_are_there_make_no_new_scene(read, text: str) -> None:
    turn = route(text, read(STREET))
    assert turn.kind == "edit" and not turn.edits and "did not understand" in turn.reply

"""What was left open becomes a range as far as the sampled scenes hold, and is said."""

import pytest

from c2s_engine.solve import PLANNER, widened
from c2s_engine.solve.widening import LEAST, REASON
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec


def lead() -> Structure:
    """Ego behind one that brakes hard."""
    return Structure(
        place=Component(id="R", spec=PlaceSpec(kind="straight")),
        ego=Component(id="E", spec=EgoSpec(speed=14.0, reaction="brake")),
        objects=(Component(id="O1", spec=ObjectSpec(speed=14.0, phases=(Phase(action="brake", rate=6.0),))),),
    )


def width(structure: Structure) -> float:
    gap = structure["O1"].spec.placement.gap
    return 0.0 if gap is None else (high(gap) - low(gap)) / 2 / ((high(gap) + low(gap)) / 2)


@pytest.mark.parametrize(("most", "expected"), [(0.25, 0.2), (0.15, 0.1), (0.05, 0.0)])
async def test_each_is_as_wide_as_holds(most, expected):
    async def share_whole(structure: Structure) -> float:
        return 1.0 if width(structure) <= most else LEAST - 0.1

    found = await widened(lead(), 1.0, share_whole)
    assert abs(width(found) - expected) < 0.01
    notes = {a.field: a for a in found["O1"].assumed}
    assert ("placement.gap" in notes) == (expected > 0)
    assert all(a.by == PLANNER and a.reason == REASON for a in notes.values())
    assert found.ego.spec.speed == 14.0 and found["O1"].spec.speed == 14.0  # said


async def test_nothing_that_holds_leaves_it_as_it_is():
    async def share_whole(structure: Structure) -> float:
        return 0.0

    structure = lead()
    assert await widened(structure, 1.0, share_whole) is structure


@pytest.mark.nightly
async def test_a_text_is_varied(engine):
    async for event in engine.generate("A car cuts in from the left lane ahead of ego, which brakes.", widen=True):
        last = event
    assert all(r.holds for r in last.results)
    assert "Range(" in last.structure["O1"].code and any(a.reason == REASON for a in last.structure["O1"].assumed)

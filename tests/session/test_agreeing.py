"""A text that contradicts itself ends in a program that runs, and what was left out is said."""

import pytest

from c2s_engine.session.without_contradictions import without_contradictions
from c2s_engine.structure.progress import Finished
from c2s_engine.write.typed import contradiction
from tests.write import draws


def test_every_drawn_contradiction_comes_to_agree_and_nothing_else_is_touched():
    found = 0
    for seed in range(150):
        structure = draws.structure(seed)
        agreed = without_contradictions(structure)
        if contradiction(structure):
            found += 1
            assert not contradiction(agreed)
            assert any("left out, because" in u.reason for c in agreed.components for u in c.unmet)
        else:
            assert agreed == structure
    assert found > 5


@pytest.mark.full
@pytest.mark.asyncio
async def test_a_text_that_contradicts_itself_runs(engine):
    text = (
        "Ego is in the leftmost of three lanes. One car is in the right lane, another is two lanes to the left of ego."
    )
    text += " A motorcycle behind the first changes to the right, a van beside it changes to the right as well."
    async for event in engine.generate(text):
        last = event
    assert isinstance(last, Finished)
    assert [s.name for s in last.stages if not s.ok] == [] and last.stages[-1].name == "run"

"""Ways that meet (meetings.yaml): who is there when, and which parts touch, as somebody gets it who gives that S."""

from pathlib import Path

import pytest
import yaml

from c2s_engine.require import require
from c2s_engine.structure.components import Component
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.specs import SettingsSpec
from tests.write.test_golden import structure

CASES = yaml.safe_load((Path(__file__).parent / "meetings.yaml").read_text(encoding="utf-8"))


@pytest.mark.full(one_of=3)
@pytest.mark.parametrize("name", CASES)
async def test_they_meet_as_said(engine, name):
    case = CASES[name]
    made = structure(case).with_component(Component(id="G", spec=SettingsSpec.model_validate(case.get("G", {}))))
    done = None
    async for event in engine.realise(made, seed=0, trajectories=True):
        done = event if isinstance(event, Finished) else done
    assert done is not None and done.facts, done
    checks = {r.id: r.check for r in require(done.structure)}
    judged = [r for r in done.results if checks.get(r.requirement) in case["holds"]]
    assert {checks[r.requirement] for r in judged} == set(case["holds"])
    assert not [r for r in judged if not r.holds]

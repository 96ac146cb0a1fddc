"""What is written for each action and place, as golden files; and each action shows its event when it is run.

`C2S_GOLDEN=1 pytest tests/write/test_golden.py` writes the files anew: look at the difference before committing it.
"""

from pathlib import Path
from typing import Any, get_args

import pytest
import yaml

from c2s_engine.paths import shipped
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import SPEC_OF, ObjectSpec
from tests.golden import assert_same

GOLDEN = Path(__file__).parent / "golden"
CASES = yaml.safe_load((GOLDEN / "cases.yaml").read_text(encoding="utf-8"))
SHOWS = yaml.safe_load(shipped("vocabulary.yaml").read_text(encoding="utf-8"))["actions"]


def structure(case: dict[str, Any]) -> Structure:
    """The structure of a row of cases.yaml, or of any such list: specs of G, R, E, O (a list) and T."""
    one = {k: Component(id=k, spec=SPEC_OF[k].model_validate(case.get(k, {}))) for k in ("G", "R", "E", "T")}
    objects = tuple(
        Component(id=f"O{i}", spec=ObjectSpec.model_validate({"name": f"actor{i}", **row}))
        for i, row in enumerate(case.get("O", ()), 1)
    )
    return Structure(settings=one["G"], place=one["R"], ego=one["E"], restrictions=one["T"], objects=objects)


def compare(writer, name: str, case: dict[str, Any]) -> None:
    found = structure(case)
    assert_same("\n".join(writer.write(found, c.id).code for c in found.components), GOLDEN / f"{name}.scenic")


def test_every_action_and_place_has_a_case():
    assert set(CASES["actions"]) == set(get_args(v.Action))
    assert set(CASES["places"]) == set(get_args(v.PlaceKind))
    assert {p.stem for p in GOLDEN.glob("*.scenic")} == {
        *(f"action_{a}" for a in CASES["actions"]), *(f"place_{p}" for p in CASES["places"])
    }  # fmt: skip


@pytest.mark.parametrize("action", CASES["actions"])
def test_action_as_written(writer, action):
    compare(writer, f"action_{action}", CASES["actions"][action])


@pytest.mark.parametrize("place", CASES["places"])
def test_place_as_written(writer, place):
    compare(writer, f"place_{place}", CASES["places"][place])


async def finished(engine, case: dict[str, Any]):
    async for event in engine.apply(structure(case), []):
        last = event
    assert last.ok, [d.message for s in last.stages for d in s.diagnostics]
    return last


@pytest.mark.full(one_of=6)
@pytest.mark.parametrize("action", CASES["actions"])
async def test_action_shows_its_event(engine, action):
    case = CASES["actions"][action]
    last = await finished(engine, case)
    actor = "E" if any(p["action"] == action for p in case.get("E", {}).get("phases", ())) else f"O{len(case['O'])}"
    shown = {e.event for facts in last.facts for o in facts.objects if o.component == actor for e in o.events}
    assert shown & set(SHOWS[action]["shows"]), shown


@pytest.mark.full(one_of=6)
@pytest.mark.parametrize("place", CASES["places"])
async def test_ego_alone_keeps_to_its_way(engine, place):
    last = await finished(engine, CASES["places"][place])
    shown = {e.event for o in last.facts[0].objects for e in o.events}
    assert last.facts[0].ended_by in ("time", "terminated")
    assert not shown & {"drift", "leave_road", "oncoming_intrusion", "hits"}, shown

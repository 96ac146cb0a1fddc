"""The field's terms (data/terms.yaml): each is said in S, required, and seen in a run of its scene, or says why not."""

from pathlib import Path
from typing import Any

import pytest

from c2s_engine.require import require
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import SPEC_OF, ObjectSpec
from c2s_engine.write.typed import contradiction, reference

TERMS = reference.terms()
SAID = [row for row in TERMS if "S" in row]
PAGE = Path(__file__).parents[2] / "docs" / "TERMS.md"


def structure(said: dict[str, Any]) -> Structure:
    one = {k: Component(id=k, spec=SPEC_OF[k].model_validate(said.get(k, {}))) for k in ("G", "R", "E", "T")}
    objects = tuple(
        Component(id=f"O{i}", spec=ObjectSpec.model_validate({"name": f"actor{i}", **row}))
        for i, row in enumerate(said.get("O", ()), 1)
    )
    return Structure(settings=one["G"], place=one["R"], ego=one["E"], restrictions=one["T"], objects=objects)


def test_the_page_is_up_to_date():
    assert PAGE.read_text(encoding="utf-8") == reference.terms_page()


def test_every_term_is_said_or_says_why_not():
    for row in TERMS:
        assert ("S" in row) != ("not_expressible" in row), row["term"]
    assert len({row["term"] for row in TERMS}) == len(TERMS)


@pytest.mark.parametrize("row", SAID, ids=lambda row: row["term"])
def test_what_it_must_show_is_required_and_nothing_contradicts(row):
    made = structure(row["S"])
    assert contradiction(made) is None
    assert set(row["holds"]) <= {r.id for r in require(made)}


async def shown(engine: Any, row: dict[str, Any]) -> list[str]:
    """What of a term a run does not show."""
    async for event in engine.apply(structure(row["S"]), []):
        last = event
    assert last.ok, [d.message for s in last.stages for d in s.diagnostics]
    found = {r.requirement: r for r in last.results}
    missing = [f"{i}: {found[i].said}; {found[i].seen} {found[i].why}" for i in row["holds"] if not found[i].holds]
    events = {(o.component, e.event) for o in last.facts[0].objects for e in o.events}
    return missing + [f"{c}: {e}" for c, names in row.get("sees", {}).items() for e in names if (c, e) not in events]


@pytest.mark.full
@pytest.mark.parametrize("row", SAID, ids=lambda row: row["term"])
async def test_a_run_shows_it(engine, row):
    assert not await shown(engine, row)


async def test_runs_of_some_show_them(engine):
    for term in ("slowly", "until another has gone by", "stops 1.5 m short of another"):
        assert not await shown(engine, next(row for row in SAID if row["term"] == term))

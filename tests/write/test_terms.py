"""The field's terms (data/terms.yaml): each is said in S, required, written as its golden program, and seen in a run of
its scene, or says why not.

`C2S_GOLDEN=1 pytest tests/write/test_terms.py` writes the programs anew: look at the difference before committing it.
"""

import re
from pathlib import Path
from typing import Any

import pytest

from c2s_engine.require import require
from c2s_engine.structure.components import Structure
from c2s_engine.structure.program import assemble
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.structure.sentences import sentence
from c2s_engine.write.typed import reference
from tests.golden import assert_same
from tests.write.test_golden import structure

TERMS = reference.terms()
SAID = [row for row in TERMS if "S" in row]
GOLDEN = Path(__file__).parent / "golden" / "terms"
PAGE = Path(__file__).parents[2] / "docs" / "TERMS.md"


def program(writer: Any, made: Structure) -> str:
    """The program as the writer makes it, with each component's sentence, before anything is searched for."""
    told = [c.model_copy(update={"description": sentence(c, made)}) for c in made.components]
    for component in told:
        made = made.with_component(component)
    return assemble(regenerate(made, [], writer)[0]).text


def file_of(row: dict[str, Any]) -> Path:
    return GOLDEN / f"{'_'.join(re.findall(r'[a-z0-9]+', row['term'].lower()))}.scenic"


def test_the_page_is_up_to_date():
    assert PAGE.read_text(encoding="utf-8") == reference.terms_page()


def test_every_term_is_said_or_says_why_not():
    for row in TERMS:
        assert ("S" in row) != ("not_expressible" in row), row["term"]
    assert len({row["term"] for row in TERMS}) == len(TERMS)


@pytest.mark.parametrize("row", SAID, ids=lambda row: row["term"])
def test_it_is_required_and_written_as_its_golden_program(writer, row):
    made = structure(row["S"])
    assert set(row["holds"]) <= {r.id for r in require(made)}
    assert_same(program(writer, made), file_of(row))


def test_each_golden_program_is_a_term_s():
    assert sorted(GOLDEN.iterdir()) == sorted(file_of(row) for row in SAID)


async def shown(engine: Any, row: dict[str, Any]) -> list[str]:
    """What of a term a run does not show."""
    async for event in engine.apply(structure(row["S"]), []):
        last = event
    assert last.ok, [d.message for s in last.stages for d in s.diagnostics]
    found = {r.requirement: r for r in last.results}
    missing = [f"{i}: {found[i].said}; {found[i].seen} {found[i].why}" for i in row["holds"] if not found[i].holds]
    events = {(o.component, e.event) for o in last.facts[0].objects for e in o.events}
    return missing + [f"{c}: {e}" for c, names in row.get("sees", {}).items() for e in names if (c, e) not in events]


@pytest.mark.full(one_of=6)
@pytest.mark.parametrize("row", SAID, ids=lambda row: row["term"])
async def test_a_run_shows_it(engine, row):
    assert not await shown(engine, row)


async def test_runs_of_some_show_them(engine):
    for term in (
        "slowly", "until another has gone by", "stops 1.5 m short of another", "weaves, zigzags", "pushes a bicycle",
        "makes way for an emergency vehicle",
    ):  # fmt: skip
        assert not await shown(engine, next(row for row in SAID if row["term"] == term))

"""Specs are closed under compilation: whatever resolves compiles, samples and runs."""

import pytest

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec, Placement, PlaceSpec
from tests.write import closed, draws


async def all_pass(engine, seeds, run: bool = True) -> float:
    """The share of draws that resolve; fails on the first that resolves and does not pass."""
    resolved = 0
    for seed in seeds:
        result, _ = await closed.outcome(engine, draws.structure(seed), run)
        assert result == "ok" or result.startswith("refused"), f"draw {seed}: {result}"
        resolved += result == "ok"
    return resolved / len(seeds)


async def test_a_few_draws(engine):
    assert await all_pass(engine, range(30, 55), run=False) >= 0.7  # of so few; 0.8 of many


@pytest.mark.nightly
async def test_many_draws_run(engine):
    assert await all_pass(engine, range(1000, 1060)) >= 0.75


@pytest.mark.nightly
async def test_thousands_of_draws(engine):
    figures = await closed.draw_all(engine, range(10_000, 12_000))
    assert not figures["failed"]
    assert figures["resolve_percent"] >= 80
    assert figures["iterations"]["median"] < 30


@pytest.mark.full(one_of=3)
@pytest.mark.parametrize("names", closed.pairs()[::37], ids=lambda names: "-".join(names.values()))
async def test_some_pairs_run(engine, names):
    assert await closed.pair_outcome(engine, names) == "ok"


@pytest.mark.nightly
async def test_every_pair_runs(engine):
    figures = await closed.pair_all(engine)
    assert not figures["failed"]


async def test_a_contradiction_names_its_fields(engine):
    structure = Structure(
        place=Component(id="R", spec=PlaceSpec(kind="motorway", oncoming=True)),
        objects=(Component(id="O1", spec=ObjectSpec(name="a")),),
    )
    async for event in engine.apply(structure, []):
        last = event
    assert not last.ok
    assert "R.oncoming" in last.diagnostics[0].text
    assert "motorway" in last.diagnostics[0].message


@pytest.mark.full
async def test_works_stand_behind_another(engine):
    ahead = ObjectSpec(name="van", type="van", placement=Placement(position="parked", gap=100))
    works = ObjectSpec(name="works", type="lane_closure", placement=Placement(position="behind", of="O1", gap=30))
    structure = Structure(
        place=Component(id="R", spec=PlaceSpec(kind="straight")),
        objects=(Component(id="O1", spec=ahead), Component(id="O2", spec=works)),
    )
    assert (await closed.outcome(engine, structure, run=False))[0] == "ok"

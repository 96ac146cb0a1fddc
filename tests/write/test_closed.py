"""Specs are closed under compilation: whatever resolves compiles, samples and runs."""

import draws
import pytest

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec, PlaceSpec


async def outcome(engine, structure: Structure, run: bool = True) -> str:
    """ "ok", "refused: why" or the first failing stage with its message."""
    async for event in engine.apply(structure, [], run=run):
        last = event
    for stage in last.stages:
        if not stage.ok:
            message = stage.diagnostics[0].message if stage.diagnostics else "?"
            return f"refused: {message}" if stage.name == "resolve" else f"{stage.name}: {message}"
    return "ok"


async def all_pass(engine, seeds, run: bool = True) -> float:
    """The share of draws that resolve; fails on the first that resolves and does not pass."""
    resolved = 0
    for seed in seeds:
        result = await outcome(engine, draws.structure(seed), run)
        assert result == "ok" or result.startswith("refused"), f"draw {seed}: {result}"
        resolved += result == "ok"
    return resolved / len(seeds)


async def test_a_few_draws(engine):
    assert await all_pass(engine, range(25), run=False) > 0.4


@pytest.mark.full
async def test_many_draws_run(engine):
    assert await all_pass(engine, range(1000, 1060)) > 0.4


@pytest.mark.nightly
async def test_thousands_of_draws(engine):
    assert await all_pass(engine, range(10_000, 12_000)) > 0.4


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

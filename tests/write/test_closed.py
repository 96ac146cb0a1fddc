"""Specs are closed under compilation: whatever resolves compiles, samples and runs."""

import typing

import draws
import pytest

from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec, PlaceSpec
from c2s_engine.write.typed.contradictions import contradictions


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
    assert await all_pass(engine, range(25), run=False) >= 0.7  # of so few; 0.8 of many


@pytest.mark.full
async def test_many_draws_run(engine):
    assert await all_pass(engine, range(1000, 1060)) >= 0.75


@pytest.mark.nightly
async def test_thousands_of_draws(engine):
    assert await all_pass(engine, range(10_000, 12_000)) >= 0.8


def pairs() -> list[dict[str, str]]:
    """Every action with every position and every kind of place, but for those that contradict."""
    actions, positions, places = (typing.get_args(x) for x in (v.Action, v.Position, v.PlaceKind))
    found = [{"action": a, "position": p} for a in actions for p in positions]
    found += [{"action": a, "kind": k} for a in actions for k in places]
    return [f for f in found if not any(c.pairs(**_as_row(f)) for c in contradictions())]


def _as_row(names: dict[str, str]) -> dict[str, str]:
    return {{"kind": "place"}.get(key, key): name for key, name in names.items()}


async def pair_passes(engine, names: dict[str, str]) -> None:
    """The first of a pair's draws that resolves compiles, samples and runs; one of eight does resolve."""
    for seed in range(8):
        result = await outcome(engine, draws.structure(seed, **names))
        assert result == "ok" or result.startswith("refused"), f"{names}, draw {seed}: {result}"
        if result == "ok":
            return
    raise AssertionError(f"no draw of {names} resolves")


@pytest.mark.full
@pytest.mark.parametrize("names", pairs()[::37], ids=lambda names: "-".join(names.values()))
async def test_some_pairs_run(engine, names):
    await pair_passes(engine, names)


@pytest.mark.nightly
async def test_every_pair_runs(engine):
    for names in pairs():
        await pair_passes(engine, names)


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

"""Stability: whether two texts that mean the same require the same of a run."""

import asyncio
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import permutations
from pathlib import Path
from typing import Any

import yaml

from c2s_bench.host import factory_of
from c2s_bench.records import BenchmarkError
from c2s_bench.tasks import Setup
from c2s_engine.structure.components import Structure
from c2s_engine.structure.progress import Finished

PAIRS = Path(__file__).with_name("rewording.yaml")
MOST_OBJECTS = 5
"""Objects up to which every way to match them is tried; beyond, they are taken in their order."""


@dataclass(frozen=True)
class Pair:
    """Two texts, the share of what either requires that both do, and what only one of them requires."""

    texts: tuple[str, str]
    share: float
    differ: tuple[str, ...]


def read_pairs(file: Path) -> list[tuple[str, str]]:
    """The pairs of a YAML file; raises BenchmarkError."""
    try:
        found = yaml.safe_load(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise BenchmarkError(f"{file} cannot be read: {str(error).splitlines()[0]}") from None
    whole = isinstance(found, list) and found and all(
        isinstance(p, list) and len(p) == 2 and all(isinstance(t, str) and t.strip() for t in p) for p in found
    )  # fmt: skip
    if not whole:
        raise BenchmarkError(f"{file} is no list of pairs: give a YAML list of lists of two texts")
    return [(a, b) for a, b in found]


def compared(a: Structure, b: Structure) -> tuple[float, tuple[str, ...]]:
    """The share of requirements that both have, objects matched as well as may be, and those that one has alone."""
    mine, ids = _required(a), [o.id for o in b.objects]
    theirs = _required(b)
    orders = permutations(ids) if 1 < len(ids) <= MOST_OBJECTS else [tuple(ids)]
    best = max(
        (_renamed(theirs, dict(zip(ids, order, strict=True))) for order in orders),
        key=lambda them: len(mine & them),
    )
    alone = sorted(mine ^ best)
    return len(mine & best) / max(1, len(mine | best)), tuple(json.loads(x)[0] for x in alone)


def _required(structure: Structure) -> set[str]:
    """What S requires, without sentences and clauses, which a rewording may change."""
    from c2s_engine.require import require

    return {json.dumps([r.id, r.check, r.actor, r.other, r.values], sort_keys=True) for r in require(structure)}


def _renamed(required: set[str], names: dict[str, str]) -> set[str]:
    renamed = set()
    for one in required:
        for old, new in names.items():
            one = (
                one.replace(f'"{old}"', f'"<{new}>"').replace(f'"{old}.', f'"<{new}>.').replace(f"{old} ", f"<{new}> ")
            )
        renamed.add(one.replace("<", "").replace(">", ""))
    return renamed


def stability(pairs: Sequence[tuple[str, str]], setup: Setup, engine: str, told: Callable[[int], None]) -> list[Pair]:
    """Each pair as the method reads it. Programs are written and checked, and not run."""

    async def all_pairs() -> list[Pair]:
        found = []
        async with factory_of(engine)(setup) as running:
            for number, texts in enumerate(pairs, 1):
                one, other = [await _structure(running, text, setup) for text in texts]
                found.append(Pair(texts, *compared(one, other)))
                told(number)
        return found

    return asyncio.run(all_pairs())


async def _structure(engine: Any, text: str, setup: Setup) -> Structure:
    async for event in engine.generate(text, method=setup.method, map=setup.map, seed=setup.seed, run=False):
        if isinstance(event, Finished):
            return event.structure
    return Structure()


def markdown(pairs: Sequence[Pair], every: bool) -> str:
    """The shares, and of the pairs that differ (all that do with `every`, else the worst ten) in what."""
    same = sum(1 for p in pairs if p.share == 1.0)
    lines = [f"{same} of {len(pairs)} pairs require the same ({100 * same / len(pairs):.0f} %); "
             f"on average {100 * sum(p.share for p in pairs) / len(pairs):.1f} % of what either requires."]  # fmt: skip
    worst = sorted((p for p in pairs if p.share < 1.0), key=lambda p: p.share)
    for pair in worst if every else worst[:10]:
        only = ", ".join(dict.fromkeys(pair.differ))
        lines += ["", f"{100 * pair.share:.0f} %: {pair.texts[0]}", f"      {pair.texts[1]}", f"      differ: {only}"]
    return "\n".join(lines)

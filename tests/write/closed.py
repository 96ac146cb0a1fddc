"""Are specs closed under compilation? `python -m tests.write.closed draws|pairs [--first N] [--count N]`.

`draws`: random structures; how many resolve, and whether all of those compile, sample and run. `pairs`: every action
with every position and every kind of place is run in a draw, or listed as a contradiction with its reason. Figures are
kept in benchmark/results/closed.json as they come; the exit status is 1 where one that resolves does not pass.
"""

import argparse
import asyncio
import json
import re
import statistics
import sys
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any, get_args

from c2s_engine.api import Engine
from c2s_engine.paths import shipped
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Structure
from c2s_engine.write.typed.contradictions import contradictions
from tests.write import draws

RESULT = Path(__file__).resolve().parents[2] / "benchmark" / "results" / "closed.json"
TRIES = 8
"""Draws of one pair, of which one must resolve."""


async def outcome(engine: Engine, structure: Structure, run: bool = True) -> tuple[str, str]:
    """ "ok", "refused: why" or the first failing stage with its message; and the program where there is one."""
    last: Any = None
    async for event in engine.apply(structure, [], run=run):
        last = event
    for stage in last.stages:
        if not stage.ok:
            message = stage.diagnostics[0].message if stage.diagnostics else "?"
            return f"{'refused' if stage.name == 'resolve' else stage.name}: {message}", ""
    return "ok", last.program.text


async def draw_all(engine: Engine, seeds: Iterable[int], keep: bool = False) -> dict[str, Any]:
    """The figures of the draws; the sampler's rejections are taken from every tenth that resolves."""
    reasons: Counter[str] = Counter()
    iterations: list[int] = []
    found: dict[str, Any] = {"draws": 0, "resolve": 0, "pass": 0, "failed": {}}
    for seed in seeds:
        result, program = await outcome(engine, draws.structure(seed))
        found["draws"] += 1
        if result.startswith("refused"):
            reasons[_kind(result)] += 1
        else:
            found["resolve"] += 1
            found["pass"] += result == "ok"
            if result != "ok":
                found["failed"][str(seed)] = result
                print(f"draw {seed}: {result}", flush=True)
            elif found["pass"] % 10 == 0:
                report = await engine.check(program, upto="sample", runs=3, folder=str(shipped("maps")))
                iterations += report.iterations
        if keep and found["draws"] % 50 == 0:
            _keep("draws", _figures(found, reasons, iterations))
    return _figures(found, reasons, iterations)


def _figures(found: dict[str, Any], reasons: Counter[str], iterations: list[int]) -> dict[str, Any]:
    share = round(100 * found["resolve"] / max(found["draws"], 1), 1)
    tries = {
        "scenes": len(iterations),
        "median": statistics.median(iterations or [0]),
        "most": max(iterations, default=0),
    }
    return {**found, "resolve_percent": share, "iterations": tries, "refused": dict(reasons.most_common())}


def _kind(message: str) -> str:
    """A refusal without its names and numbers, so that like ones are counted together."""
    return re.sub(r"\bO\d+\b", "O", re.sub(r"\d+(\.\d+)?", "N", message)).split(". ")[0].removeprefix("refused: ")


def all_pairs() -> list[dict[str, str]]:
    """Every action with every position and with every kind of place."""
    actions, positions, places = (get_args(x) for x in (v.Action, v.Position, v.PlaceKind))
    found = [{"action": a, "position": p} for a in actions for p in positions]
    return found + [{"action": a, "kind": k} for a in actions for k in places]


def contradiction(names: dict[str, str]) -> str:
    """The reason of the row that rules a pair out; "": none does."""
    row = {{"kind": "place"}.get(key, key): name for key, name in names.items()}
    return next((c.because for c in contradictions() if c.pairs(**row)), "")


def pairs() -> list[dict[str, str]]:
    """All pairs but those that contradict."""
    return [names for names in all_pairs() if not contradiction(names)]


async def pair_outcome(engine: Engine, names: dict[str, str]) -> str:
    """The first of a pair's draws that resolves: "ok", or what went wrong with it; else that none resolves."""
    for seed in range(TRIES):
        result, _ = await outcome(engine, draws.structure(seed, **names))
        if not result.startswith("refused"):
            return result if result == "ok" else f"draw {seed}: {result}"
    return f"none of {TRIES} draws resolves"


async def pair_all(engine: Engine, keep: bool = False) -> dict[str, Any]:
    """The figures of all pairs, with the reason of each that is ruled out."""
    found: dict[str, Any] = {"pairs": len(all_pairs()), "covered": 0, "failed": {}, "contradict": {}}
    for names in all_pairs():
        name = " x ".join(names.values())
        if because := contradiction(names):
            found["contradict"].setdefault(because, []).append(name)
            continue
        result = await pair_outcome(engine, names)
        found["covered"] += result == "ok"
        if result != "ok":
            found["failed"][name] = result
            print(f"{name}: {result}", flush=True)
        if keep:
            _keep("pairs", found)
    return found


def _keep(part: str, figures: dict[str, Any]) -> None:
    kept = json.loads(RESULT.read_text(encoding="utf-8")) if RESULT.exists() else {}
    text = json.dumps(kept | {part: figures}, indent=1, ensure_ascii=False) + "\n"
    RESULT.write_text(text, encoding="utf-8")


async def _main(options: argparse.Namespace) -> int:
    async with Engine() as engine:
        if options.part == "draws":
            seeds = range(options.first, options.first + options.count)
            figures = {"first": options.first, **await draw_all(engine, seeds, keep=True)}
        else:
            figures = await pair_all(engine, keep=True)
    _keep(options.part, figures)
    print(json.dumps({k: x for k, x in figures.items() if k != "contradict"}, indent=1))
    return int(bool(figures["failed"]))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("part", choices=("draws", "pairs"))
    parser.add_argument("--first", type=int, default=10_000, help="seed of the first draw")
    parser.add_argument("--count", type=int, default=2000)
    sys.exit(asyncio.run(_main(parser.parse_args())))

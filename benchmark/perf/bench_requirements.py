"""What requirements cost a run: deriving them from S and evaluating them on its facts and tracks, in the front process.

`python -m c2s_bench.perf.bench_requirements`: for the texts of four_actors.yaml, medians over `--rounds` (ms). The goal
is 30 ms together with the courses (`bench_dryrun` has those).
"""

import argparse
import asyncio
import os
import statistics
import time
from pathlib import Path
from typing import Any

import yaml

from c2s_engine.api import Engine
from c2s_engine.require import evaluate, require
from c2s_engine.structure.progress import Finished, RunDone

TEXTS = Path(__file__).parent / "four_actors.yaml"


async def runs() -> list[tuple[Any, Any, Any]]:
    """(S, facts, trajectories) of every text that runs."""
    found = []
    async with Engine() as engine:
        for text in yaml.safe_load(TEXTS.read_text(encoding="utf-8")):
            ways, done = None, None
            async for event in engine.generate(text, map="town", trajectories=True):
                if isinstance(event, RunDone):
                    ways = event.trajectories
                elif isinstance(event, Finished):
                    done = event
            if done is not None and done.facts and ways is not None:
                found.append((done.structure, done.facts[0], ways))
    return found


def milliseconds(structure: Any, facts: Any, ways: Any, rounds: int) -> float:
    """The median over the rounds; the first, which reads the tables, does not count."""
    taken = []
    for _ in range(rounds + 1):
        began = time.perf_counter()
        evaluate(require(structure), facts, ways)
        taken.append((time.perf_counter() - began) * 1000)
    return statistics.median(taken[1:])


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    rows = sorted(milliseconds(*run, rounds) for run in asyncio.run(runs()))
    middle = statistics.median(rows)
    print(f"{len(rows)} runs, load {os.getloadavg()[0]:.1f}: median {middle:.1f} ms, most {rows[-1]:.1f} ms")


if __name__ == "__main__":
    main()

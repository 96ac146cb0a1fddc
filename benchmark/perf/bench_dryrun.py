"""How long the dry run of 20 s with four actors takes, in one process: `python -m c2s_bench.perf.bench_dryrun`.

The programs are written anew from the texts of four_actors.yaml (so they are what the writer writes now), compiled with
the stock CARLA model, and the first scene that runs for 20 s is run `--rounds` times more. Prints CPU and wall time
(ms) of the simulation, of the events derived from it, and of the courses that requirements read. The goal is the
simulation's wall time on one quiet core.
"""

import argparse
import asyncio
import json
import os
import platform
import shutil
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.api import Engine
from c2s_engine.check import warm

HERE = Path(__file__).parent
RESULT = HERE.parent / "results" / "dryrun.json"
SECONDS = 20.0
ACTORS = 4
SEEDS = 8
GOAL = {"median": 350.0, "p95": 600.0}


async def write_programs(folder: Path) -> list[Path]:
    """The program of every text, with the town beside them."""
    texts = yaml.safe_load((HERE / "four_actors.yaml").read_text(encoding="utf-8"))
    shutil.copy(paths.shipped("maps", "town.xodr"), folder)
    found = []
    async with Engine() as engine:
        for number, text in enumerate(texts, 1):
            finished: Any = None
            async for event in engine.generate(text, map="town", run=False):
                finished = event
            if not finished.ok:
                print(f"text {number} gives no program that samples", file=sys.stderr)
                continue
            found.append(folder / f"{number:02}.scenic")
            found[-1].write_text(finished.program.text, encoding="utf-8")
    return found


def compile_scene(path: Path, seed: int = 0) -> Any:
    """A sampled scene of the program."""
    import scenic

    warm.reseed(seed)
    scenario = scenic.scenarioFromFile(str(path), mode2D=True)
    scene, _ = scenario.generate(maxIterations=2000)
    return scene


def timed(work: Any) -> tuple[float, float, Any]:
    """(CPU ms, wall ms, result)."""
    cpu, wall = time.process_time(), time.perf_counter()
    result = work()
    return (time.process_time() - cpu) * 1000, (time.perf_counter() - wall) * 1000, result


def run(scene: Any) -> Any:
    """One run of the scene, of 20 s where nothing ends it sooner."""
    from c2s_engine.dryrun import runner

    names = {id(o): f"o{i}" for i, o in enumerate(scene.objects)} | {id(scene.egoObject): "ego"}
    warm.reseed(0)
    return runner.simulate(scene, names=names, seed=0, seconds=SECONDS, map_path=str(scene.params["map"]))


def whole(path: Path) -> Any:
    """The first scene with four actors that runs for 20 s without a collision; None where the first seeds give none."""
    for seed in range(SEEDS):
        scene = compile_scene(path, seed)
        if len(scene.objects) == ACTORS and run(scene).duration >= SECONDS - 0.05:
            return scene
    print(f"{path.stem}: no scene with {ACTORS} actors runs for {SECONDS:.0f} s", file=sys.stderr)
    return None


def measure(path: Path, rounds: int) -> dict[str, Any] | None:
    """The medians over the rounds (ms) of one program; None where it has no whole run."""
    from c2s_engine.dryrun.events.courses import courses
    from c2s_engine.dryrun.events.derivation import derive
    from c2s_engine.dryrun.events.situation import Situation
    from c2s_engine.dryrun.roads import index_of

    scene = whole(path)
    if scene is None:
        return None
    index = index_of(scene.workspace.network)
    rows: list[dict[str, float]] = []
    for _ in range(rounds):
        cpu, wall, done = timed(lambda: run(scene))
        more_cpu, more_wall, _ = timed(lambda: derive(done.recording, index, done.extras))  # noqa: B023
        situation = Situation(done.recording, index, done.extras)
        _, ways, _ = timed(lambda: courses(situation))  # noqa: B023
        rows.append({"cpu": cpu, "wall": wall, "events_cpu": more_cpu, "events_wall": more_wall, "courses": ways})
    return {"program": path.stem} | {key: round(statistics.median(row[key] for row in rows), 1) for key in rows[0]}


def summary(rows: list[dict[str, Any]]) -> dict[str, dict[str, float]]:
    """Median and 95th percentile over the programs (of CPU and wall, simulation and events together too)."""
    columns = {key: [row[key] for row in rows] for key in ("cpu", "wall", "events_cpu", "events_wall", "courses")}
    columns["both_cpu"] = [row["cpu"] + row["events_cpu"] for row in rows]
    columns["both_wall"] = [row["wall"] + row["events_wall"] for row in rows]
    return {key: {"median": round(statistics.median(values), 1), "p95": round(percentile(values, 0.95), 1)}
            for key, values in columns.items()}  # fmt: skip


def percentile(values: list[float], share: float) -> float:
    """Linear between the ranks."""
    ordered = sorted(values)
    at = share * (len(ordered) - 1)
    low = int(at)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (ordered[high] - ordered[low]) * (at - low)


def main() -> None:
    """Measure, print, keep."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5, help="runs of each scene")
    parser.add_argument("--programs", type=Path, help="a folder with programs (and the town) instead of the texts")
    parser.add_argument("--keep", action="store_true", help=f"write {RESULT.name} among the results")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        programs = sorted(options.programs.glob("*.scenic")) if options.programs \
            else asyncio.run(write_programs(Path(name)))  # fmt: skip
        warm.warm(paths.shipped("standins"), "c2s_engine.dryrun.runner:run_scene")
        rows = [row for path in programs if (row := measure(path, options.rounds))]
    if not rows:
        sys.exit("No program with four actors could be run.")
    show(rows)
    if options.keep:
        report = {"machine": f"{os.cpu_count()} x {platform.processor() or platform.machine()}",
                  "load": round(os.getloadavg()[0], 1), "summary": summary(rows), "programs": rows}  # fmt: skip
        RESULT.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def show(rows: list[dict[str, Any]]) -> None:
    """A row a program, then median and 95th percentile."""
    print(f"{len(rows)} programs, {SECONDS:.0f} s each, load {os.getloadavg()[0]:.1f}; milliseconds")
    print(f"{'program':>8}{'cpu':>8}{'wall':>8}{'events cpu':>12}{'events wall':>12}")
    for row in rows:
        print(
            f"{row['program']:>8}{row['cpu']:8.0f}{row['wall']:8.0f}{row['events_cpu']:12.0f}{row['events_wall']:12.0f}"
        )
    for name, values in summary(rows).items():
        print(f"{name:>12}: median {values['median']:6.0f}   p95 {values['p95']:6.0f}")
    print(f"goal (wall): median {GOAL['median']:.0f}, p95 {GOAL['p95']:.0f}")


if __name__ == "__main__":
    main()

"""How long the dry run of 20 s with four actors takes, in one process: `python -m c2s_bench.perf.bench_dryrun`.

The programs are written anew from the texts of four_actors.yaml (so they are what the writer writes now), compiled with
the stock CARLA model, and each scene is run once for the caches and then `--rounds` times. Prints CPU and wall time
(ms) of the simulation and of the events derived from it; the goal is for both together, wall time, on a quiet machine.
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


def compile_scene(path: Path) -> Any:
    """A sampled scene of the program, and the names of its objects."""
    import scenic

    warm.reseed(0)
    scenario = scenic.scenarioFromFile(str(path), mode2D=True)
    scene, _ = scenario.generate(maxIterations=2000)
    return scene


def timed(work: Any) -> tuple[float, float, Any]:
    """(CPU ms, wall ms, result)."""
    cpu, wall = time.process_time(), time.perf_counter()
    result = work()
    return (time.process_time() - cpu) * 1000, (time.perf_counter() - wall) * 1000, result


def measure(path: Path, rounds: int) -> dict[str, Any] | None:
    """The times of one program; None where its scene has another number of actors or does not run through."""
    from c2s_engine.dryrun import runner
    from c2s_engine.dryrun.events.derivation import derive
    from c2s_engine.dryrun.roads import index_of

    scene = compile_scene(path)
    names = {id(o): f"o{i}" for i, o in enumerate(scene.objects)} | {id(scene.egoObject): "ego"}
    town = str(scene.params["map"])
    rows: list[dict[str, float]] = []
    ended, covered = "", 0.0
    if len(scene.objects) != ACTORS:
        print(f"{path.stem}: {len(scene.objects)} objects, not {ACTORS}", file=sys.stderr)
        return None
    for _ in range(rounds + 1):
        warm.reseed(0)
        cpu, wall, run = timed(
            lambda: runner.simulate(scene, names=names, seed=0, seconds=SECONDS, map_path=town)
        )
        if run.ended_by in ("error", "rejected") or run.recording is None:
            print(f"{path.stem}: {run.ended_by}: {run.reason}", file=sys.stderr)
            return None
        index = index_of(scene.workspace.network)
        more_cpu, more_wall, _ = timed(lambda: derive(run.recording, index, run.extras))  # noqa: B023
        rows.append({"cpu": cpu, "wall": wall, "events_cpu": more_cpu, "events_wall": more_wall})
        ended, covered = run.ended_by, run.duration
    scale = SECONDS / covered
    return {"program": path.stem, "ended": ended, "seconds": round(covered, 1)} | {
        key: round(statistics.median(row[key] for row in rows[1:]) * scale, 1) for key in rows[0]
    }


def summary(rows: list[dict[str, Any]]) -> dict[str, dict[str, float]]:
    """Median and 95th percentile over the programs (of CPU and wall, simulation and events together too)."""
    columns = {key: [row[key] for row in rows] for key in ("cpu", "wall", "events_cpu", "events_wall")}
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
    print(f"{'program':>8}{'ended':>12}{'at s':>6}{'cpu':>8}{'wall':>8}{'events cpu':>12}{'events wall':>12}")
    for row in rows:
        print(f"{row['program']:>8}{row['ended']:>12}{row['seconds']:6.1f}{row['cpu']:8.0f}{row['wall']:8.0f}"
              f"{row['events_cpu']:12.0f}{row['events_wall']:12.0f}")  # fmt: skip
    for name, values in summary(rows).items():
        print(f"{name:>12}: median {values['median']:6.0f}   p95 {values['p95']:6.0f}")
    print(f"goal (both_wall): median {GOAL['median']:.0f}, p95 {GOAL['p95']:.0f}")


if __name__ == "__main__":
    main()

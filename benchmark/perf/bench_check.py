"""How fast a check is, against the plain `scenic` command and the stock compiler in one process. `make bench-check`.

Same program, same machine, same run, caches warm. Prints a table with ratios and keeps it in benchmark/results.
"""

import argparse
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest

PROGRAM = Path(__file__).with_name("program.scenic").read_text(encoding="utf-8")
RESULT = Path(__file__).resolve().parents[1] / "results" / "check.json"
WRONG = PROGRAM.replace("Range(15, 30)", "Range(15, 30", 1)
UNDEFINED = PROGRAM.replace("Range(15, 30)", "Rage(15, 30)", 1)
EDITS: dict[str, tuple[str, Callable[[int], str]]] = {
    "syntax error": ("compile", lambda i: PROGRAM.replace("Range(15, 30)", f"Range(15, {30 + i}", 1)),
    "undefined name": ("compile", lambda i: PROGRAM.replace("Range(15, 30)", f"Rage(15, {30 + i})", 1)),
    "object edited, compiled": ("compile", lambda i: PROGRAM.replace("Range(15, 30)", f"Range(15, {30 + i})", 1)),
    "object edited, sampled": ("sample", lambda i: PROGRAM.replace("Range(8, 12)", f"Range(8, {12 + i})", 1)),
    "settings edited, compiled": ("compile", lambda i: PROGRAM.replace("'ClearNoon'", f"{{'cloudiness': {i}}}", 1)),
}
TARGETS = {  # ms: median, 95th percentile (of issue 6)
    "syntax error": (20, None),
    "undefined name": (20, None),
    "object edited, compiled": (50, 100),
    "object edited, sampled": (120, 500),
    "settings edited, compiled": (250, None),
}
STOCK = """
import json, sys, time
sys.path.insert(0, sys.argv[1])
import random
from scenic.syntax.translator import scenarioFromFile
def once(path, sample):
    begun = time.perf_counter()
    try:
        scenario = scenarioFromFile(path, mode2D=True)
        if sample:
            random.seed(0)
            scenario.generate(maxIterations=2000)
    except Exception:
        pass
    return (time.perf_counter() - begun) * 1000
good, wrong, undefined = sys.argv[2:5]
once(good, True)
times = {"syntax error": (wrong, False), "undefined name": (undefined, False), "object edited, compiled": (good, False),
         "object edited, sampled": (good, True), "settings edited, compiled": (good, False)}
print(json.dumps({k: sorted(once(p, s) for _ in range(5))[2] for k, (p, s) in times.items()}))
"""


def main() -> None:
    """Measure, print, keep."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=40)
    parser.add_argument("--commands", type=int, default=5, help="runs of the scenic command")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        shutil.copy(paths.shipped("maps", "town.xodr"), folder)
        ours = measure_ours(folder, options.rounds)
        files = write_programs(folder)
        stock = measure_stock(files)
        command = measure_command(files, options.commands)
    report = {"machine": f"{os.cpu_count()} x {platform.processor() or platform.machine()}", "rounds": options.rounds,
              "load": os.getloadavg()[0], "ours": ours, "stock": stock, "command": command}  # fmt: skip
    show(report)
    RESULT.parent.mkdir(parents=True, exist_ok=True)
    RESULT.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def measure_ours(folder: Path, rounds: int) -> dict[str, dict[str, float]]:
    """Milliseconds from the edit to the verdict, over the pipe, for each kind of edit."""
    found = {}
    with SyncCheckClient() as client:
        client.check(CheckRequest(program=PROGRAM, folder=str(folder)))
        for name, (upto, edit) in EDITS.items():
            times = []
            for i in range(rounds):
                request = CheckRequest(program=edit(i), folder=str(folder), upto=upto, seed=i)  # type: ignore[arg-type]
                begun = time.perf_counter()
                client.check(request)
                times.append((time.perf_counter() - begun) * 1000)
            times.sort()
            found[name] = {
                "median": statistics.median(times),
                "p90": times[int(0.9 * (rounds - 1))],
                "p95": times[int(0.95 * (rounds - 1))],
            }
    return found


def write_programs(folder: Path) -> list[str]:
    """The program as it is, with a syntax error, with an undefined name."""
    files = []
    for name, text in (("good", PROGRAM), ("wrong", WRONG), ("undefined", UNDEFINED)):
        path = folder / f"{name}.scenic"
        path.write_text(text, encoding="utf-8")
        files.append(str(path))
    return files


def measure_stock(files: list[str]) -> dict[str, float]:
    """The stock compiler, warm, in one process."""
    command = [sys.executable, "-c", STOCK, str(paths.shipped("standins")), *files]
    out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return json.loads(out.splitlines()[-1])


def measure_command(files: list[str], runs: int) -> dict[str, float]:
    """The plain `scenic` command that samples one scene (it compiles first), with the map's cache warm."""
    environment = dict(os.environ, PYTHONPATH=str(paths.shipped("standins")))
    names = ("object edited, sampled", "syntax error", "undefined name")
    found = {}
    for name, file in zip(names, files, strict=True):
        command = [sys.executable, "-m", "scenic", "--2d", "--gather-stats", "1", file]
        times = []
        for _ in range(runs):
            begun = time.perf_counter()
            subprocess.run(command, capture_output=True, env=environment)
            times.append((time.perf_counter() - begun) * 1000)
        found[name] = statistics.median(times)
    found["object edited, compiled"] = found["settings edited, compiled"] = found["object edited, sampled"]
    return found


def show(report: dict) -> None:
    """The table: medians in ms, and how many times faster."""
    print(f"{report['machine']}, load {report['load']:.1f}, {report['rounds']} rounds; milliseconds")
    print(f"{'':28}{'median':>8}{'p90':>7}{'p95':>7}{'target':>8}{'scenic':>9}{'ratio':>7}{'stock':>8}{'ratio':>7}")
    for name, ours in report["ours"].items():
        command, stock = report["command"][name], report["stock"][name]
        print(
            f"{name:28}{ours['median']:8.0f}{ours['p90']:7.0f}{ours['p95']:7.0f}{TARGETS[name][0]:8}"
            f"{command:9.0f}{command / ours['median']:7.1f}{stock:8.0f}{stock / ours['median']:7.1f}"
        )


if __name__ == "__main__":
    main()

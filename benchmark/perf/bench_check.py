"""How fast a check is, against the plain `scenic` command and the stock compiler in one process. `make bench-check`.

Same program, same machine, same run, caches warm; on the shipped town and on CARLA's Town04 and Town10HD, where
../shared/maps or $C2S_SHARED_MAPS has them. Prints a table with ratios and keeps it in benchmark/results. `cpu` is what
all processes used for a check, also before and after it.
"""

import argparse
import contextlib
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
from typing import Any

from c2s_bench.perf import soak_check
from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest

PROGRAM = Path(__file__).with_name("program.scenic").read_text(encoding="utf-8")
RESULT = Path(__file__).resolve().parents[1] / "results" / "check.json"
MAPS = ("town", "Town04", "Town10HD")
TOWNS = Path(os.environ.get("C2S_SHARED_MAPS") or Path(__file__).resolve().parents[3] / "shared" / "maps")
PAUSE = 0.5  # s between one verdict and the next edit: the child for the next check is made ready meanwhile
OBJECT, SETTINGS, MAP = "Range(15, 30)", "model scenic", "town.xodr"
RUNNER = "c2s_engine.dryrun.runner:run_scene"  # as the app starts the server


def _object(new: str) -> Callable[[int], str]:
    return lambda i: PROGRAM.replace(OBJECT, new % (30 + i / 10), 1)


def _settings(line: str) -> Callable[[int], str]:
    return lambda i: PROGRAM.replace(SETTINGS, f"{line % (i + 1)}\n{SETTINGS}", 1)


def _weather(i: int) -> str:
    return PROGRAM.replace("'ClearNoon'", f"{{'cloudiness': {i}}}", 1)


def _in_turn(i: int) -> str:
    """An object edited, then what stands above it, then the object again: what was done ahead seldom fits."""
    return _object("Range(15, %g)")(i) if i % 2 else _weather(i)


def _map(name: str) -> Callable[[int], str]:
    return lambda i: PROGRAM.replace(MAP, name.format(i), 1)


EDITS: dict[str, tuple[str, Callable[[int], str]]] = {
    "syntax error": ("compile", _object("Range(15, %g")),
    "undefined name": ("compile", _object("Rage(15, %g)")),
    "object edited, compiled": ("compile", _object("Range(15, %g)")),
    "object edited, sampled": ("sample", _object("Range(15, %g)")),
    "two edited in turn, compiled": ("compile", _in_turn),
    "weather edited, compiled": ("compile", _weather),
    "other settings, compiled": ("compile", _settings("param setting_%d = 1")),
    "map edited, back, compiled": ("compile", lambda i: _map((MAP, "other.xodr")[i % 2])(i)),
    "map edited, new, compiled": ("compile", _map("map_{}.xodr")),  # parsed once, but not read by this server
}
TARGETS = {  # ms: median, 95th percentile (sampled: 90th) of issue 6
    "syntax error": (20, None),
    "undefined name": (20, None),
    "object edited, compiled": (50, 100),
    "object edited, sampled": (120, 500),
    "two edited in turn, compiled": (50, 100),
    "weather edited, compiled": (250, None),
    "other settings, compiled": (250, None),
    "map edited, back, compiled": (250, None),
    "map edited, new, compiled": (250, None),
}
AS_GOOD = tuple(edit for edit in EDITS if edit.endswith("compiled"))
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
         "object edited, sampled": (good, True)}
print(json.dumps({k: sorted(once(p, s) for _ in range(5))[2] for k, (p, s) in times.items()}))
"""


def main() -> None:
    """Measure, print, keep."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=40)
    parser.add_argument("--commands", type=int, default=5, help="runs of the scenic command")
    parser.add_argument("--map", choices=("all", *MAPS), default="all")
    options = parser.parse_args()
    report: dict[str, Any] = {
        "machine": f"{os.cpu_count()} x {platform.processor() or platform.machine()}",
        "rounds": options.rounds,
        "maps": {},
    }
    for name in MAPS if options.map == "all" else (options.map,):
        if not map_file(name).is_file():
            print(f"{name} is left out: there is no {map_file(name)} ($C2S_SHARED_MAPS may name another folder).")
            continue
        with tempfile.TemporaryDirectory() as folder:
            before = os.getloadavg()[0]
            report["maps"][name] = {**measure(name, Path(folder), options.rounds, options.commands), "load": before}
        show(name, report)
    if not report["maps"]:
        return
    RESULT.parent.mkdir(parents=True, exist_ok=True)
    RESULT.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def measure(name: str, folder: Path, rounds: int, commands: int) -> dict[str, Any]:
    """All figures on one map, which lies in the folder as town.xodr."""
    shutil.copy(map_file(name), folder / MAP)
    files = write_programs(folder)
    stock = measure_stock(files)
    return {"ours": measure_ours(folder, rounds), "stock": stock, "command": measure_command(files, commands)}


def map_file(name: str) -> Path:
    """Where a map of the benchmark is, or would be."""
    return paths.shipped("maps", MAP) if name == "town" else TOWNS / f"{name}.xodr"


def measure_ours(folder: Path, rounds: int) -> dict[str, dict[str, float]]:
    """Milliseconds from the edit to the verdict, over the pipe, for each kind of edit; CPU time of all processes."""
    found = {}
    for name in ("other.xodr", *(f"map_{i}.xodr" for i in range(rounds))):
        if not (folder / name).exists():
            os.link(folder / MAP, folder / name)
    with SyncCheckClient(RUNNER) as client:
        for program in (PROGRAM, _map("other.xodr")(0)):
            client.check(CheckRequest(program=program, folder=str(folder)))
        for name, (upto, edit) in EDITS.items():
            times = []
            time.sleep(PAUSE)
            used = _cpu(client.pid)
            for i in range(rounds):
                time.sleep(PAUSE)
                request = CheckRequest(program=edit(i), folder=str(folder), upto=upto, seed=i)  # type: ignore[arg-type]
                begun = time.perf_counter()
                client.check(request)
                times.append((time.perf_counter() - begun) * 1000)
            time.sleep(PAUSE)
            times.sort()
            found[name] = {
                "least": times[0],
                "median": statistics.median(times),
                "p90": times[int(0.9 * (rounds - 1))],
                "p95": times[int(0.95 * (rounds - 1))],
                "cpu": (_cpu(client.pid) - used) * 1000 / rounds,
            }
    return found


def _cpu(server: int) -> float:
    """Seconds of CPU time that the server and all its processes have used, with those that have ended."""
    ticks = 0
    for pid in soak_check.family(server):
        with contextlib.suppress(OSError):
            fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
            ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def write_programs(folder: Path) -> list[str]:
    """The program as it is, with a syntax error, with an undefined name."""
    files = []
    for name, text in (
        ("good", PROGRAM),
        ("wrong", _object("Range(15, %g")(0)),
        ("undefined", _object("Rage(15, %g)")(0)),
    ):
        path = folder / f"{name}.scenic"
        path.write_text(text, encoding="utf-8")
        files.append(str(path))
    return files


def measure_stock(files: list[str]) -> dict[str, float]:
    """The stock compiler, warm, in one process."""
    command = [sys.executable, "-c", STOCK, str(paths.shipped("standins")), *files]
    out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    found = json.loads(out.splitlines()[-1])
    return found | dict.fromkeys(AS_GOOD, found["object edited, compiled"])


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
            done = subprocess.run(command, capture_output=True, env=environment)
            times.append((time.perf_counter() - begun) * 1000)
            if (done.returncode == 0) != (file == files[0]):
                raise RuntimeError(f"the scenic command ended with {done.returncode} on {Path(file).name}")
        found[name] = statistics.median(times)
    return found | dict.fromkeys(AS_GOOD, found["object edited, sampled"])


def show(name: str, report: dict[str, Any]) -> None:
    """The table: times in ms, and how many times faster."""
    figures = report["maps"][name]
    print(f"{name}: {report['machine']}, load {figures['load']:.1f}, {report['rounds']} rounds; milliseconds")
    print(f"{'':27}{'least':>7}{'median':>7}{'p90':>6}{'p95':>6}{'goal':>6}{'cpu':>6}"
          f"{'scenic':>8}{'ratio':>6}{'stock':>7}{'ratio':>6}")  # fmt: skip
    for edit, ours in figures["ours"].items():
        command, stock, median = figures["command"][edit], figures["stock"][edit], ours["median"]
        print(
            f"{edit:27}{ours['least']:7.0f}{median:7.0f}{ours['p90']:6.0f}{ours['p95']:6.0f}{TARGETS[edit][0]:6}"
            f"{ours['cpu']:6.0f}{command:8.0f}{command / median:6.0f}{stock:7.0f}{stock / median:6.0f}"
        )


if __name__ == "__main__":
    main()

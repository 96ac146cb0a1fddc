"""Thousands of good, bad and hostile programs in a row: no process, no file, no growth of memory may stay behind.

`python -m c2s_bench.perf.soak_check [--checks 5000]`. Linux: processes and memory are read from /proc.
"""

import argparse
import asyncio
import json
import random
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import yaml

from c2s_engine import paths
from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.check.protocol import CheckRequest, Limits

TESTS = Path(__file__).resolve().parents[2] / "tests" / "check"
RESULT = Path(__file__).resolve().parents[1] / "results" / "soak_check.json"
LIMITS = Limits(cpu=3)
"""Of CPU time, so that a busy machine refuses no good program; everything else as a user has it."""
PATIENCE = 300.0  # s for one answer
SAMPLES = 20


def programs() -> dict[str, list[tuple[str, str]]]:
    """Good, bad and hostile programs of the tests: name and text."""
    table = yaml.safe_load((TESTS / "errors.yaml").read_text(encoding="utf-8"))
    bad = [(name, ("" if r.get("bare") else table["head"]) + r["code"]) for name, r in table["rows"].items()]
    good, hostile = (
        [(p.stem, p.read_text(encoding="utf-8")) for p in sorted((TESTS / folder).glob("*.scenic"))]
        for folder in ("programs", "hostile")
    )
    return {"good": good, "bad": bad, "hostile": [(n, t) for n, t in hostile if "# upto: sample" in t]}


def family(pid: int) -> dict[int, int]:
    """The processes under (and with) a process: pid -> private memory in KiB."""
    parents: dict[int, int] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                parents[int(entry.name)] = int((entry / "stat").read_text().rpartition(")")[2].split()[1])
            except (OSError, ValueError, IndexError):
                continue
    members = {pid}
    grew = True
    while grew:
        more = {p for p, parent in parents.items() if parent in members} - members
        grew = bool(more)
        members |= more
    return {p: _private(p) for p in members}


def _private(pid: int) -> int:
    try:
        lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0
    return sum(int(line.split()[1]) for line in lines if line.startswith("Private_"))


async def soak(checks: int, workers: int, folder: Path) -> dict:
    """Run the checks and gather the figures."""
    kinds = programs()
    rng = random.Random(0)
    verdicts: Counter[str] = Counter()
    refused: Counter[str] = Counter()
    growth: list[dict[str, float]] = []
    started = time.monotonic()
    async with CheckClient() as client:
        await client.ready()

        async def one(i: int) -> None:
            kind = rng.choices(["good", "bad", "hostile"], [0.5, 0.3, 0.2])[0]
            name, text = rng.choice(kinds[kind])
            text = text.replace("MARK", str(folder / "mark")).replace("SECRET", str(folder / "none"))
            request = CheckRequest(program=text, folder=str(paths.shipped("maps")), seed=i, limits=LIMITS)
            try:
                report = await asyncio.wait_for(client.check(request), PATIENCE)
                verdicts[f"{kind} {'passed' if report.ok else 'refused'}"] += 1
                if kind == "good" and not report.ok:
                    refused[f"{name}: {report.stages[-1].diagnostics[-1].message}"] += 1
            except (CheckError, TimeoutError) as error:
                verdicts[f"{kind} {type(error).__name__}"] += 1
                refused[f"{name}: {error or 'no answer'}"] += 1

        done = 0
        step = max(1, checks // SAMPLES)
        while done < checks:
            batch = min(step, checks - done)
            turn = iter(range(done, done + batch))

            async def worker(turn=turn) -> None:
                for i in turn:
                    await one(i)

            await asyncio.gather(*(worker() for _ in range(workers)))
            done += batch
            await asyncio.sleep(0.2)
            now = family(client.pid)
            growth.append({"checks": done, "processes": len(now), "private_mib": round(sum(now.values()) / 1024, 1)})
            print(growth[-1], flush=True)
        last = family(client.pid)
    await asyncio.sleep(2)
    left = [p for p in last if Path(f"/proc/{p}").exists()]
    return {
        "checks": checks,
        "seconds": round(time.monotonic() - started),
        "verdicts": dict(verdicts),
        "not answered, or good and refused": dict(refused),
        "growth": growth,
        "processes_left": len(left),
        "files_left": len(list(folder.iterdir())),
    }


def main() -> int:
    """Run, print, keep; the exit status tells whether anything stayed behind."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--checks", type=int, default=5000)
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        report = asyncio.run(soak(options.checks, options.workers, Path(name)))
    print(json.dumps({k: v for k, v in report.items() if k != "growth"}, indent=1))
    RESULT.parent.mkdir(parents=True, exist_ok=True)
    RESULT.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    first, last = report["growth"][len(report["growth"]) // 2], report["growth"][-1]
    grown = last["private_mib"] > 1.2 * first["private_mib"] or last["processes"] > first["processes"]
    wrong = report["not answered, or good and refused"]
    return int(bool(grown or wrong or report["processes_left"] or report["files_left"]))


if __name__ == "__main__":
    sys.exit(main())

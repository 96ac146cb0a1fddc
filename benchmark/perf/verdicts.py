"""Whether a check says what Scenic itself says, in an environment that has only `scenic` and `carla` from the registry.

`python -m c2s_bench.perf.verdicts --python ENVIRONMENT/bin/python`: the programs of the tests, the examples, faulty
ones of each kind, and programs of the typed writer for each action and place. Same map, same seed. The table is
printed and kept in benchmark/results.
"""

import argparse
import asyncio
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import yaml

from c2s_bench.perf import written
from c2s_engine import driving, paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest, Limits

TESTS = Path(__file__).resolve().parents[2] / "tests" / "check"
RESULT = Path(__file__).resolve().parents[1] / "results" / "verdicts.json"
SCRIPT = Path(__file__).with_name("plain_scenic.py")
SEED, ITERATIONS = 3, 300
STRICTER = frozenset(
    {
        "undefined_name",
        "take_behavior",
        "do_action",
        "wrong_keyword",
        "undeclared_param",
        "enumeration",
        "no_ego",
    }
)
"""Errors in code that compiling and sampling need not reach: Scenic finds them in a run, or never."""


def programs(of_the_writer: bool) -> dict[str, str]:
    """Name and text of every program that is compared."""
    found: dict[str, str] = {}
    for group, folder in (("good", TESTS / "programs"), ("example", paths.shipped("examples", "programs"))):
        found |= {f"{group}_{p.stem}": p.read_text(encoding="utf-8") for p in sorted(folder.glob("*.scenic"))}
    table = yaml.safe_load((TESTS / "errors.yaml").read_text(encoding="utf-8"))
    for name, row in table["rows"].items():
        if row.get("upto", "sample") == "sample":
            text = ("" if row.get("bare") else table["head"]) + row["code"]
            found["faulty_" + re.sub(r"\W+", "_", name)] = text
    return found | asyncio.run(_written()) if of_the_writer else found


async def _written() -> dict[str, str]:
    return {f"written_{name}": text async for name, text in written.programs()}


def scenics(python: str, folder: Path, texts: dict[str, str]) -> dict[str, dict[str, Any]]:
    """What plain Scenic makes of each program, with the map and the driving library beside it and nothing else."""
    for file in (paths.shipped("maps", "town.xodr"), driving.path()):
        shutil.copy(file, folder)
    files = {str(folder / f"{name}.scenic"): name for name in texts}
    for file, name in files.items():
        Path(file).write_text(texts[name], encoding="utf-8")
    command = [python, "-I", str(SCRIPT), str(SEED), str(ITERATIONS), *files]
    out = subprocess.run(command, capture_output=True, text=True, check=True, cwd=folder).stdout
    answers = [json.loads(line) for line in out.splitlines()]
    return {files[a["file"]]: a for a in answers}


def ours(texts: dict[str, str]) -> dict[str, CheckReport]:
    """What c2s makes of each."""
    limits = Limits(iterations=ITERATIONS, sample_seconds=120, wall=300)
    folder = str(paths.shipped("maps"))
    with SyncCheckClient() as client:
        return {
            name: client.check(CheckRequest(program=text, folder=folder, seed=SEED, limits=limits))
            for name, text in texts.items()
        }


def compare(name: str, report: CheckReport, theirs: dict[str, Any]) -> dict[str, Any]:
    """One row: both verdicts, and what their difference is."""
    errors = [d for s in report.stages for d in s.diagnostics if d.severity == "error"]
    codes = sorted({d.code for d in errors})
    stage = errors[0].stage if errors else ""
    if (stage == "") == (theirs["stage"] == ""):
        relation = "same"
    elif stage == "safety":
        relation = "refused for safety"
    elif set(codes) <= STRICTER:
        relation = "found earlier"
    else:
        relation = "different"
    row = {"program": name, "c2s": stage or "passes", "codes": codes, "scenic": theirs["stage"] or "passes",
           "error": theirs.get("error", ""), "relation": relation}  # fmt: skip
    if report.scenes and "scene" in theirs:
        row["same_scene"] = [list(v) for v in report.scenes[0].values()] == theirs["scene"]
    return row


def table(python: str, texts: dict[str, str]) -> list[dict[str, Any]]:
    """A row for each program: both verdicts and how they relate."""
    with tempfile.TemporaryDirectory() as name:
        theirs = scenics(python, Path(name), texts)
    reports = ours(texts)
    return [compare(name, reports[name], theirs[name]) for name in texts]


def versions(python: str) -> str:
    """The packages of the other environment, as pip lists them."""
    code = "from importlib.metadata import version as v; print(f\"scenic {v('scenic')}, carla {v('carla')}\")"
    return subprocess.run([python, "-I", "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def main() -> int:
    """Compare, print, keep; the exit status tells whether any verdict differs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--python", required=True, help="of an environment with scenic and carla only")
    parser.add_argument("--no-writer", action="store_true", help="leave the writer's programs out")
    parser.add_argument("--out", type=Path, default=RESULT)
    options = parser.parse_args()
    said = versions(options.python)
    rows = table(options.python, programs(not options.no_writer))
    counts = Counter(r["relation"] for r in rows)
    scenes = [r["same_scene"] for r in rows if "same_scene" in r]
    for row in rows:
        if row["relation"] != "same":
            print(f"{row['relation']:20}{row['program']:44}c2s: {row['c2s']} {', '.join(row['codes'])}; "
                  f"scenic: {row['scenic']} {row['error'][:100]}")  # fmt: skip
    summary = f"{len(rows)} programs against {said}: {dict(counts)}; {sum(scenes)} of {len(scenes)} scenes the same"
    print(summary)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    options.out.write_text(json.dumps({"summary": summary, "rows": rows}, indent=1) + "\n", encoding="utf-8")
    return int(bool(counts["different"]))


if __name__ == "__main__":
    sys.exit(main())

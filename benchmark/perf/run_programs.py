"""Which Scenic programs compile, and which of those run: `python -m c2s_bench.perf.run_programs [FOLDER...]`.

Without folders: the programs that are at hand here (the shipped examples, the snippets each in a minimal program, those
of the tests where they are there, and what is written for the texts of the development part). Each is sampled and run
for 20 s, with a further seed or two where the first scene cannot be run to its end, and on further maps (`--map`) where
its own is missing or has no such place; a run that ends at a collision or by the program's own termination is run
through. Prints the failures with their reasons, then counts by folder; the exit status is 1 where fewer than 95 % of
those that compile run.
"""

import argparse
import asyncio
import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from c2s_engine import paths
from c2s_engine.api import Engine
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest

RESULT = Path(__file__).resolve().parents[1] / "results" / "programs.json"
TESTS = Path(__file__).resolve().parents[2] / "tests" / "check" / "programs"
RUNNER = "c2s_engine.dryrun.runner:run_scene"
ENOUGH = 0.95
SECONDS = 20.0


@dataclass(frozen=True)
class Given:
    """A program to be run. `folder` is where its maps are."""

    group: str
    name: str
    text: str
    folder: str


@dataclass(frozen=True)
class Outcome:
    """`outcome`: "runs", or the stage that failed; `reason`: the first finding (empty where it runs).

    `map`: the one that took the place of the program's own, if any.
    """

    group: str
    name: str
    outcome: str
    reason: str = ""
    seed: int = 0
    map: str = ""

    @property
    def compiles(self) -> bool:
        return self.outcome in ("runs", "sample", "run")

    @property
    def reached(self) -> int:
        """How far it came."""
        return ("parse", "safety", "compile", "sample", "run", "runs").index(self.outcome)


def of_folder(folder: Path) -> Iterator[Given]:
    """All .scenic files under a folder."""
    for path in sorted(folder.rglob("*.scenic")):
        text = path.read_text(encoding="utf-8", errors="replace")
        yield Given(folder.name, str(path.relative_to(folder)), text, str(path.parent))


def of_snippets() -> Iterator[Given]:
    """Each shipped snippet in a program of its own."""
    from c2s_bench.perf.snippet_hosts import host_program
    from c2s_engine.retrieve.snippet_files import shipped

    snippets = {s.id: s for s in shipped(paths.shipped("snippets"))}
    for snippet in snippets.values():
        yield Given("snippets", snippet.id, host_program(snippet, snippets), str(paths.shipped("maps")))


async def written() -> list[Given]:
    """What the usual method writes for the texts of the benchmark's development part."""
    from c2s_bench.records import load

    found = []
    async with Engine() as engine:
        for record in load():
            if record.withheld:
                continue
            finished: Any = None
            async for event in engine.generate(record.text, map="town", run=False):
                finished = event
            if finished.program is not None:
                found.append(Given("written", record.id, finished.program.text, str(paths.shipped("maps"))))
    return found


def at_hand() -> list[Given]:
    """The programs of this project."""
    town = str(paths.shipped("maps"))
    folders = [("examples", paths.shipped("examples", "programs")), ("tests", TESTS)]
    own = [Given(group, g.name, g.text, town) for group, folder in folders for g in of_folder(folder)]
    return [*own, *of_snippets(), *asyncio.run(written())]


def run(client: SyncCheckClient, given: Given, seeds: int, maps: Sequence[Path] = ()) -> Outcome:
    """The outcome of the first map and seed with which the program runs, else the one that came furthest."""
    best: Outcome | None = None
    for path in (None, *maps):
        params: dict[str, str | float | int | bool] = {"map": str(path.resolve())} if path else {}
        for seed in range(seeds):
            report = client.check(CheckRequest(program=given.text, filename=Path(given.name).name, folder=given.folder,
                                               upto="run", seed=seed, seconds=SECONDS, params=params))  # fmt: skip
            outcome = replace(judge(given, report, seed), map=path.stem if path else "")
            if best is None or outcome.reached > best.reached:
                best = outcome
            if outcome.outcome == "runs":
                return outcome
            if not outcome.compiles:
                break
    assert best is not None
    return best


def judge(given: Given, report: CheckReport, seed: int) -> Outcome:
    """What a report says of a program."""
    for stage in report.stages:
        if not stage.ok:
            finding = next((d for d in stage.diagnostics if d.severity == "error"), None)
            line = f"line {finding.line}: " if finding and finding.line else ""
            return Outcome(given.group, given.name, stage.name, f"{line}{finding.message}" if finding else "", seed)
    if not report.facts:
        return Outcome(given.group, given.name, "run", "the run left no facts", seed)
    return Outcome(given.group, given.name, "runs", "", seed)


def table(outcomes: list[Outcome]) -> str:
    """Markdown: programs, how many compile, how many of those run, by group and in all."""
    lines = ["| programs | n | compile | run | % of those that compile |", "| --- | --- | --- | --- | --- |"]
    groups = list(dict.fromkeys(o.group for o in outcomes))
    for group in [*groups, *(["all"] if len(groups) > 1 else [])]:
        members = [o for o in outcomes if group in ("all", o.group)]
        compiled, ran = sum(o.compiles for o in members), sum(o.outcome == "runs" for o in members)
        share = f"{100 * ran / compiled:.1f}" if compiled else "–"
        lines.append(f"| {group} | {len(members)} | {compiled} | {ran} | {share} |")
    return "\n".join(lines)


def main() -> int:
    """Run, print, keep."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folders", nargs="*", type=Path, help="folders with .scenic files")
    parser.add_argument("--map", type=Path, nargs="+", default=[], dest="maps",
                        help=".xodr files, taken in turn where a program does not run on its own map")  # fmt: skip
    parser.add_argument("--seeds", type=int, default=3, help="seeds tried for each program")
    parser.add_argument("--keep", action="store_true", help=f"write {RESULT.name} among the results")
    options = parser.parse_args()
    programs = [g for folder in options.folders for g in of_folder(folder)] if options.folders else at_hand()
    if not programs:
        print("There is no .scenic file in these folders.", file=sys.stderr)
        return 2
    outcomes = []
    with SyncCheckClient(runner=RUNNER) as client:
        for given in programs:
            outcomes.append(run(client, given, options.seeds, options.maps))
            if outcomes[-1].outcome != "runs":
                print(f"- {given.group}/{given.name}: {outcomes[-1].outcome}: {outcomes[-1].reason}", flush=True)
    print("\n" + table(outcomes))
    if options.keep:
        rows = ",\n".join(json.dumps({k: v for k, v in asdict(o).items() if v}) for o in outcomes)
        RESULT.write_text(f"[\n{rows}\n]\n", encoding="utf-8")
    count = Counter(o.outcome for o in outcomes)
    compiled = sum(o.compiles for o in outcomes)
    return int(compiled > 0 and count["runs"] < ENOUGH * compiled)


if __name__ == "__main__":
    sys.exit(main())

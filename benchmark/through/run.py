"""Runs descriptions from text to dry run and sorts how they end by cause."""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from c2s_engine.api import Engine
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.progress import Finished

HERE = Path(__file__).parent


@dataclass(frozen=True)
class Description:
    """A text, and the (event, actor) pairs that a reader expects to see, where that is known."""

    name: str
    text: str
    events: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Outcome:
    """How one description ended: `cause` is "runs", or the stage that failed with its code; sentence for the user."""

    name: str
    cause: str
    sentence: str = ""
    seconds: float = 0.0
    missing: tuple[tuple[str, str], ...] = field(default=())

    @property
    def runs(self) -> bool:
        return self.cause == "runs"


def fresh() -> list[Description]:
    """The descriptions written for this."""
    rows = yaml.safe_load((HERE / "descriptions.yaml").read_text(encoding="utf-8"))
    return [
        Description(row["style"], row["text"].strip(), tuple((name, who) for name, who in row.get("events", ())))
        for row in rows
    ]


def of_records() -> list[Description]:
    """The 123 texts of the benchmark; the reporting part under a number only."""
    from c2s_bench.records import load

    return [Description("reporting part" if r.withheld else r.id, r.text) for r in load()]


async def outcomes(descriptions: Sequence[Description], runs: int = 1) -> AsyncIterator[Outcome]:
    """One after the other, in one process, with the usual method."""
    async with Engine() as engine:
        for description in descriptions:
            finished: Any = None
            async for event in engine.generate(description.text, runs=runs):
                finished = event
            assert isinstance(finished, Finished)
            yield outcome(description, finished)


def outcome(description: Description, finished: Finished) -> Outcome:
    """What became of one description."""
    if finished.ok and finished.facts:
        seen = {
            (event.event, "ego" if thing.name == EGO else thing.component)
            for facts in finished.facts
            for thing in facts.objects
            for event in thing.events
        }
        missing = tuple(pair for pair in description.events if pair not in seen)
        return Outcome(description.name, "runs", "", finished.seconds, missing)
    for stage in finished.stages:
        if not stage.ok:
            found = next((d for d in stage.diagnostics if d.severity == "error"), None)
            cause = f"{stage.name}: {found.code}" if found else stage.name
            return Outcome(description.name, cause, found.message if found else "", finished.seconds)
    return Outcome(description.name, "no program", "", finished.seconds)


def table(results: Sequence[Outcome]) -> str:
    """Markdown: how many ended how."""
    counts = Counter(o.cause for o in results)
    lines = ["| how it ended | descriptions |", "| --- | --- |"]
    lines += [f"| {cause} | {number} |" for cause, number in counts.most_common()]
    return "\n".join(lines)


def collect(descriptions: Sequence[Description], say: Any = None) -> list[Outcome]:
    """All outcomes; `say(outcome)` is called after each."""

    async def all_of() -> list[Outcome]:
        found = []
        async for one in outcomes(descriptions):
            found.append(one)
            if say:
                say(one)
        return found

    return asyncio.run(all_of())

"""A program run with many seeds: does what S requires hold in every scene that it may sample, or in this one only?"""

from collections.abc import AsyncGenerator, Sequence
from typing import Any

from c2s_engine.session.facade import Checking
from c2s_engine.structure.components import Structure
from c2s_engine.structure.event_words import ended
from c2s_engine.structure.measures import SeedResult, collisions
from c2s_engine.structure.program import Program
from c2s_engine.structure.requirements import failures, tally

MOST = 500
"""Seeds of one series."""


def numbers(text: str, first: int = 0) -> list[int]:
    """The seeds that a text means: "20" is the first 20 from `first` on, "5-9" is five of them; raises ValueError."""
    low, dash, high = text.strip().partition("-")
    if not low.isdigit() or (dash and not high.isdigit()):
        raise ValueError(f"{text or 'nothing'} is not a number of seeds: give 20, or 5-9 for seeds 5 to 9.")
    chosen = list(range(int(low), int(high) + 1)) if dash else list(range(first, first + int(low)))
    if not 1 <= len(chosen) <= MOST:
        raise ValueError(f"A series has 1 to {MOST} seeds, not {len(chosen)}.")
    return chosen


async def seeds(
    engine: Checking, structure: Structure, program: Program, chosen: Sequence[int], **options: Any
) -> AsyncGenerator[SeedResult, None]:
    """A row for each seed. `options` are those of its `check`."""
    for seed in chosen:
        report = await engine.check(
            program.text, spans=program.spans, upto="run", seed=seed, trajectories=True, **options
        )
        if not report.facts:
            failed = next((d.message for s in report.stages for d in s.diagnostics if d.severity == "error"), "no run")
            yield SeedResult(seed=seed, ran=False, ended=failed)
            continue
        found, facts = await engine.judge(structure if program.spans else None, report, seed=seed), report.facts[0]
        met, required = tally(found.results)
        numbers_of = next(iter(found.measures), None)
        near = numbers_of.least("gap_m") if numbers_of else None
        soon = numbers_of.least("ttc_s") if numbers_of else None
        yield SeedResult(
            seed=seed,
            ran=facts.ran,
            ended=ended(facts),
            duration=facts.duration,
            met=met,
            required=required,
            collisions=tuple(str(c) for c in collisions(facts, found.requirements, bool(structure.text))),
            unmet=tuple(failures(found.requirements, found.results)),
            gap_m=near.gap_m if near else None,
            ttc_s=soon.ttc_s if soon else None,
        )


def verdict(rows: Sequence[SeedResult]) -> str:
    """How many passed, in one sentence, with what was missed most often."""
    passed = sum(r.passed for r in rows)
    collided = sum(any(c.startswith("COLLISION") for c in r.collisions) for r in rows)
    times: dict[str, int] = {}
    for row in rows:
        for line in row.unmet:
            times[line.split(" Required:")[0]] = times.get(line.split(" Required:")[0], 0) + 1
    parts = [f"{passed} of {len(rows)} seeds passed"]
    if collided:
        parts.append(f"{collided} with an unintended collision")
    if times:
        worst = max(times, key=lambda line: times[line])
        parts.append(f"missed most often ({times[worst]} of {len(rows)}): {worst}")
    return "; ".join(parts).rstrip(".") + "."

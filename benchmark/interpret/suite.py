"""Runs the suite and counts, stage by stage; failures of the counted half are never listed."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

import yaml

from c2s_bench.interpret import turns
from c2s_bench.interpret.score import STAGES, Verdict, judge
from c2s_engine.interpret import InterpretError
from c2s_engine.interpret.learned import learned

HERE = Path(__file__).parent
FILES = ("sentences", "texts", *sorted(p.stem for p in HERE.glob("fresh_*.yaml")), turns.STAGE)


@dataclass
class Half:
    """The counts of one half: verdicts that hold and verdicts, by stage."""

    holds: Counter[str] = field(default_factory=Counter)
    of: Counter[str] = field(default_factory=Counter)
    failures: list[tuple[str, list[str]]] = field(default_factory=list)

    def add(self, text: str, verdicts: list[Verdict]) -> None:
        for verdict in verdicts:
            self.of[verdict.stage] += 1
            self.holds[verdict.stage] += verdict.holds
        bad = [f"{v.stage}: {v.what}" for v in verdicts if not v.holds]
        if bad:
            self.failures.append((text, bad))

    def share(self, stage: str | None = None) -> float:
        """Per cent of the verdicts that hold, of one stage or of all."""
        stages = [stage] if stage else list(self.of)
        total = sum(self.of[s] for s in stages)
        return 100.0 * sum(self.holds[s] for s in stages) / total if total else 100.0


def entries(name: str) -> list[dict[str, Any]]:
    """The suite's entries: `t` the text, `e` what must be understood (turns.yaml: see turns.py)."""
    return yaml.safe_load((HERE / f"{name}.yaml").read_text(encoding="utf-8"))


def run(files: tuple[str, ...] = FILES) -> tuple[dict[str, dict[str, Half]], list[tuple[int, float]]]:
    """Both halves of each file, and (words, seconds) of every text."""
    learned("A car brakes ahead of ego.")
    results: dict[str, dict[str, Half]] = {}
    times: list[tuple[int, float]] = []
    for name in files:
        halves = {"develop": Half(), "counted": Half()}
        for number, entry in enumerate(entries(name), 1):
            half = halves["develop" if number % 2 else "counted"]
            if name == turns.STAGE:
                half.add(f"[{entry['scene']}] {entry['turn']}", turns.judge(entry))
                continue
            started = perf_counter()
            try:
                structure = learned(entry["t"]).structure
            except InterpretError as error:
                half.add(entry["t"], [Verdict("actors", False, str(error))])
                continue
            times.append((len(entry["t"].split()), perf_counter() - started))
            half.add(entry["t"], judge(structure, entry["e"]))
        results[name] = halves
    return results, times


def table(results: dict[str, dict[str, Half]]) -> str:
    """The figures as a Markdown table."""
    lines = [
        "| Stage | " + " | ".join(f"{n}, {h} %" for n in results for h in ("develop", "counted")) + " |",
        "| --- |" + " ---: |" * (2 * len(results)),
    ]
    for stage in STAGES:
        cells = [
            f"{r[h].share(stage):.1f}" if r[h].of[stage] else "-"
            for r in results.values()
            for h in ("develop", "counted")
        ]
        if any(c != "-" for c in cells):
            lines.append(f"| {stage} | " + " | ".join(cells) + " |")
    lines.append(
        "| **all** | "
        + " | ".join(f"{r[h].share():.1f}" for r in results.values() for h in ("develop", "counted"))
        + " |"
    )
    return "\n".join(lines)


def latency(times: list[tuple[int, float]]) -> str:
    """Median time of a text, and scaled to 60 words."""
    seconds = [s for _, s in times]
    scaled = [s / w * 60 for w, s in times if w >= 20]
    return f"Median {1000 * median(seconds):.0f} ms a text, {1000 * median(scaled):.0f} ms per 60 words ({len(times)} texts, warm)."

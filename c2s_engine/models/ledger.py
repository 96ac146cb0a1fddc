"""What the models cost: a row per call, summed per purpose, component or scenario."""

import json
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.components import ComponentId
from c2s_engine.structure.progress import Usage


class Row(BaseModel):
    """One call. Tokens as the model counted them; `tries` counts further tries after faults."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    scenario: str
    purpose: str
    component: ComponentId | None = None
    model: str = ""
    prompt_tokens: int = 0
    answer_tokens: int = 0
    seconds: float = 0.0
    tries: int = 1
    outcome: str = "ok"

    @property
    def tokens(self) -> int:
        return self.prompt_tokens + self.answer_tokens

    def usage(self) -> Usage:
        """The row as an event for the user's eyes."""
        return Usage(
            purpose=self.purpose,
            component=self.component,
            prompt_tokens=self.prompt_tokens,
            answer_tokens=self.answer_tokens,
            seconds=self.seconds,
        )


class Total(BaseModel):
    """A sum of rows."""

    calls: int = 0
    prompt_tokens: int = 0
    answer_tokens: int = 0
    seconds: float = 0.0

    @property
    def tokens(self) -> int:
        return self.prompt_tokens + self.answer_tokens


class Ledger:
    """All calls of a session, in order."""

    def __init__(self) -> None:
        self.rows: list[Row] = []
        self.scenario = ""

    def begin(self, scenario: str) -> None:
        """Calls from here on count for that scenario."""
        self.scenario = scenario

    def add(self, row: Row) -> Row:
        self.rows.append(row)
        return row

    def total(self, scenario: str | None = None) -> Total:
        """The sum of all calls, or of a scenario's."""
        return _sum(r for r in self.rows if scenario is None or r.scenario == scenario)

    def by(self, what: Literal["purpose", "component", "scenario", "model"]) -> dict[str, Total]:
        """The sums per purpose, component, scenario or model."""
        groups: dict[str, list[Row]] = defaultdict(list)
        for row in self.rows:
            groups[str(getattr(row, what) or "")].append(row)
        return {name: _sum(rows) for name, rows in groups.items()}

    def write(self, path: Path) -> None:
        """All rows as JSON lines."""
        path.write_text("".join(json.dumps(r.model_dump()) + "\n" for r in self.rows), encoding="utf-8")


def _sum(rows: Iterable[Row]) -> Total:
    total = Total()
    for row in rows:
        total.calls += 1
        total.prompt_tokens += row.prompt_tokens
        total.answer_tokens += row.answer_tokens
        total.seconds += row.seconds
    return total

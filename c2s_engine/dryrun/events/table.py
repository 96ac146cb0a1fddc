"""The table of events: definitions and thresholds, from data/events.yaml."""

from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

import yaml


@dataclass(frozen=True)
class Definition:
    """An event: what it means, whom it is meant for, whether it names another, its thresholds."""

    name: str
    holds: str
    of: str
    other: bool
    limits: dict[str, float]

    def __getattr__(self, name: str) -> float:
        try:
            return self.__dict__["limits"][name]
        except KeyError:
            raise AttributeError(f"event {self.__dict__.get('name')} has no threshold {name}") from None


@cache
def definitions() -> dict[str, Definition]:
    """Every event by name."""
    text = resources.files("c2s_engine.data").joinpath("events.yaml").read_text(encoding="utf-8")
    raw: dict[str, dict[str, Any]] = yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    words = ("of", "holds", "other")
    return {
        name: Definition(
            name,
            entry["holds"],
            entry["of"],
            bool(entry.get("other")),
            {k: float(v) for k, v in entry.items() if k not in words},
        )
        for name, entry in raw.items()
    }

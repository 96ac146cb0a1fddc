"""The vocabulary's words with their meanings, as lines of a prompt (from data/vocabulary.yaml)."""

from collections.abc import Iterable
from functools import cache
from typing import Any

import yaml

from c2s_engine import paths

PERSONS = {"pedestrian", "child", "animal"}
RIDERS = {"bicycle"}
VEHICLES = {
    "car", "truck", "van", "bus", "police_car", "ambulance", "fire_truck", "motorcycle", "bicycle", "vehicle",
}  # fmt: skip


@cache
def vocabulary() -> dict[str, dict[str, Any]]:
    """The whole table."""
    return yaml.safe_load(paths.shipped("vocabulary.yaml").read_text(encoding="utf-8"))


def meaning(entry: Any) -> str:
    return entry["means"] if isinstance(entry, dict) else str(entry)


def lines(section: str, names: Iterable[str] | None = None) -> str:
    """`- name: meaning` for each word of a section, or for those named."""
    table = vocabulary()[section]
    return "\n".join(f"- {n}: {meaning(table[n])}" for n in (names or table) if n in table)


def actions_for(object_type: str) -> list[str]:
    """The actions that an object of that type can take: none for things."""
    groups = {"all"}
    if object_type in VEHICLES:
        groups.add("vehicle")
    if object_type in PERSONS | RIDERS:
        groups.add("vru")
    if len(groups) == 1:
        return []
    return [name for name, entry in vocabulary()["actions"].items() if entry["who"] in groups]


def is_thing(object_type: str) -> bool:
    """Whether it is neither a vehicle nor alive."""
    return object_type not in VEHICLES | PERSONS


def all_actions() -> list[str]:
    """Every action's name."""
    return list(vocabulary()["actions"])

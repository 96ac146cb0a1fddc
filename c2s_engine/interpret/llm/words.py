"""The vocabulary's words with their meanings, as lines of a prompt: in short where prompts/words.yaml has them."""

from collections.abc import Iterable
from functools import cache
from importlib import resources
from typing import Any

import yaml

from c2s_engine import paths
from c2s_engine.structure.vocabulary import ON_FOOT, VEHICLES

PERSONS = ON_FOOT
RIDERS = {"bicycle"}
DRIVERS = {*VEHICLES, "vehicle"}


@cache
def vocabulary() -> dict[str, dict[str, Any]]:
    """The whole table."""
    return yaml.safe_load(paths.shipped("vocabulary.yaml").read_text(encoding="utf-8"))


@cache
def shortened() -> dict[str, dict[str, str]]:
    """The sections of the vocabulary that prompts tell in fewer words."""
    text = resources.files("c2s_engine.interpret.llm").joinpath("prompts", "words.yaml").read_text(encoding="utf-8")
    return yaml.safe_load(text)


def lines(section: str, names: Iterable[str] | None = None) -> str:
    """`- name: meaning` for each word of a section, or of those named; on one line those that say all themselves."""
    whole = {n: entry["means"] if isinstance(entry, dict) else entry for n, entry in vocabulary()[section].items()}
    table: dict[str, str] = {**whole, **shortened().get(section, {})}
    chosen = [n for n in (names or table) if n in table]
    told = [f"- {n}: {table[n]}" for n in chosen if table[n]]
    plain = [n for n in chosen if not table[n]]
    return "\n".join([*told, *([f"- {', '.join(plain)}"] if plain else [])])


def actions_for(object_type: str) -> list[str]:
    """The actions that an object of that type can take: none for things."""
    groups = {"all"}
    if object_type in DRIVERS:
        groups.add("vehicle")
    if object_type in PERSONS | RIDERS:
        groups.add("vru")
    if len(groups) == 1:
        return []
    return [name for name, entry in vocabulary()["actions"].items() if entry["who"] in groups]


def is_thing(object_type: str) -> bool:
    """Whether it is neither a vehicle nor alive."""
    return object_type not in DRIVERS | PERSONS


def family(object_type: str) -> str:
    """What kind of road user a type is: a person, a vehicle, or a thing."""
    return "person" if object_type in PERSONS else "thing" if is_thing(object_type) else "vehicle"


def all_actions() -> list[str]:
    """Every action's name."""
    return list(vocabulary()["actions"])

"""The language tables (data/language/*.yaml), loaded once, and the patterns made from them."""

import re
from functools import cache
from importlib import resources
from typing import Any

import yaml

from c2s_engine.structure.sentences import plurals


@cache
def table(name: str) -> Any:
    """A table of data/language by its file's name without the ending."""
    text = resources.files("c2s_engine.data").joinpath("language", f"{name}.yaml").read_text(encoding="utf-8")
    return yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))


def alternatives(words: list[str]) -> str:
    """A pattern that matches any of those words, the longest first; a blank matches any white space or hyphen."""
    ordered = sorted(set(words), key=len, reverse=True)
    return "|".join(re.escape(w).replace(r"\ ", r"[\s-]+").replace(r"\-", r"[\s-]?") for w in ordered)


@cache
def actor_nouns() -> dict[str, tuple[str, bool, bool]]:
    """Noun -> (object type, is a plural, names a rider or driver)."""
    data = table("actors")
    found: dict[str, tuple[str, bool, bool]] = {}
    named = {noun for section in ("types", "people") for nouns in data[section].values() for noun in nouns}
    several = {plural for noun in named for plural in plurals(noun)} - set(data["invariant"]) | {"people"}
    for section, person in (("types", False), ("people", True)):
        for kind, nouns in data[section].items():
            for noun in nouns:
                found[noun] = (kind, noun in several or noun in ("cattle", "works", "roadworks"), person)
                for plural in plurals(noun):
                    found.setdefault(plural, (kind, True, person))
    for section, kind in (("generic", "vehicle"), ("drivers", "vehicle"), ("riders", "rider")):
        for noun in data[section]:
            found[noun] = (kind, False, section == "riders")
            for plural in plurals(noun):
                found.setdefault(plural, (kind, True, section == "riders"))
    for noun in other_agents():
        found.setdefault(noun, ("vehicle", noun.endswith("s"), False))
    for name in data["queues"]:
        found[name] = ("car", True, False)
    for kind, names in data["makes"].items():
        for name in names:
            found.setdefault(name, (kind, False, False))
    for nouns in data["nominal_roles"].values():
        found.update(dict.fromkeys(nouns, ("vehicle", False, False)))
    found["people"] = ("pedestrian", True, False)
    return found


@cache
def other_agents() -> frozenset[str]:
    """Agents, players and drivers that are told apart from ego ("hostile drivers")."""
    others = table("actors")["others"]
    return frozenset(f"{w} {n}{s}" for w in others["words"] for n in others["nouns"] for s in ("", "s"))

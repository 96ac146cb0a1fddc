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


@cache
def words(name: str) -> frozenset[str]:
    """A list of data/language/words.yaml."""
    return frozenset(table("words")[name])


def with_plurals(name: str) -> frozenset[str]:
    """The nouns of a list of data/language/words.yaml in singular and plural."""
    return frozenset(form for noun in words(name) for form in (noun, *plurals(noun)))


def alternatives(words: list[str]) -> str:
    """A pattern that matches any of those words, the longest first; a blank matches any white space or hyphen."""
    ordered = sorted(set(words), key=len, reverse=True)
    return "|".join(re.escape(w).replace(r"\ ", r"[\s-]+").replace(r"\-", r"[\s-]?") for w in ordered)


def filled(pattern: str, words: dict[str, str]) -> str:
    """A pattern with what stands for each <name> in it, also within that; names of groups stay as they are."""
    while (new := re.sub(r"(?<!\?P)(?<!\\g)<(\w+)>", lambda m: words[m[1]], pattern)) != pattern:
        pattern = new
    return pattern


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


@cache
def makes() -> frozenset[str]:
    """The names of makes and models."""
    return frozenset(name for names in table("actors")["makes"].values() for name in names)


@cache
def roles() -> dict[str, str]:
    """Word before a noun -> its part in the scene."""
    return {word: role for role, words in table("actors")["roles"].items() for word in words}


@cache
def word_list(name: str) -> frozenset[str]:
    """A list of data/language/parsing.yaml."""
    return frozenset(table("parsing")[name])


@cache
def units() -> dict[str, tuple[str, float]]:
    """Unit as written -> (dimension, factor to SI)."""
    return {
        name: (dimension, float(entry["factor"]))
        for dimension, entries in table("units").items()
        if dimension not in ("numbers", "fractions")
        for entry in entries
        for name in entry["names"]
    }

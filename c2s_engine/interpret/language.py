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
def actor_nouns() -> dict[str, str]:
    """Nouns of road users and things, plurals too, with the types of objects that they mean."""
    data = table("actors")
    found: dict[str, str] = {}
    known = [(kind, nouns) for section in ("types", "people") for kind, nouns in data[section].items()]
    known += [("vehicle", data["generic"]), ("vehicle", data["drivers"]), ("rider", data["riders"])]
    for kind, nouns in known:
        for noun in nouns:
            found[noun] = kind
            for plural in plurals(noun):
                found.setdefault(plural, kind)
    others = [*other_agents(), *(noun for nouns in data["nominal_roles"].values() for noun in nouns)]
    makes = ((name, kind) for kind, names in data["makes"].items() for name in names)
    for noun, kind in ((n, k) for k, ns in (("vehicle", others), ("car", data["queues"])) for n in ns):
        found.setdefault(noun, kind)
    return {**dict(makes), **found, "people": "pedestrian"}


@cache
def other_agents() -> frozenset[str]:
    """Agents, players and drivers that are told apart from ego ("hostile drivers")."""
    others = table("actors")["others"]
    return frozenset(f"{w} {n}{s}" for w in others["words"] for n in others["nouns"] for s in ("", "s"))

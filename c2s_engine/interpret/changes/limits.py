"""Speeds that are told by the limit of the road: "ego at the limit", "the van drives 10 over the limit"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.speed import whose
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField
from c2s_engine.structure.specs import PlaceSpec


def by_the_limit(clause: str, structure: Structure) -> Found | None:
    """The speed of those who keep to the limit of the road, or who are so much over or under it."""
    said = re.search(_table()["said"], clause)
    who = whose(clause[: said.start()], structure) if said else []
    if said is None or not who:
        return None
    assert isinstance(structure.place.spec, PlaceSpec)
    limit = structure.place.spec.speed_limit
    if limit is None:
        return [], "there is no speed limit: say which it is"
    by = int(said["by"] or 0) / 3.6
    value = round(max(0.5, limit + by if said["over"] else limit - by), 2)
    names = ", ".join(name_of(c) for c in who)
    return [SetField(component=c.id, path="speed", value=value) for c in who], f"{names} at {value * 3.6:.0f} km/h"


def in_order(parts: list[str]) -> list[str]:
    """The demands of a text, those that tell a speed by the limit behind the one that tells the limit."""
    if not any(re.search(_table()["set"], part) for part in parts):
        return parts
    return sorted(parts, key=lambda part: bool(re.search(_table()["said"], part)))


def _table() -> dict[str, str]:
    found: dict[str, str] = language.table("refine")["limits"]
    return found

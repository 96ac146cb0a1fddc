"""Changes of how many there are of somebody: "make the dog two", "only one deer"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField


def count(clause: str, structure: Structure) -> Found | None:
    """ "Make the dog two": how many there are of somebody."""
    match = re.match(language.table("refine")["count"], clause)
    component = refer(match["who"], structure, alone=False) if match else None
    if match is None or component is None or component.id == "E":
        return None
    value = count_of(match["number"], 1)
    return [SetField(component=component.id, path="count", value=value)], f"{name_of(component)}: {value}"


def count_of(what: str, now: int) -> int:
    """How many a noun phrase in the plural asks for; as many as now where it gives no number."""
    if not re.match(r"\d|an?\b|one|two|three|four|five|six", what):
        return now
    first = what.split()[0]
    return min(8, int(first) if first.isdigit() else int(language.table("actors")["counts"].get(first, 2)))

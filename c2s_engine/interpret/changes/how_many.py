"""Changes of how many there are of somebody: "make the dog two", "only one deer"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import in_role
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.gone import gone
from c2s_engine.interpret.changes.refer import objects_of, refer, spec_of
from c2s_engine.interpret.reading import scan
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


def fewer(clause: str, structure: Structure) -> Found | None:
    """ "Only one deer" of several who are there each by himself: the first so many stay."""
    match = re.match(language.table("refine")["fewer"], clause)
    named = [s for s in scan.names(match["whom"]) if s.kind == "actor"] if match else []
    if match is None or not named or (named[0].start, named[0].end) != (0, len(match["whom"])):
        return None
    found = in_role(named[0].data["roles"], objects_of(structure, named[0].data["type"]))
    stay = count_of(match["number"], 1)
    if len(found) <= stay or any(spec_of(c).count > 1 for c in found):
        return None
    left = found[stay:]
    return gone(left, structure), f"{', '.join(name_of(c) for c in left)} removed"


def count_of(what: str, now: int) -> int:
    """How many a noun phrase in the plural asks for; as many as now where it gives no number."""
    if not re.match(r"\d|an?\b|one|two|three|four|five|six", what):
        return now
    first = what.split()[0]
    return min(8, int(first) if first.isdigit() else int(language.table("actors")["counts"].get(first, 2)))

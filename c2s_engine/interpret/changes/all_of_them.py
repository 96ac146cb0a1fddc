"""A demand for all of a sort as one for each: "replace all vehicles with trucks", "all cars brake"."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import in_role
from c2s_engine.interpret.changes.refer import objects_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure


def each_of_all(demand: str, structure: Structure) -> list[str]:
    """The demands for each of those of whom all are told; the demand itself where it is about somebody else."""
    table: dict[str, Any] = language.table("turns")["all"]
    two = re.match(table["two"], demand)
    match = two or re.match(table["said"], demand)
    if match is None:
        return [demand]
    there = _of(match["noun"].strip(), structure) if match["noun"] else structure.objects
    found = [c for c in there if c.id.lower() not in match["rest"]]
    if not found or two and len(found) != 2:
        return [demand]
    return found


def _of(noun: str, structure: Structure) -> list[Component]:
    """Those whom the noun means, ego aside."""
    if re.fullmatch(language.table("turns")["all"]["anybody"], noun):
        return list(structure.objects)
    named = [s for s in scan.names(noun) if s.kind == "actor"]
    if not named:
        return []
    return in_role(named[0].data["roles"], objects_of(structure, named[0].data["type"]))

"""A demand for all of a sort as one for each: "replace all vehicles with trucks", "all cars brake"."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.structure.components import Structure


def each_of_all(demand: str, structure: Structure) -> list[str]:
    """The demands for each of those of whom all are told; the demand itself where it is about somebody else."""
    table: dict[str, Any] = language.table("turns")["all"]
    two = re.match(table["two"], demand)
    match = two or re.match(table["said"], demand)
    if match is None:
        return [demand]
    there = [] if match["noun"] else structure.objects
    found = [c for c in there if c.id.lower() not in match["rest"]]
    if not found or two and len(found) != 2:
        return [demand]
    return [f"{c.id.lower()}{match['rest']}" for c in found]

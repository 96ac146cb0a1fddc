"""A demand for all of a sort as one for each: "replace all vehicles with trucks", "all cars brake"."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import in_role
from c2s_engine.interpret.changes.forms import VEHICLES
from c2s_engine.interpret.changes.refer import objects_of, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Component, Structure


def each_of_all(demand: str, structure: Structure) -> list[str]:
    """The demands for each of those of whom all are told; the demand itself where it is about somebody else."""
    table: dict[str, Any] = language.table("turns")["all"]
    if groups := _of_rows(demand, structure):
        return groups
    two = re.match(table["two"], demand)
    match = two or re.match(table["said"], demand)
    if match is None or re.search(table["not_each"], demand):
        return [demand]
    there = _of(match["noun"].strip(), structure) if match["noun"] else structure.objects
    found = [c for c in there if c.id.lower() not in match["rest"]]
    if not found or two and len(found) != 2:
        return [demand]
    becomes = bool(re.match(table["becomes"], (match["verb"] or "") + match["rest"].strip()))
    return [_for(c, match, becomes) for c in found]


def _of_rows(demand: str, structure: Structure) -> list[str]:
    """A demand for all rows of one sort as one for each: "the parked cars further apart", "three on each side"."""
    table: dict[str, Any] = language.table("turns")["rows"]
    match = next((m for form in table["said"] if (m := re.match(form, demand))), None)
    found = [c for c in _of(match["noun"], structure) if spec_of(c).count > 1] if match else []
    if match is None or len(found) < 2:
        return []
    if match.groupdict().get("number"):
        return [f"make {c.id.lower()} {match['number']}" for c in found]
    return [f"{match['verb'] or ''}{c.id.lower()}{match['rest']}" for c in found]


def _of(noun: str, structure: Structure) -> list[Component]:
    """Those whom the noun means, ego aside."""
    if re.fullmatch(language.table("turns")["all"]["anybody"], noun):
        return list(structure.objects)
    named = [s for s in scan.names(noun) if s.kind == "actor"]
    if not named:
        return []
    if named[0].data["type"] == "vehicle":
        return [c for c in structure.objects if spec_of(c).type in VEHICLES and spec_of(c).type != "bicycle"]
    return in_role(named[0].data["roles"], objects_of(structure, named[0].data["type"]))


def _for(component: Component, match: re.Match[str], becomes: bool) -> str:
    """The demand with this one for all."""
    name, rest = component.id.lower(), match["rest"]
    if not becomes:
        verb = match["verb"] if match["verb"] and not re.match(r"let|make|have", match["verb"]) else ""
        should = "" if verb or re.match(r" (?:should|must|shall|will|are|is|have|has|at|in|on)\b", rest) else " should"
        return f"{verb}{name}{should}{rest}"
    for span in reversed(scan.names(rest)):
        if span.kind == "actor" and span.data.get("plural") and spec_of(component).count == 1:
            rest = f"{rest[: span.start]}a {span.data['type'].replace('_', ' ')}{rest[span.end :]}"
    what = re.sub(language.table("turns")["all"]["into"], "", rest)
    return f"replace {name} by {what}"

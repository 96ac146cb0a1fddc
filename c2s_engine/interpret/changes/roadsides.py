"""What is beside ego's lanes: "add a sidewalk", "the road has no shoulder"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import ALREADY, Found
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField


def roadside(clause: str, structure: Structure) -> Found | None:
    """A sidewalk or a shoulder that the road has, or has no longer."""
    table = language.table("refine")["roadsides"]
    match = re.fullmatch(table["said"], clause)
    if match is None:
        return None
    field = next(name for name, noun in table["nouns"].items() if re.fullmatch(noun, match["what"]))
    there = not (match["without"] or match["none"])
    if getattr(structure.place.spec, field) == there:
        return [], f"{ALREADY} ({'a' if there else 'no'} {field})"
    return [SetField(component="R", path=field, value=there)], f"the place: {'a' if there else 'no'} {field}"

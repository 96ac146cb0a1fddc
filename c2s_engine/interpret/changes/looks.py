"""Changes of what is seen: who is hidden no longer, and which blueprint somebody has."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.surroundings import environment
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField


def uncovered(clause: str, structure: Structure) -> Found | None:
    """ "The child is not hidden any more", "ego can see the child from the beginning"."""
    seen = re.search(language.table("refine")["seen"], clause)
    if seen is None:
        return None
    hidden = [c for c in structure.objects if spec_of(c).placement.hidden_by]
    named = refer(re.sub(r"^.*\bsee\b", "", clause) if "see" in seen[0] else clause, structure)
    component = named if named in hidden else hidden[0] if len(hidden) == 1 else None
    if component is None:
        return None
    edit = SetField(component=component.id, path="placement.hidden_by", value=None)
    return [edit], f"{name_of(component)} is not hidden"


def blueprint(clause: str, structure: Structure) -> Found | None:
    """ "Use vehicle.tesla.model3 for ego"."""
    found = environment.named(clause).get("blueprint")
    component = refer(clause.replace(found.value, " "), structure) if found else None
    if found is None or component is None:
        return None
    return [SetField(component=component.id, path="model", value=found.value)], f"{name_of(component)}: {found.value}"

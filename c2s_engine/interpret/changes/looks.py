"""Changes of what is seen: who is hidden no longer, and which blueprint somebody has."""

from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.surroundings import environment
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import SetField


def blueprint(clause: str, structure: Structure) -> Found | None:
    """ "Use vehicle.tesla.model3 for ego"."""
    found = environment.named(clause).get("blueprint")
    component = refer(clause.replace(found.value, " "), structure) if found else None
    if found is None or component is None:
        return None
    return [SetField(component=component.id, path="model", value=found.value)], f"{name_of(component)}: {found.value}"

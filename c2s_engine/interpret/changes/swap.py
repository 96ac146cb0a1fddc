"""Two who are there exchange what they have: "swap the van and the car", "the bus and the truck change lanes"."""

import re
from operator import attrgetter

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField


def swapped(clause: str, structure: Structure) -> Found | None:
    """ "Swap the van and the car": their places, or what else is named."""
    table = language.table("wordings")["swaps"]
    match = next((m for pattern in table["says"] if (m := re.match(pattern, clause))), None)
    pair = [refer(match[name], structure, alone=False) for name in ("one", "other")] if match else []
    both = re.match(table["both"], clause)
    one, other = pair if pair else _only_two(clause, structure) if both else (None, None)
    if both and one is None:
        return [], "say which two are to be swapped, such as “swap O1 and O2”"
    if one is None or other is None or one.id == other.id:
        return None
    fields = next((f for pattern, f in table["fields"] if re.search(pattern, clause)), ("placement",))
    if not all(hasattr(c.spec, path) for c in (one, other) for path in fields):
        return [], "ego has no place of its own that could be swapped: say where the other is to be"
    edits = [e for a, b in ((one, other), (other, one)) for path in fields if (e := _taken(a, b, path))]
    return (edits, f"{name_of(one)} and {name_of(other)} swapped") if edits else ([], "they have the same already")


def _only_two(clause: str, structure: Structure) -> tuple[Component | None, Component | None]:
    """The only two who are there; of speeds, the only two who drive, else ego and the only one."""
    found = list(structure.objects)
    return (found[0], found[1]) if len(found) == 2 else (None, None)


def _taken(component: Component, other: Component, path: str) -> Edit | None:
    """The edit by which one has what the other had; who was placed by that other is placed by it no longer."""
    value = attrgetter(path)(other.spec)
    now = attrgetter(path)(component.spec)
    return None if value == now else SetField(component=component.id, path=path, value=value)

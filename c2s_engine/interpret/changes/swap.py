"""Two who are there exchange what they have: "swap the van and the car", "the bus and the truck change lanes"."""

import re
from operator import attrgetter

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, SetField


def swapped(clause: str, structure: Structure) -> Found | None:
    """ "Swap the van and the car": their places, or what else is named."""
    table = language.table("wordings")["swaps"]
    match = next((m for pattern in table["says"] if (m := re.match(pattern, clause))), None)
    pair = [refer(match[name], structure, alone=False) for name in ("one", "other")] if match else []
    one, other = pair if pair else (None, None)
    if match is None or one is None or other is None or one.id == other.id or "E" in (one.id, other.id):
        return None
    fields = next((f for pattern, f in table["fields"] if re.search(pattern, clause)), ("placement",))
    if "placement.side" in fields and None in (spec_of(one).placement.side, spec_of(other).placement.side):
        fields = ("placement",)
    edits = [e for a, b in ((one, other), (other, one)) for path in fields if (e := _taken(a, b, path))]
    return (edits, f"{name_of(one)} and {name_of(other)} swapped") if edits else None


def _taken(component: Component, other: Component, path: str) -> Edit | None:
    """The edit by which one has what the other had; who was placed by that other is placed by it no longer."""
    value = attrgetter(path)(spec_of(other))
    if path == "placement":
        ids = {component.id: other.id}
        update = {"of": ids.get(value.of, value.of), "hidden_by": ids.get(value.hidden_by, value.hidden_by)}
        value = value.model_copy(update=update)
    now = attrgetter(path)(spec_of(component))
    return None if value == now else SetField(component=component.id, path=path, value=value)

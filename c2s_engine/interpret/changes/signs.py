"""Signs that a change puts at the road: "a 70 sign on the right", "set up a stop sign 30 m ahead"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, quantity_of, value_of
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject
from c2s_engine.structure.specs import ObjectSpec, Placement


def sign(clause: str, structure: Structure) -> Found | None:
    """ "Add a 70 speed sign on the right roadside": a new object at the road."""
    table = language.table("refine")["signs"]
    match = re.match(table["said"], clause)
    if match is None:
        return None
    kind = next((k for pattern, k in table["kinds"] if re.search(pattern, match["kind"])), "speed_sign")
    limit = next((float(n) / 3.6 for n in (match["limit"], match["says"]) if n), None)
    if kind == "speed_sign" and limit is None:
        return None
    side = re.search(r"\b(left|right)\b", match["where"])
    far = quantity_of(match["where"], "distance")
    place = Placement(position="roadside", side="left" if side and side[1] == "left" else "right")
    if far is not None:
        place = place.model_copy(update={"gap": value_of(far)})
    refer(match["where"], structure, alone=False)
    shown = round(limit, 2) if limit is not None and kind == "speed_sign" else None
    spec = ObjectSpec(name=kind, type=kind, placement=place, limit=shown)  # type: ignore[arg-type]
    cid = structure.next_object_id()
    return [AddObject(spec=spec, component=cid)], f"{cid} added: a {kind.replace('_', ' ')}"

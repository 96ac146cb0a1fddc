"""Changes of who is beside ego: "the car level with ego", "put the van next to us on the right"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit, SetField

LANES = {"left": "left_lane", "right": "right_lane"}


def abreast(clause: str, structure: Structure) -> Found | None:
    """ "The left car level with ego": in the lane that it has, or that is told, or that there is."""
    table = language.table("refine")
    if opposite := re.match(table["on_the_other_side"], clause):
        return _oncoming(opposite["who"], opposite["other"], structure)
    match = re.match(table["abreast"], clause)
    component = refer(match["who"], structure, alone=False) if match else None
    if match is None or component is None or component.id == "E":
        return None
    place = spec_of(component).placement
    if place.position not in ("ahead", "behind", "left_lane", "right_lane", "beside"):
        return None
    position = LANES.get(match["side"] or "", place.position)
    fields = {"position": position, "along": "abreast", "gap": None}
    old = place.model_dump()
    edits: list[Edit] = [
        SetField(component=component.id, path=f"placement.{key}", value=value)
        for key, value in fields.items()
        if old[key] != value
    ]
    return edits, f"{name_of(component)} level with ego in the {position.replace('_', ' ')}"


def _oncoming(who: str, other: str | None, structure: Structure) -> Found | None:
    """ "The tractor belongs in the oncoming lane", "... behind the car": there it does what it did."""
    component = refer(who, structure, alone=False)
    if component is None:
        return None
    before = refer(other, structure, alone=False) if other else None
    update: dict[str, str | None] = {"position": "oncoming_lane", "side": None}
    if before is not None and before.id not in ("E", component.id):
        update |= {"position": "behind", "of": before.id}
    placement = spec_of(component).placement.model_copy(update=update)
    edit = SetField(component=component.id, path="placement", value=placement)
    return [edit], f"{name_of(component)} in the oncoming lane"

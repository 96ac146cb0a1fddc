"""Changes of who is beside ego: "the car level with ego", "put the van next to us on the right"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import VEHICLES, Found, name_of
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit, SetField
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Placement, PlaceSpec

LANES = {"left": "left_lane", "right": "right_lane"}


def abreast(clause: str, structure: Structure) -> Found | None:
    """ "The left car level with ego": in the lane that it has, or that is told, or that there is."""
    table = language.table("refine")
    if opposite := re.match(table["on_the_other_side"], clause):
        return _oncoming(opposite["who"], opposite["other"], structure)
    match = re.match(table["abreast"], clause)
    component = refer(match["who"], structure, alone=False) if match else None
    if match is None or component is None or component.id == "E" or spec_of(component).type not in VEHICLES:
        return None
    place = spec_of(component).placement
    if place.position not in ("ahead", "behind", "left_lane", "right_lane", "beside"):
        return None
    position = LANES.get(match["side"] or "", place.position)
    if position not in LANES.values():
        assert isinstance(structure.place.spec, PlaceSpec)
        position = "right_lane" if structure.place.spec.ego_lane == "leftmost" else "left_lane"
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
    if component is None or component.id == "E" or spec_of(component).type not in VEHICLES:
        return None
    before = refer(other, structure, alone=False) if other else None
    update: dict[str, str | None] = {"position": "oncoming_lane", "side": None}
    if before is not None and before.id not in ("E", component.id):
        update |= {"position": "behind", "of": before.id}
    placement = spec_of(component).placement.model_copy(update=update)
    edit = SetField(component=component.id, path="placement", value=placement)
    return [edit], f"{name_of(component)} in the oncoming lane"


def each_lane(clause: str, structure: Structure) -> Found | None:
    """ "One truck in each lane": a new one in those lanes beside ego's, and in its own, that have none ahead."""
    match = re.match(language.table("refine")["each_lane"], clause)
    named = [s for s in scan.names(match["what"]) if s.kind == "actor"] if match else []
    place = structure.place.spec
    assert isinstance(place, PlaceSpec) and isinstance(structure.ego.spec, EgoSpec)
    if not named or named[0].data["type"] not in VEHICLES or (place.lanes or 1) < 2:
        return None
    kind = named[0].data["type"]
    edge = {"leftmost": "left_lane", "rightmost": "right_lane"}.get(place.ego_lane or "")
    lanes = [lane for lane in ("left_lane", "ahead", "right_lane") if lane != edge]
    alike = [spec_of(c).placement for c in structure.objects if spec_of(c).type == kind]
    there = {p.position for p in alike if p.along != "behind"}
    number = int(structure.next_object_id()[1:])
    edits: list[Edit] = []
    for position in (lane for lane in lanes if lane not in there):
        cid = f"O{number + len(edits)}"
        placement = Placement.model_validate({"position": position, "along": None if position == "ahead" else "ahead"})
        spec = ObjectSpec(name=f"{kind}_{cid[1:]}", type=kind, placement=placement, speed=structure.ego.spec.speed)
        edits.append(AddObject(spec=spec, component=cid))
    return edits, f"one {kind.replace('_', ' ')} in each lane"

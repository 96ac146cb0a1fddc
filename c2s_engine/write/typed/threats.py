"""Who may come into ego's way, and from when ego can see them."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.tables import is_static

IN_WAY = {"ahead", "partly_in_lane", "intersection_exit"}


def threatening(structure: Structure) -> list[str]:
    """The ids of the objects that may come into ego's way: all that move, and what stands in its lane."""
    objects = [(c.id, c.spec) for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    return [cid for cid, spec in objects if spec.placement.position in IN_WAY or not is_static(spec)]


def standing(structure: Structure, lane_of: dict[str, int | None]) -> str | None:
    """The first object that stands in ego's lane, if one does: what an evasion without a target is about."""
    for c in structure.objects:
        spec = c.spec
        if not isinstance(spec, ObjectSpec) or not is_static(spec) or spec.placement.position not in IN_WAY:
            continue
        if lane_of.get(c.id) in (0, None):
            return c.id
    return None


def every(structure: Structure, cid: str) -> str:
    """The reference to an object, or to all of its members (starred)."""
    first = scope.reference(structure, cid)
    return f"*{first.removesuffix('[0]')}" if first.endswith("[0]") else first


def every_passed(structure: Structure, cid: str) -> str:
    """The condition under which an object, or the first and the last of its members, has gone by before the car."""
    first = scope.reference(structure, cid)
    members = [first, first.replace("[0]", "[-1]")] if first.endswith("[0]") else [first]
    return " and ".join(f"passed({one}, self)" for one in members)


def shown(structure: Structure, cid: str) -> str:
    """The condition under which ego sees an object that a vehicle ahead hides: that has left the lane; "": always."""
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position != "ahead" or spec.placement.hidden_by is None:
        return ""
    before = structure[spec.placement.hidden_by].spec if spec.placement.hidden_by in structure else None
    if not isinstance(before, ObjectSpec) or is_static(before) or before.placement.position != "ahead":
        return ""
    return f"{scope.reference(structure, spec.placement.hidden_by)}._lane is not egoLane"


def once_seen(structure: Structure, cids: list[str]) -> list[str]:
    """References to objects, each only from when ego can see it."""
    found = []
    for cid in cids:
        name, condition = every(structure, cid), shown(structure, cid)
        found.append(f"*([{name}] if {condition} else [])" if condition else name)
    return found

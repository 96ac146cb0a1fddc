"""Who waits before the junction where another drives past it: it has the lane to the left, or that side of its own,
and who drives past keeps twice as far to the other side."""

from collections.abc import Mapping

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import ObjectSpec, PlaceSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST, NEXT_LANES, SIDE, WIDTH, is_static, is_vehicle

STAYS_BEHIND = {*AT_REST, "follow", "brake", "yield"}
"""What one does, first of all, that comes up behind others."""

POCKET, CLEAR = 0.85, 0.35
"""m beside the middle of a lane that has no other at its left at which one waits (`pocket` of the driving library), and
m between the two."""
NEXT_TO = {*NEXT_LANES, "beside"}


def pocketed(objects: Mapping[str, ObjectSpec], place: PlaceSpec) -> dict[str, str]:
    """The ids of those who wait on an approach, each with who drives past it on that approach; into a roundabout
    nobody drives past another."""
    found: dict[str, str] = {}
    for cid, spec in objects.items():
        if place.kind == "roundabout" or not _waits(spec):
            continue
        past = (c for c, o in objects.items() if c != cid and _goes_by(o, spec, cid))
        if by := next(past, None):
            found[cid] = by
    return found


def own_ways(structure: Structure) -> Structure:
    """S where those who go past one that waits on an approach, from behind it or in the lane next to it, come by that
    approach themselves."""
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    if getattr(structure.place.spec, "kind", "") == "roundabout":
        return structure
    for component in structure.objects:
        spec = objects.get(component.id)
        first = objects.get(spec.placement.of) if spec else None
        if spec is None or first is None or not _waits(first) or is_static(spec):
            continue
        if spec.placement.position not in NEXT_TO and not (spec.placement.position == "behind" and _passes(spec)):
            continue
        changes = {"position": first.placement.position, "of": "ego", "gap": None, "along": None}
        phases = tuple(p for p in spec.phases if p.action not in ("overtake", "follow"))
        placement = spec.placement.model_copy(update=changes)
        changed = spec.model_copy(update={"placement": placement, "phases": phases})
        structure = structure.with_spec(component.id, changed)
    return structure


def pocket_name(position: str) -> str:
    """The lane where one waits that others pass, in the program."""
    return f"place.{SIDE[position]}_pocket"


def aside(structure: Structure, plan: Plan, cid: str) -> str:
    """How far (m, as Scenic) to the left of its lane's middle one is on an approach where somebody waits and others
    drive past, those in line with them as they are; "": in the middle."""
    while cid not in (*plan.pocketed, *plan.pocketed.values()):
        spec = structure[cid].spec
        if not isinstance(spec, ObjectSpec) or spec.placement.position != "behind" or spec.placement.of == "ego":
            return ""
        cid = spec.placement.of
    first = structure[cid].spec
    assert isinstance(first, ObjectSpec)
    times = _times(structure, cid, plan.pocketed[cid]) if cid in plan.pocketed else -2.0
    return f"{'' if times == 1 else f'{scope.number(times)} * '}{pocket_name(first.placement.position)}_offset"


def _times(structure: Structure, waiting: str, by: str) -> float:
    """How many times as far beside the middle of its lane one waits as a pocket is, so that wide ones have room."""
    widths = [WIDTH[structure[cid].spec.type] for cid in (waiting, by)]  # type: ignore[union-attr]
    return max(round((sum(widths) / 2 + CLEAR) / POCKET - 2, 1), 1.0)


def _waits(spec: ObjectSpec) -> bool:
    if spec.placement.position not in APPROACH_ANGLE or not is_vehicle(spec.type):
        return False
    return is_static(spec) or bool(spec.phases) and {p.action for p in spec.phases} <= AT_REST


def _goes_by(spec: ObjectSpec, waiting: ObjectSpec, cid: str) -> bool:
    """Whether somebody drives past one that waits, by the same approach."""
    same = spec.placement.position == waiting.placement.position and spec.placement.of == "ego"
    if not same or not is_vehicle(spec.type) or is_static(spec) or _waits(spec) or spec.speed == 0:
        return False
    first = spec.phases[0].action if spec.phases else ""
    return first not in STAYS_BEHIND and not any(p.action == "collide" and p.target == cid for p in spec.phases)


def _passes(spec: ObjectSpec) -> bool:
    """Whether somebody that comes up behind another goes past it: it overtakes that one, or runs into ego."""
    does = {(p.action, p.target or "ego") for p in spec.phases}
    first = spec.placement.of
    return (
        not is_static(spec)
        and ("collide", first) not in does
        and bool(does & {("overtake", first), ("collide", "ego")})
    )

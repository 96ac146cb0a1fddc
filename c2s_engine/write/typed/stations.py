"""How far along its lane something starts, as numbers: from whom it is measured, and by how much. Lengths in m."""

import math

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed.lanes import is_landmark
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import (
    APPROACH_ANGLE,
    HALF_LANE,
    LENGTH,
    MOVES_OFF_ROAD,
    WIDTH,
    WORKS,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.usual import (
    NOSE_TO_TAIL,
    SIDE_BY_SIDE,
    SLOWS_DOWN,
    crosses,
    crosses_there,
    default_gap,
    extent,
    lets_ego_come,
    pace_of,
    reach,
    right_behind,
    row_length,
    row_step,
    speed_of,
    uses_crosswalk,
)

OWN_PLACE = {*APPROACH_ANGLE, "oncoming_lane", "on_ramp", "intersection_exit", *MOVES_OFF_ROAD}
"""Positions that name where somebody is, whomever they are seen from."""
FROM_END = {*APPROACH_ANGLE, "on_ramp"}
"""Positions measured back from the end of their lane."""
BEFORE_JUNCTION = 5.0
"""m before a junction where those cross who cross at its crosswalk."""
LONGEST_APPROACH = 130.0
"""m before a junction from which somebody comes who meets ego there."""
BESIDE = {"sidewalk": 3.0, "parked": 1.6}
"""m from the road's edge, else 1.5."""
SET_BACK = 6.0
"""m by which somebody starts further from the road at most, so as to come when S says."""
AT_KERB = 0.6
"""m from the road's edge to who is about to step onto it."""
AFTER = 0.5
"""s by which one crosses later than whom they wait for."""
SEEN_RUNNING = 1.8
"""s before it is in ego's way for which an animal is seen that comes running."""
SEEN_WALKING = 3.0
"""s for which somebody is seen who walks up to the road and halts there."""
INTO_LANE = 0.6
"""m by which what is parked stands out into the lane of those who have to get past it; a car still has room there."""
BAY = 1.2
"""m from the road to who stands in a bay or a driveway."""
BEHIND_WALK = 2.5
"""m from the road to a building."""
CORNER = 3.0
"""m from what stands at the corner of a junction to where ego's lane ends."""
TO_STAND = 12.0
"""m that one drives, before it brakes, to a line at which it waits for ego, and that lie behind the line."""
INSIDE = 1.1
"""m behind the face of a wide thing where somebody stands whom it hides."""
COVERED = 0.2
"""m by which a vehicle stands further from the road than the face of what hides it."""
AT_DOOR = 0.1
"""m from a vehicle to who stands at its door."""
CLEAR = 0.4
"""m between a vehicle that pulls out from the kerb and what stands beside it there."""
RIGHT_BEHIND = 0.4
"""m from what hides somebody to who stands by it."""
IN_FILE = 0.8
"""m from one to the next of those who cross by a crosswalk one after the other."""


def along(spec: ObjectSpec) -> int:
    """+1 ahead, 0 abreast, -1 behind."""
    stated, position = spec.placement.along, spec.placement.position
    if position == "partly_in_lane" and stated == "abreast":
        return 1
    if stated and position not in ("ahead", "behind"):
        return {"ahead": 1, "abreast": 0, "behind": -1}[stated]
    return {"behind": -1, "beside": 0}.get(position, 1)


def set_back(structure: Structure, cid: str, plan: Plan) -> float:
    """How much further from the road (m; below 0: nearer to it) somebody on foot starts who sets out when S says, so as
    to cross after the one that they wait for, or as ego comes: as far as what hides them lets them be hidden. What
    stands by one that will pull out from the kerb stands behind it, seen from the road."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    beside = structure[spec.placement.of].spec if spec.placement.of in structure else None
    if isinstance(beside, ObjectSpec) and is_static(spec) and not is_walker(spec) and _pulls_out(beside):
        room = (WIDTH[beside.type] + WIDTH.get(spec.type, 1.0)) / 2 + CLEAR
        return round(max(outwards(beside) + room - outwards(spec), 0.0), 1)
    if (hider := hides_beside(structure, spec)) is not None:
        own = (LENGTH if spec.placement.facing == "across" else WIDTH)[spec.type] / 2
        return round(max(outwards(hider) - WIDTH[hider.type] / 2 + own + COVERED - outwards(spec), 0.0), 1)
    first = spec.phases[0] if spec.phases else None
    if first is None or first.trigger is None or not is_walker(spec) or not crosses(spec):
        return 0.0
    t, pace = first.trigger, max(middle(pace_of(spec)), 0.5)
    other = structure[t.of].spec if t.of and t.of in structure else None
    own, far, near = _to_middle(structure, spec, plan), SET_BACK, 0.0
    by = structure[spec.placement.hidden_by].spec if spec.placement.hidden_by else None
    if isinstance(by, ObjectSpec):
        far = max(WIDTH[by.type] - inside(by), 0.0)
    if t.kind == "action" and isinstance(other, ObjectSpec) and is_walker(other) and crosses(other):
        before = _to_middle(structure, other, plan) + set_back(structure, str(t.of), plan)
        due = before / max(middle(pace_of(other)), 0.5) + AFTER - middle(t.delay or 0.0)
    elif t.kind == "distance" and t.value is not None and t.subject in (None, "ego") and plan.ego_speed > 0:
        behind = isinstance(by, ObjectSpec) and t.of == spec.placement.hidden_by
        beyond = from_hider(structure, cid) + LENGTH[by.type] / 2 if behind else 0.0  # type: ignore[union-attr]
        due = (middle(t.value) + beyond) / plan.ego_speed
        near = outwards(spec) - AT_KERB if by is None else 0.0
    elif t.kind == "ttc" and t.value is not None and by is None:
        due, near = middle(t.value), outwards(spec) - AT_KERB
    else:
        return 0.0
    return round(min(max(due * pace - own, -near), far), 1)


def hides_beside(structure: Structure, spec: ObjectSpec) -> ObjectSpec | None:
    """What hides a vehicle beside the road that comes from there, itself on that side of the road; None: nothing."""
    hider = spec.placement.hidden_by
    by = structure[hider].spec if hider is not None and hider in structure else None
    if not isinstance(by, ObjectSpec) or right_behind(spec) or spec.placement.position not in MOVES_OFF_ROAD:
        return None
    same = (by.placement.side == "left") == (spec.placement.side == "left")
    return by if same and by.placement.position in MOVES_OFF_ROAD else None


def hides(structure: Structure, cid: str) -> ObjectSpec | None:
    """Who stands by an object that hides him, and crosses ego's road from there."""
    specs = [c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)]
    return next((s for s in specs if right_behind(s) and s.placement.hidden_by == cid and crosses(s)), None)


def _pulls_out(spec: ObjectSpec) -> bool:
    """Whether a vehicle beside the road comes onto it."""
    comes = any(p.action in ("enter_road", "start") for p in spec.phases)
    return comes and is_vehicle(spec.type) and spec.placement.position in MOVES_OFF_ROAD


def _to_middle(structure: Structure, spec: ObjectSpec, plan: Plan) -> float:
    """From where somebody starts who crosses to the middle of ego's way, m."""
    return way_out(structure, spec, plan.place) + outwards(spec) - BESIDE.get(spec.placement.position, 1.5)


def next_to(structure: Structure, cid: str) -> float:
    """How far (m) along the road from the middle of the crosswalk the first of those stands who use it together: the
    first of S in its middle, the others by turns on either side."""
    there = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec) and uses_crosswalk(c.spec)}
    k = list(there).index(cid) if cid in there else 0
    return (k + 1) // 2 * (1.0 if k % 2 else -1.0)


def gap(spec: ObjectSpec, plan: Plan) -> float | tuple[float, float]:
    """The stated gap, or the usual one."""
    if spec.placement.gap is not None:
        return spec.placement.gap
    place = plan.place.model_copy(update={"kind": "on_ramp"}) if plan.ramp else plan.place  # it stands before the merge
    usual = default_gap(spec, plan.ego_top if along(spec) > 0 else plan.ego_speed, place)
    if place.kind == "intersection" and place.crosswalk and plan.distance is not None and crosses_there(spec):
        return max(usual, middle(plan.distance) - BEFORE_JUNCTION - (spec.count - 1) * row_step(spec))
    return usual


def row_beyond(parent: ObjectSpec, ahead: bool) -> float:
    """How far a row goes on beyond its first member, on the side of those placed ahead of it or behind it."""
    if parent.type in WORKS:  # always one
        return 0.0
    backwards = parent.placement.position in (*FROM_END, "oncoming_lane") or along(parent) < 0
    return (parent.count - 1) * row_step(parent) if ahead != backwards else 0.0


def length_of(structure: Structure, of: str) -> float:
    """How much of the road's length ego or an object takes."""
    spec = structure.ego.spec if of in ("ego", "E") else structure[of].spec
    if isinstance(spec, ObjectSpec):
        return extent(spec)
    return LENGTH.get(getattr(spec, "type", "car"), 4.8)


def stands_there(structure: Structure, of: str) -> bool:
    """Whether the one that an object is placed by is itself beside the road."""
    other = structure[of].spec if of in structure and of not in ("ego", "E") else None
    return isinstance(other, ObjectSpec) and other.placement.position in MOVES_OFF_ROAD


def at_door(structure: Structure, spec: ObjectSpec) -> bool:
    """Whether somebody on foot stands at the door of a vehicle beside the road, on the side of the traffic."""
    placement = spec.placement
    other = structure[placement.of].spec if stands_there(structure, placement.of) else None
    steps_out = placement.along == "abreast" and any(p.action == "enter_road" for p in spec.phases)
    on_foot = spec.type in ("pedestrian", "child") and isinstance(other, ObjectSpec) and is_vehicle(other.type)
    return on_foot and (placement.position == "beside" or steps_out)


def in_line(structure: Structure, spec: ObjectSpec, plan: Plan) -> bool:
    """Whether it is placed by one that is on no lane of ego's direction, and on the same lane as that one."""
    of = spec.placement.of
    if of in ("ego", "E") or plan.lane_of[of] is not None or spec.placement.position in OWN_PLACE:
        return False
    other = structure[of].spec
    return not (isinstance(other, ObjectSpec) and is_landmark(other))


def first_in_line(structure: Structure, cid: str, plan: Plan) -> str:
    """The first of the queue that one is in which is itself placed by another (`in_line`)."""
    spec = structure[cid].spec
    while isinstance(spec, ObjectSpec) and in_line(structure, spec, plan):
        cid = spec.placement.of
        spec = structure[cid].spec
    return cid


def base(structure: Structure, of: str, plan: Plan) -> str:
    """Whom something is measured from: `of` where that has a place along ego's lane, else "ego"."""
    parent = structure[of].spec if of not in ("ego", "E") else None
    if not isinstance(parent, ObjectSpec):
        return "ego"
    if right_behind(parent):
        return base(structure, parent.placement.hidden_by or "ego", plan)
    if at_door(structure, parent):
        return base(structure, parent.placement.of, plan)
    return "ego" if plan.lane_of[of] is None and not stands_there(structure, of) else of


def from_base(
    structure: Structure, spec: ObjectSpec, plan: Plan, sign: int
) -> tuple[str, float | tuple[float, float], float]:
    """Whom it is measured from, the gap, and what the bodies add to that, ahead (`sign` +1) or behind (-1)."""
    of = spec.placement.of
    half = (extent(spec) + length_of(structure, of)) / 2 + 0.2
    own = gap(spec, plan)
    if stands_there(structure, of):
        own = NOSE_TO_TAIL if spec.placement.gap is None else own
    start = base(structure, of, plan)
    if start == of and start != "ego":
        parent = structure[of].spec
        assert isinstance(parent, ObjectSpec)
        half += row_beyond(parent, sign > 0)
    return start, own, half + sign * from_hider(structure, of)


def from_hider(structure: Structure, of: str) -> float:
    """How far ahead along the road one stands of the first of those that hide it; 0: it does not stand by them."""
    spec = structure[of].spec if of not in ("ego", "E") else None
    if not isinstance(spec, ObjectSpec) or not right_behind(spec):
        return 0.0
    by = structure[spec.placement.hidden_by or "ego"].spec
    assert isinstance(by, ObjectSpec)
    return past_last(structure, spec) + past_others(structure, of) + (by.count - 1) * row_step(by)


def between(structure: Structure, spec: ObjectSpec) -> bool:
    """Whether one whom a row beside the road hides comes out from the gap between its last two: on foot, over ego's
    road, and placed by nobody."""
    by = structure[spec.placement.hidden_by].spec if right_behind(spec) else None  # type: ignore[index]
    if not isinstance(by, ObjectSpec) or not is_walker(spec) or not crosses(spec) or spec.count > 1:
        return False
    row = by.count > 1 and is_vehicle(by.type) and by.placement.position in MOVES_OFF_ROAD and along(by) >= 0
    alone = spec.placement.of == "ego" and spec.placement.gap is None
    return row and alone and row_step(by) - extent(by) >= WIDTH[spec.type]


def past_last(structure: Structure, spec: ObjectSpec) -> float:
    """How far along the road one stands of the middle of the last of those that hide it (below 0: short of it)."""
    by = structure[spec.placement.hidden_by or "ego"].spec
    assert isinstance(by, ObjectSpec)
    if between(structure, spec):
        return -row_step(by) / 2
    return (LENGTH[by.type] + LENGTH[spec.type]) / 2 + RIGHT_BEHIND


def past_others(structure: Structure, cid: str) -> float:
    """How much further along the road (m) than right there one stands by what hides it: past those named before it."""
    by, taken = structure[cid].spec.placement.hidden_by, 0.0  # type: ignore[union-attr]
    for component in structure.objects:
        spec = component.spec
        if component.id == cid:
            break
        if isinstance(spec, ObjectSpec) and right_behind(spec) and spec.placement.hidden_by == by:
            taken += 0.0 if between(structure, spec) else row_length(spec) + SIDE_BY_SIDE
    return taken


def hiding_member(structure: Structure, spec: ObjectSpec) -> str:
    """Which member of a row hides one from ego, as its index: the last, or the one before where it stands between."""
    return "[-2]" if between(structure, spec) else "[-1]"


def from_door(structure: Structure, spec: ObjectSpec) -> float:
    """How far (m) to the left of the middle of a vehicle, as that looks, somebody at its door is."""
    other = structure[spec.placement.of].spec
    assert isinstance(other, ObjectSpec)
    out = WIDTH[other.type] / 2 + AT_DOOR + WIDTH[spec.type] / 2
    return out if (other.placement.side == "left") == (other.placement.facing == "against") else -out


def clear_of(structure: Structure, spec: ObjectSpec) -> float:
    """From the middle of what takes the spot beside the road to one that is placed abreast of it."""
    return (extent(spec) + length_of(structure, spec.placement.of)) / 2 + 0.8


def bodies(spec: ObjectSpec, parent: ObjectSpec, behind: bool) -> float:
    """What the bodies add to the gap of one in line with another."""
    return (LENGTH[spec.type] + LENGTH[parent.type]) / 2 + row_beyond(parent, not behind)


def to_junction(cid: str, spec: ObjectSpec, plan: Plan) -> float | tuple[float, float]:
    """How far before the junction one on another approach starts: as stated, or about where it is solved to start."""
    if spec.placement.gap is not None:
        return spec.placement.gap
    if cid in plan.set_out:
        return 18.0
    own, later = middle(speed_of(spec, plan.place)), middle(spec.placement.later or 0.0)
    if own > 0 and lets_ego_come(spec):  # it stands by then
        return TO_STAND + own**2 / (2 * SLOWS_DOWN)
    far = middle(plan.distance or 40)
    seconds = far / max(plan.ego_speed, 4) if plan.ego_speed > 0 else math.sqrt(far + 5)
    return max(8.0, min(own * (seconds + later) + 6.0, LONGEST_APPROACH)) if own > 0 else 8.0


def to_merge(spec: ObjectSpec, plan: Plan) -> float:
    """How far before the merge one on the ramp starts: so that it is there when ego is."""
    own, ego = middle(speed_of(spec, plan.place)), max(plan.ego_speed, 4)
    lead = 0.0
    if any(p.action == "cut_in" for p in spec.phases):  # it comes out in front
        lead = 6 + (middle(spec.placement.gap) if spec.placement.gap is not None else 14)
    return max(10.0, min((own * (middle(plan.distance or 80) + 100) / ego) - 100 - lead, 250))


def exit_gap(spec: ObjectSpec, plan: Plan) -> float | tuple[float, float]:
    """How far behind the junction one starts: those on foot and riders close to it."""
    if near_exit(spec) and spec.placement.gap is None:
        return 4.0
    return gap(spec, plan)


def near_exit(spec: ObjectSpec) -> bool:
    """Whether it stands at the edge of the lane behind the junction."""
    return is_walker(spec) or spec.type == "bicycle"


def outwards(spec: ObjectSpec) -> float:
    """From the road's edge to the middle of what is beside it."""
    out = BESIDE.get(spec.placement.position, 1.5)
    if any(p.action == "cross_road" and p.abandoned for p in spec.phases):  # it walks up to the road
        out = max(out, round(SEEN_WALKING * middle(pace_of(spec)), 1))
    elif spec.type == "animal" and crosses(spec):  # it comes running
        return max(out, round(SEEN_RUNNING * middle(pace_of(spec)) - 1.75, 1))
    if is_walker(spec):
        return max(out, round(LENGTH[spec.type] / 2 + 0.3, 1))
    if not is_vehicle(spec.type):  # signs and props may be wide
        return max(out, 2.4, WIDTH[spec.type] / 2 + (BEHIND_WALK if spec.type == "building" else 0.5))
    if spec.placement.facing == "across":  # in a bay or a driveway
        return LENGTH[spec.type] / 2 + BAY
    return max(1.8 if spec.placement.position == "roadside" else out, WIDTH[spec.type] / 2 + 0.3)  # out of the lane


def parked_in_way(structure: Structure, cid: str | None) -> bool:
    """Whether something is parked where somebody comes up who gets past it: then it stands out into the lane."""
    spec = structure[cid].spec if cid and cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position != "parked" or not is_static(spec):
        return False
    comes = {"oncoming_lane"} if spec.placement.side == "left" else {"ahead", "behind"}
    there = [o.spec for o in structure.objects if isinstance(o.spec, ObjectSpec) and o.spec.placement.position in comes]
    ego = structure.ego.spec
    if isinstance(ego, EgoSpec) and spec.placement.side != "left":
        if ego.reaction == "evade" and ego.react_to == cid:
            return True
        there = [ego, *there]  # type: ignore[list-item]
    return any(p.action in ("overtake", "swerve") and p.target == cid for s in there for p in s.phases)


def from_lane(structure: Structure, spec: ObjectSpec) -> float:
    """From the middle of ego's lane to that of one at the roadside, where S says the room between ego and its body."""
    across = spec.placement.facing == "across" or crosses(spec)
    own = LENGTH[spec.type] if across else WIDTH[spec.type]
    return (WIDTH[getattr(structure.ego.spec, "type", "car")] + own) / 2 + middle(spec.placement.lateral or 0.0)


def way_out(structure: Structure, spec: ObjectSpec, place: PlaceSpec) -> float:
    """From where somebody stands who crosses to the middle of ego's way: by what hides it, or out of a vehicle."""
    by = spec.placement.hidden_by or (spec.placement.of if at_door(structure, spec) else None)
    other = structure[by].spec if by and by in structure else None
    if not isinstance(other, ObjectSpec) or other.placement.position not in MOVES_OFF_ROAD:
        return reach(spec, place)
    face = HALF_LANE + outwards(other) - WIDTH[other.type] / 2
    return face + (inside(other) if spec.placement.hidden_by else -AT_DOOR)


def inside(hider: ObjectSpec) -> float:
    """How far behind the face of what hides somebody, seen from the road, that one stands."""
    return min(WIDTH[hider.type] / 2, INSIDE)


def two_way(plan: Plan) -> bool:
    """Whether the far side of the road lies beyond lanes of the other direction."""
    return bool(plan.oncoming or plan.place.kind in ("intersection", "crosswalk") or plan.place.oncoming)

"""From specs to the plan of what the place must offer: lanes, approaches, room, distances.

Pure: it looks at specs only. `make_plan` raises ResolveError, naming the fields, where specs contradict each other.
"""

from dataclasses import replace

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import Quantity, high, low, middle
from c2s_engine.structure.specs import EgoSpec, LightChange, ObjectSpec, PlaceSpec
from c2s_engine.write.typed import alongside, contradictions, lanes, layout
from c2s_engine.write.typed import room as rooms
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.pockets import pocketed
from c2s_engine.write.typed.tables import APPROACH_ANGLE, JUNCTION, RAMP, TURN
from c2s_engine.write.typed.threats import hits_ego, is_hit
from c2s_engine.write.typed.usual import has_marking, lets_ego_come, speed_of, turn_of, uses_crosswalk

BEFORE_CHANGE = 3.0
"""s that ego drives before the light changes."""
USUAL, LONG = 20.0, 45.0
"""s after which a run ends at the latest; the same round a roundabout and over an acceleration lane."""
TO_SEE = 8.0
"""s after the last moment that S says in which what is done then can be seen."""
LATEST = 60.0
"""s: for a moment after that no run is made longer."""
STAYS = {"stop", "wait", "stationary", "yield", "run_stop"}
"""What those do at the junction who have no priority there."""
FAST = 11.5
"""m/s at which nobody comes up to a stop sign of their own."""


def make_plan(structure: Structure, room: float = 1.0) -> Plan:
    """Decide what the place must offer; raises ResolveError. Where the specs leave the way to a junction open, `room`
    shortens it for maps with short roads."""
    said, ego = structure.place.spec, structure.ego.spec
    assert isinstance(said, PlaceSpec) and isinstance(ego, EgoSpec)
    place = said
    restrictions = structure.restrictions.spec
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    two_way = place.oncoming is True and place.kind in ("road", "straight", "curve")
    place = _place_kind(place, ego, objects)
    lane_of = {cid: lanes.lane_offset(cid, objects) for cid in objects}
    if broken := contradictions.first(place, ego, objects.values()):
        raise ResolveError(broken.because, broken.fields)
    ramp = any(o.placement.position == "on_ramp" for o in objects.values())
    if misplaced := contradictions.misplaced({"E": ego, **objects}, ramp or place.kind == "on_ramp"):
        raise misplaced
    changes = getattr(structure.settings.spec, "light_changes", ())
    if unwatchable := contradictions.unwatchable(place, {"E": ego, **objects}, changes):
        raise unwatchable
    oncoming = place.oncoming is True or lanes.needs_oncoming(ego, objects)
    if place.kind not in {"motorway", *RAMP} and place.oncoming is None and lanes.kerb_side(ego, objects) == "left":
        oncoming = True  # the far side of a street lies beyond its oncoming lanes
    offsets = lanes.offsets_of(place, ego, objects, lane_of)
    if ramp or place.kind in RAMP:
        place, base, offsets = lanes.ramp_lanes(place, offsets, ramp)
    else:
        beside = "right" if lanes.pulls_out(ego) else lanes.kerb_side(ego, objects)
        if oncoming and beside is None and lanes.by_oncoming(ego, objects):  # no lane of their own in between
            beside = "left"
        place, base, offsets = lanes.lanes_for(place, offsets, beside)
    if oncoming:
        place = place.model_copy(update={"oncoming": True})
    crossing = {cid: o for cid, o in objects.items() if o.placement.position in APPROACH_ANGLE}
    passed = pocketed(objects, place)
    ways = {cid: (o.placement.position, turn_of(o.phases)) for cid, o in crossing.items()}
    speed, top = middle(speed_of(ego, place)), high(speed_of(ego, place))
    duration = getattr(restrictions, "duration", None) or usual_duration(place, ego, objects)
    kind = place.model_copy(update={"kind": "on_ramp"}) if ramp else place
    met = frozenset(cid for cid, o in crossing.items() if hits_ego(o) or is_hit(ego, cid))
    set_out = frozenset(c for c, o in crossing.items() if _sets_out(o) and (c in met or _forces(ego, c, o)))
    way = rooms.distance(kind, top, ego, objects, room, bool(set_out) or any(map(lets_ego_come, crossing.values())))
    plan = Plan(
        place=place,
        duration=duration,
        ego_speed=speed,
        ego_top=top,
        before=rooms.before(ego, objects, speed, place),
        after=rooms.after(place, top, ego, objects),
        fastest=rooms.fastest(place, top, ego, objects),
        distance=_seen_to_change(way, place, changes, top * room),
        offsets=offsets,
        base=base,
        approaches=tuple(sorted({way for cid, way in ways.items() if cid not in passed})),
        pocketed=passed,
        pockets=tuple(sorted({ways[by] for by in passed.values()})),
        stops=tuple(sorted({o.placement.position for o in objects.values() if _runs_stop(o)} & APPROACH_ANGLE.keys())),
        priority=_priority_roads(place, objects),
        oncoming=oncoming,
        single=_single(said, place, two_way) and offsets == {0},
        ordinary=_ordinary(said, place, two_way, ramp) and offsets == {0},
        ramp=ramp,
        exit_room=rooms.behind_junction(objects, speed, place),
        lane_of=lane_of,
        set_out=set_out,
        leads=lanes.leads(ego, objects, lane_of, speed, place),
        parked=any(o.placement.position == "parked" for o in objects.values()),
        also=alongside.other_ways(structure, place, lane_of),
        across=room < rooms.SHORTEST,
    )
    return _with_room(structure, plan)


def usual_duration(place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> float:
    """How long (s) a run is of which S says no length."""
    phases = lanes.all_phases(ego, objects)
    far = place.kind == "roundabout" and any(p.action in TURN for p in phases) or rooms.to_merge_end(ego, objects)
    times = (p.trigger for p in phases if p.trigger is not None and p.trigger.kind == "time")
    latest = max((high(t.value) for t in times if t.value is not None and high(t.value) <= LATEST), default=0.0)
    return max(LONG if far else USUAL, latest + TO_SEE)


def _seen_to_change(way: Quantity | None, place: PlaceSpec, changes: tuple[LightChange, ...],
                    ahead: float) -> Quantity | None:  # fmt: skip
    """The way to the junction (m), where S leaves it open, with `BEFORE_CHANGE` s of `ahead` m each before ego is
    as near to the light as it is when that changes."""
    near = [middle(c.when.value or 0) for c in changes if c.when.kind == "place" and c.when.subject in (None, "ego")]
    if not near or way is None or place.distance is not None:
        return way
    return max(high(way), max(near) + BEFORE_CHANGE * ahead)


def _with_room(structure: Structure, plan: Plan) -> Plan:
    """The plan with as much of each lane as the objects take that start on it, one behind the other."""
    specs = {c.id: c.spec for c in structure.objects if has_marking(plan.place)}
    there = {cid for cid, spec in specs.items() if isinstance(spec, ObjectSpec) and uses_crosswalk(spec)}
    drawn = layout.draws(structure, plan)
    taken = layout.extents([{cid: boxes for cid, boxes in draw.items() if cid not in there} for draw in drawn])
    reach = taken.pop("road", 0.0)
    distance = plan.distance
    if distance is not None and low(distance) < reach + 1:
        stated = getattr(structure.place.spec, "distance", None)
        if stated is not None and high(distance) < reach + 1:
            raise rooms.too_near(high(distance))
        if reach > rooms.LONGEST_APPROACH:
            raise rooms.too_far(reach)
        distance = round(reach + 4, 1) if stated is None else (round(reach + 1, 1), high(distance))
    exit_room = max(plan.exit_room, taken.pop("exit", 0.0))
    return replace(plan, distance=distance, exit_room=exit_room, reach=reach, lengths=taken)


def _single(said: PlaceSpec, place: PlaceSpec, two_way: bool) -> bool:
    """Whether ego's road has one lane in its direction: as is said, or as roads with two directions have."""
    return said.lanes == 1 and (two_way or place.kind in JUNCTION) or two_way and said.lanes is None


def _ordinary(said: PlaceSpec, place: PlaceSpec, two_way: bool, ramp: bool) -> bool:
    """Whether a road is meant as most are: S says that the roads of a junction have one lane in each direction, the
    others are as small, too; or it says nothing of lanes."""
    if place.kind in JUNCTION:
        return _single(said, place, two_way) or place.kind == "intersection" and _of_lanes(said) is None
    return place.kind in ("road", "straight", "curve", "crosswalk") and _of_lanes(said) is None and not ramp


def _of_lanes(said: PlaceSpec) -> int | str | None:
    """What S says of the lanes in ego's direction."""
    return said.lanes or said.ego_lane


def _runs_stop(o: ObjectSpec) -> bool:
    return any(p.action == "run_stop" for p in o.phases)


def _priority_roads(place: PlaceSpec, objects: dict[str, ObjectSpec]) -> tuple[str, ...]:
    """The positions by which only those come, where ego has a stop or yield sign, who neither stop nor give way."""
    waits = {o.placement.position for o in objects.values() if STAYS & {p.action for p in o.phases}}
    crossing = {o.placement.position for o in objects.values()} & {"crossing_left", "crossing_right"}
    return tuple(sorted(crossing - waits)) if place.control in ("stop", "yield") else ()


def _sets_out(o: ObjectSpec) -> bool:
    """Whether one who comes by another road first stands and then goes on."""
    actions = [p.action for p in o.phases]
    return o.placement.position in APPROACH_ANGLE and actions[:1] in (["stop"], ["wait"], ["stationary"])


def _forces(ego: EgoSpec, cid: str, o: ObjectSpec) -> bool:
    """Whether one that sets out at the junction does so before ego, which drives and answers to it."""
    drives = ego.speed != 0 and not STAYS & {p.action for p in ego.phases}
    answers = ego.reaction in ("brake", "yield") and ego.react_to == cid
    return drives and answers and not any(p.trigger for p in o.phases)


def _priority(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> bool:
    """Whether the stop sign that another passes or starts from is not ego's: they collide, or ego comes faster than to
    a stop."""
    if {"run_stop", "stop", "yield", "wait"} & {p.action for p in ego.phases} or ego.reaction == "yield":
        return False
    passing = {cid for cid, o in objects.items() if _runs_stop(o) or _sets_out(o)}
    meets = any(p.action == "collide" and p.target in (None, *passing) for p in ego.phases)
    meets = meets or any(p.action == "collide" for cid in passing for p in objects[cid].phases)
    return bool(passing) and (meets or middle(ego.speed or 0) > FAST)


def _place_kind(place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> PlaceSpec:
    """A road becomes an intersection where somebody turns or comes from a crossing road there."""
    positions = {o.placement.position for o in objects.values()}
    turns = any(p.action in ("turn_left", "turn_right", "run_red", "run_stop") for p in lanes.all_phases(ego, objects))
    wants = turns or positions & (APPROACH_ANGLE.keys() | {"intersection_exit"}) or place.control or place.arms
    crossing = positions & (APPROACH_ANGLE.keys() | {"intersection_exit"}) - {"circulating"}
    joins = place.kind == "road" and "circulating" not in positions
    if (joins and wants) or (crossing and place.kind in ("straight", "curve", "crosswalk")):
        place = place.model_copy(update={"kind": "intersection"})
    if "circulating" in positions and place.kind == "road":
        place = place.model_copy(update={"kind": "roundabout"})
    if "on_ramp" in positions and place.kind in ("road", "straight"):
        place = place.model_copy(update={"kind": "motorway"})
    if place.kind == "intersection" and place.control is None:  # who passes a light or a sign has one
        passed = {"run_red": "signal", "run_stop": "stop"}
        found = next((passed[p.action] for p in ego.phases if p.action in passed), None)
        others = {p.action for o in objects.values() for p in o.phases}
        place = place.model_copy(update={"control": found or ("signal" if "run_red" in others else None)})
    if place.control == "stop" and _priority(ego, objects):
        place = place.model_copy(update={"control": None})  # the sign is the other's
    if place.kind == "intersection" and place.manoeuvre is None:
        turn = {"turn_left": "left", "turn_right": "right", "u_turn": "u_turn"}
        found = next((turn[p.action] for p in ego.phases if p.action in turn), "straight")
        place = place.model_copy(update={"manoeuvre": found})
    return place

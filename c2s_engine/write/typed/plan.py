"""What a structure needs of its place, decided before any line is written: lanes, approaches, room, distances.

Pure: it looks at specs only. `make_plan` raises ResolveError, naming the fields, where specs contradict each other.
"""

import math
from dataclasses import dataclass, field

from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import references
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed import contradictions
from c2s_engine.write.typed.tables import DEFAULT_SPEED, LENGTH, MOVES_OFF_ROAD, is_static, is_vehicle, is_walker

JUNCTION = {"intersection", "roundabout"}
RAMP = {"on_ramp", "off_ramp"}
APPROACH_ANGLE = {"crossing_left": -90, "crossing_right": 90, "opposite_approach": 180}
APPROACH_NAME = {
    "crossing_left": "leftApproach",
    "crossing_right": "rightApproach",
    "opposite_approach": "oppositeApproach",
}
LANE_NAME = {-2: "farRightLane", -1: "rightLane", 0: "egoLane", 1: "leftLane", 2: "farLeftLane"}
TURN = {"turn_left": "LEFT_TURN", "turn_right": "RIGHT_TURN", "go_straight": "STRAIGHT", "u_turn": "U_TURN"}


LONGEST_APPROACH = 200.0
"""m of lane before a junction that maps can be expected to have."""


class ResolveError(ValueError):
    """Specs that contradict each other; `fields` names them."""

    def __init__(self, message: str, fields: tuple[str, ...]):
        super().__init__(message)
        self.fields = fields


@dataclass(frozen=True)
class Plan:
    """The place as the writer will ask for it, and what the fragments may refer to in it."""

    place: PlaceSpec
    duration: float  # s
    ego_speed: float  # m/s, the middle of it
    before: float  # m of lane wanted behind ego's start
    after: float  # m wanted ahead of it
    distance: float | tuple[float, float] | None  # m from ego's start to the junction or ramp
    offsets: frozenset[int]  # lane offsets from ego's (+1: one to the left) that fragments refer to
    base: int  # index of ego's lane in its group (0: rightmost, -1: leftmost)
    approaches: tuple[tuple[str, str], ...] = ()  # (position, turn type) that objects need
    oncoming: bool = False
    ramp: bool = False
    exit_lane: bool = False
    lane_of: dict[str, int | None] = field(default_factory=dict)  # object id -> lane offset at the start
    leads: dict[str, tuple[str, ...]] = field(default_factory=dict)  # object id -> who is ahead of it in its lane

    @property
    def turning(self) -> bool:
        """Whether ego's way takes a manoeuvre that the place names (`egoTurn`)."""
        return self.junction or self.ramp or self.place.kind in RAMP

    @property
    def junction(self) -> bool:
        return self.place.kind in JUNCTION


def turn_of(phases: tuple[Phase, ...], default: str = "STRAIGHT") -> str:
    """The manoeuvre type by which a behaviour passes the junction."""
    for phase in phases:
        if phase.action in TURN and phase.action != "u_turn":
            return TURN[phase.action]
    return default


def speed_of(spec: EgoSpec | ObjectSpec, place: PlaceSpec) -> float | tuple[float, float]:
    """The initial speed of a road user, m/s: its own, that of its first phase, or the usual one of its kind there."""
    if spec.speed is not None:
        return spec.speed
    if spec.phases:
        first = spec.phases[0]
        if first.action in ("stationary", "wait", "start", "enter_road") and first.trigger is None:
            return 0.0
        if first.speed is not None and first.action in (
            "keep_lane",
            "cross_road",
            "move_along",
            "follow",
            "go_straight",
        ):
            return first.speed
    kind = spec.type if spec.type in DEFAULT_SPEED else "car"
    usual = DEFAULT_SPEED[kind]
    return usual[place.kind if place.kind in usual else "road"]


def make_plan(structure: Structure, room: float = 1.0) -> Plan:
    """Decide what the place must offer; raises ResolveError. Where the specs leave the way to a junction open, `room`
    shortens it for maps with short roads."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    restrictions = structure.restrictions.spec
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    _placed_after(structure)
    place = _place_kind(place, ego, objects)
    if place.kind == "on_ramp":  # beside a ramp there is the motorway, on the left
        objects = {c: _on_the_left(o) for c, o in objects.items()}
    lane_of = {cid: _lane_offset(cid, objects) for cid in objects}
    if broken := contradictions.first(place, ego, objects.values()):
        raise ResolveError(broken.because, broken.fields)
    ramp = any(o.placement.position == "on_ramp" for o in objects.values())
    oncoming = place.oncoming is True or _needs_oncoming(ego, objects)
    if place.kind not in {"motorway", *RAMP} and place.oncoming is None and _beside(objects) == "left":
        oncoming = True  # the far side of a street lies beyond its oncoming lanes
    offsets = _offsets(place, ego, objects, lane_of)
    if ramp or place.kind in RAMP:
        place, base, offsets = _ramp_lanes(place, offsets, ramp)
    else:
        place, base, offsets = _lanes(place, offsets, "right" if pulls_out(ego) else _beside(objects))
    if oncoming:
        place = place.model_copy(update={"oncoming": True})
    approaches = tuple(
        sorted(
            {
                (o.placement.position, turn_of(o.phases))
                for o in objects.values()
                if o.placement.position in APPROACH_ANGLE
            }
        )
    )
    speed = middle(speed_of(ego, place))
    duration = getattr(restrictions, "duration", None) or 20.0
    return Plan(
        place=place,
        duration=duration,
        ego_speed=speed,
        before=_before(ego, objects, speed),
        after=_after(place, speed, duration, ego, objects),
        distance=_distance(place.model_copy(update={"kind": "on_ramp"}) if ramp else place, speed, objects, room),
        offsets=offsets,
        base=base,
        approaches=approaches,
        oncoming=oncoming,
        ramp=ramp,
        exit_lane=any(o.placement.position == "intersection_exit" for o in objects.values()),
        lane_of=lane_of,
        leads=_leads(ego, objects, lane_of, speed, place),
    )


def _placed_after(structure: Structure) -> None:
    """An object is placed relative to one that is written before it; T's conditions name what is there."""
    known = {"ego"}
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        for name, other in (("of", spec.placement.of), ("hidden_by", spec.placement.hidden_by)):
            if other is not None and other not in known:
                where = f"{component.id}.placement.{name}"
                raise ResolveError(
                    f"{component.id} is placed by {other}, which is not there before it: move it", (where,)
                )
        known.add(component.id)
    for c in (structure.ego, structure.restrictions, *structure.objects):
        if missing := references(c) - known - {"E"}:
            raise ResolveError(f"{c.id} names {', '.join(sorted(missing))}, which is not there", (c.id,))


def _on_the_left(o: ObjectSpec) -> ObjectSpec:
    if o.placement.position not in ("right_lane", "beside"):
        return o
    return o.model_copy(update={"placement": o.placement.model_copy(update={"position": "left_lane"})})


def _all_phases(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> list[Phase]:
    return [*ego.phases, *(p for o in objects.values() for p in o.phases)]


def _place_kind(place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> PlaceSpec:
    """A road becomes an intersection where somebody turns or comes from a crossing road there."""
    positions = {o.placement.position for o in objects.values()}
    turns = any(p.action in ("turn_left", "turn_right", "run_red", "run_stop") for p in _all_phases(ego, objects))
    wants = turns or positions & (APPROACH_ANGLE.keys() | {"intersection_exit"}) or place.control or place.arms
    crossing = positions & (APPROACH_ANGLE.keys() | {"intersection_exit"})
    if (place.kind == "road" and wants) or (crossing and place.kind in ("straight", "curve", "crosswalk")):
        place = place.model_copy(update={"kind": "intersection"})
    if "on_ramp" in positions and place.kind in ("road", "straight"):
        place = place.model_copy(update={"kind": "motorway"})
    if place.kind == "intersection" and place.manoeuvre is None:
        turn = {"turn_left": "left", "turn_right": "right", "u_turn": "u_turn"}
        found = next((turn[p.action] for p in ego.phases if p.action in turn), "straight")
        place = place.model_copy(update={"manoeuvre": found})
    return place


def _lane_offset(cid: str, objects: dict[str, ObjectSpec], seen: tuple[str, ...] = ()) -> int | None:
    """How many lanes to the left of ego's an object starts; None: on no lane of ego's direction."""
    placement = objects[cid].placement
    if cid in seen:
        raise ResolveError(f"{cid} is placed relative to itself", (f"{cid}.placement.of",))
    of: int | None = 0
    if placement.of != "ego":
        if placement.of not in objects:
            raise ResolveError(
                f"{cid} is placed relative to {placement.of}, which is not there", (f"{cid}.placement.of",)
            )
        of = _lane_offset(placement.of, objects, (*seen, cid))
    step = {"ahead": 0, "behind": 0, "partly_in_lane": 0, "left_lane": 1, "right_lane": -1}.get(placement.position)
    if placement.position == "beside":
        step = -1 if placement.side == "right" else 1
    return None if of is None or step is None else of + step


def _leads(
    ego: EgoSpec, objects: dict[str, ObjectSpec], lane_of: dict[str, int | None], speed: float, place: PlaceSpec
) -> dict[str, tuple[str, ...]]:
    """Who starts ahead of each moving vehicle in its lane, ego included."""
    at = {"ego": 0.0}
    for cid, o in objects.items():  # each is placed by one before it
        placement = o.placement
        gap = middle(placement.gap) if placement.gap is not None else default_gap(o, speed, place)
        behind = placement.along == "behind" or (placement.position == "behind" and placement.along is None)
        abreast = placement.position == "beside" or placement.along == "abreast"
        own = gap + LENGTH[o.type] / 2 + 2.5
        at[cid] = at.get(placement.of, 0.0) + (0.0 if abreast else -own if behind else own)
    lanes: dict[str, int | None] = {"ego": 0, **lane_of}
    changes = ego.reaction == "evade" or {"lane_change", "overtake", "cut_in"} & {p.action for p in ego.phases}
    comes = (1, -1) if changes else ()  # the lanes that ego may come to
    movers = [c for c, o in objects.items() if is_vehicle(o.type) and not is_static(o) and lane_of[c] is not None]

    def before(cid: str, other: str) -> bool:
        if other != "ego" and lanes[other] == 0 and any(p.action == "cut_in" for p in objects[cid].phases):
            return other != cid  # whom it finds there, wherever it comes from
        same = lanes[other] == lane_of[cid] or other == "ego" and lane_of[cid] in comes
        return same and other != cid and at[other] > at[cid]

    return {c: tuple(o for o in at if before(c, o)) for c in movers if objects[c].placement.facing != "against"}


def _needs_oncoming(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> bool:
    if any(o.placement.position == "oncoming_lane" for o in objects.values()):
        return True
    return any(p.action in ("oncoming", "u_turn") for p in _all_phases(ego, objects))


def _offsets(
    place: PlaceSpec, ego: EgoSpec, objects: dict[str, ObjectSpec], lane_of: dict[str, int | None]
) -> frozenset[int]:
    """All lane offsets that positions and lane changes reach."""
    used = {0} | {k for k in lane_of.values() if k is not None}
    if place.kind == "off_ramp" and place.ego_lane in ("middle", "leftmost"):
        used.add(-1)
    movers = [(0, ego.phases, ego)] + [(lane_of[c], o.phases, o) for c, o in objects.items()]
    one_lane = place.lanes is None and (place.oncoming is True or place.kind == "roundabout")
    narrow = place.lanes == 1 or one_lane  # lane changes then go by the oncoming lane or the verge
    for start, phases, spec in movers:
        k = start
        for phase in phases:
            if k is None:
                break
            if phase.action in ("lane_change", "cut_out") and not (narrow and used == {0}):
                k += -1 if phase.side == "right" else 1
            elif phase.action == "cut_in":
                k = 0
            elif phase.action == "overtake" and k in (0, lane_of.get(phase.target or "", 0)) and not narrow:
                used.add(k + (-1 if phase.side == "right" else 1))
            used.add(k)
        if spec is ego and ego.reaction == "evade" and not narrow:
            used.add(1)
    return frozenset(used)


def pulls_out(ego: EgoSpec) -> bool:
    """Whether ego stands at the kerb at first and pulls out from there."""
    return bool(ego.phases) and ego.phases[0].action == "enter_road"


def _beside(objects: dict[str, ObjectSpec]) -> str | None:
    """The side of the road on which somebody waits to cross or stands: ego drives next to it."""
    sides = [o.placement.side or "right" for o in objects.values() if o.placement.position in MOVES_OFF_ROAD]
    return sides[0] if sides else None


def _lanes(place: PlaceSpec, offsets: frozenset[int], beside: str | None) -> tuple[PlaceSpec, int, frozenset[int]]:
    """Ego's lane and the number of lanes, so that every offset exists."""
    left, right = max(offsets), -min(offsets)
    needed = 1 + left + right
    if needed > 3:
        raise ResolveError(
            "more than three neighbouring lanes are referred to; maps have three", ("R.lanes", "O.placement")
        )
    wish = place.ego_lane
    if wish is None and (left or right):
        wish = "middle" if left and right else "rightmost" if left else "leftmost"
    if wish is None and beside:
        wish = "rightmost" if beside == "right" else "leftmost"
    if wish == "rightmost" and right or wish == "leftmost" and left or wish == "middle" and max(left, right) > 1:
        side = "right" if wish == "rightmost" else "left"
        raise ResolveError(
            f"ego is in the {wish} lane, but something refers to a lane on its {side}: "
            "change R.ego_lane or the placement",
            ("R.ego_lane", "O.placement.position"),
        )
    lanes = max(place.lanes or 0, needed, 3 if wish == "middle" else 2 if wish and (left or right) else 0)
    base = {"rightmost": 0, "leftmost": -1, "middle": 1, None: 0}[wish]
    update: dict = {"ego_lane": wish, "lanes": lanes or place.lanes}
    return place.model_copy(update=update), base, offsets


def _ramp_lanes(place: PlaceSpec, offsets: frozenset[int], ramp: bool) -> tuple[PlaceSpec, int, frozenset[int]]:
    """At a ramp ego's lane is given: the ramp itself, the rightmost lane, or (leaving) one to the left of that."""
    left, right = max(offsets), -min(offsets)
    most_left, most_right = (1, 0) if place.kind == "on_ramp" else (1, 1) if place.kind == "off_ramp" else (2, 0)
    if left > most_left or right > most_right:
        raise ResolveError("at this ramp there is no such neighbouring lane", ("R.kind", "O.placement.position"))
    if place.kind == "on_ramp":
        offsets |= {1}
    return place.model_copy(update={"ego_lane": None, "lanes": None}), 0, offsets


def _before(ego: EgoSpec, objects: dict[str, ObjectSpec], speed: float) -> float:
    """How much lane there must be behind ego's start, m."""

    def back(o: ObjectSpec, depth: int = 0) -> float:
        """How far behind ego an object reaches."""
        gap = high(o.placement.gap) if o.placement.gap is not None else default_gap(o, speed)
        step = LENGTH[o.type] + (high(o.spacing) if o.spacing is not None else 3.0)
        behind = o.placement.along == "behind" or (o.placement.position == "behind" and o.placement.along is None)
        own = (gap + LENGTH[o.type] + 10 + (o.count - 1) * step) * (1 if behind else -1)
        parent = objects.get(o.placement.of)
        return max(own, 0) + (back(parent, depth + 1) if parent and depth < 8 else 0)

    reach = max((back(o) for o in objects.values()), default=0)
    backing = 20 if any(p.action == "reverse" for p in ego.phases) else 0
    return math.ceil(max(25.0, reach) + backing)


def _furthest(objects: dict[str, ObjectSpec]) -> float:
    """How far ahead of ego the furthest object on its way starts, m."""

    def at(o: ObjectSpec, seen: int = 0) -> float:
        here = high(o.placement.gap) if o.placement.gap is not None else default_gap(o, 14)
        here += (o.count - 1) * (LENGTH.get(o.type, 5) + 3) + 6
        if o.placement.of != "ego" and o.placement.of in objects and seen < 8:
            here += at(objects[o.placement.of], seen + 1)
        return here

    ways = {"ahead", "left_lane", "right_lane", *_BESIDE}
    return max(
        (at(o) for o in objects.values() if o.placement.position in ways and o.placement.along != "behind"), default=0
    )


def _after(place: PlaceSpec, speed: float, duration: float, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> float:
    fastest = max([speed, *(middle(speed_of(o, place)) for o in objects.values() if is_vehicle(o.type))])
    for phase in _all_phases(ego, objects):
        if phase.speed is not None:
            fastest = max(fastest, high(phase.speed))
    far = _furthest(objects)
    far = max(
        [far, *(_oncoming_gap(o, speed, place) for o in objects.values() if o.placement.position == "oncoming_lane")]
    )
    limit = {"curve": 450.0, "crosswalk": 150.0}.get(place.kind, 1050.0)
    wanted = max(fastest * min(duration, 20) + far * 0.5, far + 60, 150)
    return min(math.ceil(wanted / 50) * 50.0, limit)


def _distance(
    place: PlaceSpec, speed: float, objects: dict[str, ObjectSpec], room: float
) -> float | tuple[float, float] | None:
    """From ego's start to what lies ahead of it, m."""
    if place.kind not in JUNCTION | RAMP | {"crosswalk"}:
        return None
    far = max((_junction_side(o, speed, place) for o in objects.values()), default=0)
    if place.distance is not None:
        if high(place.distance) < far:
            raise ResolveError(
                f"ego starts {high(place.distance):.0f} m before the intersection, but an object stands further ahead: "
                "enlarge R.distance or lessen the gap",
                ("R.distance", "O.placement.gap"),
            )
        return place.distance if low(place.distance) >= far else (far, high(place.distance))
    if far > LONGEST_APPROACH:
        raise ResolveError(
            f"an object would stand {far:.0f} m ahead of ego, approaches have {LONGEST_APPROACH:.0f} m: lessen the gap",
            ("O.placement.gap",),
        )
    base = max(min(4.0 * speed, 110), 35.0, *(_to_pass(o, speed, place) for o in objects.values()))
    base = max(base, 60.0) if place.kind in RAMP else base
    return round(max(base * max(room, 0.4), far + 4), 1)


def _to_pass(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far (m) ego drives until it is well past a slower rider at the edge of its lane."""
    if o.placement.position != "partly_in_lane" or is_static(o) or not is_vehicle(o.type) or ego_speed <= 0:
        return 0
    gap = middle(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)
    closing = 1 - middle(speed_of(o, place)) / ego_speed
    return min((gap + 12) / closing, 90.0) if closing > 0.2 else 0


_BESIDE = {"partly_in_lane", "parked", "roadside", "sidewalk"}


def _junction_side(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far ahead of ego an object reaches that must stand before the junction, m."""
    placement = o.placement
    ways = {"ahead", "left_lane", "right_lane", "oncoming_lane", *_BESIDE}
    if placement.position not in ways or placement.along == "behind":
        return 0
    gap = high(placement.gap) if placement.gap is not None else default_gap(o, ego_speed, place)
    step = LENGTH[o.type] + (high(o.spacing) if o.spacing is not None else 3.0)
    return gap + LENGTH[o.type] + 5 + (o.count - 1) * step


def _oncoming_gap(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    return high(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)


def default_gap(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None = None) -> float:
    """The gap (m) where the text gives none: about two seconds to a moving object, more to a standing one."""
    position = o.placement.position
    if position == "beside" or (o.placement.along == "abreast" and position in ("left_lane", "right_lane")):
        return 0.0
    if position == "oncoming_lane":
        if place and place.kind in JUNCTION | RAMP:  # it is still before the junction
            return 60.0
        own = middle(speed_of(o, place)) if place else ego_speed
        return max(60.0, min(5.5 * (ego_speed + own), 260.0))
    if position == "intersection_exit":
        return 14.0
    if is_static(o) or not is_vehicle(o.type) or position in MOVES_OFF_ROAD:
        return max(30.0, min(4.0 * ego_speed, 90.0), _while_crossing(o, ego_speed, place))
    if position == "behind" or o.placement.along == "behind":
        return max(12.0, 1.2 * ego_speed)
    if position in ("left_lane", "right_lane") and any(p.action == "cut_in" for p in o.phases) and o.speed != 0:
        return 10.0
    return max(12.0, min(1.6 * ego_speed, 45.0))


def reach(o: ObjectSpec, place: PlaceSpec) -> float:
    """From where somebody stands beside the road to the middle of ego's lane, m."""
    own = 3.2 if o.placement.hidden_by else 4.75 if o.placement.position == "sidewalk" else 3.25
    two_way = place.kind not in {"motorway", *RAMP}
    far = o.placement.side == "left" and two_way and not o.placement.hidden_by
    return own + (3.5 * (place.lanes or 1) if far else 0)


def _while_crossing(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None) -> float:
    """How far (m) ego drives while somebody comes from beside the road into its lane: they must be that far ahead."""
    crosses = any(p.action in ("cross_road", "enter_road") for p in o.phases)
    if place is None or not crosses or not (is_walker(o.type) or o.type == "bicycle"):
        return 0.0
    pace = max(middle(speed_of(o, place)), 0.8)
    return min(reach(o, place) / pace * ego_speed + 8, 150.0)

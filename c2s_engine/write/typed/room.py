"""How much road a structure takes: behind ego's start, ahead of it, and up to the junction, ramp or crosswalk, in m."""

import math
from itertools import takewhile

from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.ahead import FOLLOWED
from c2s_engine.write.typed.contradictions import ResolveError
from c2s_engine.write.typed.lanes import all_phases
from c2s_engine.write.typed.tables import APPROACH_ANGLE, JUNCTION, LENGTH, RAMP, TURN, is_static, is_vehicle
from c2s_engine.write.typed.usual import at_corner, default_gap, has_marking, row_length, speed_of, uses_crosswalk

MERGES_SOON = 40.0
"""m before a ramp's end from which ego drives along the whole acceleration lane."""
LONGEST_APPROACH = 200.0
"""m of lane before a junction that maps can be expected to have."""
AT_THE_EDGE = 10.5
"""m from ego's middle to the junction before which it stands: with room for a crosswalk."""
USUAL_RUN = 20.0
"""s for which there is road."""
SHORTEST = 0.4
"""The least share of the wanted way to a junction; a map that has not even that may have it across another one."""
MOVES_OVER = 6.0
"""s of driving before a ramp in which another has changed its lane, as ego sees it do."""
PAST = 25.0
"""m from behind another to where the one that overtook it is well past."""
INSIDE = 28.0
"""m from there where others come to a wide junction, and ego, to where their ways cross."""
_BESIDE = {"partly_in_lane", "parked", "roadside", "sidewalk"}


def too_near(distance: float) -> ResolveError:
    """What lies ahead is nearer to ego's start (m) than an object that stands before it."""
    return ResolveError(
        f"ego starts {distance:.0f} m before the intersection, but an object stands further ahead: "
        "enlarge R.distance or lessen the gap",
        ("R.distance", "O.placement.gap"),
    )


def too_far(reach: float) -> ResolveError:
    """Objects before a junction reach further (m) than approaches do."""
    return ResolveError(
        f"an object would stand {reach:.0f} m ahead of ego, approaches have {LONGEST_APPROACH:.0f} m: lessen the gap",
        ("O.placement.gap",),
    )


def before(ego: EgoSpec, objects: dict[str, ObjectSpec], speed: float, place: PlaceSpec) -> float:
    """How much lane there must be behind ego's start, m."""

    def back(o: ObjectSpec, depth: int = 0) -> float:
        """How far behind ego an object reaches."""
        gap = high(o.placement.gap) if o.placement.gap is not None else default_gap(o, speed, place)
        behind = o.placement.along == "behind" or (o.placement.position == "behind" and o.placement.along is None)
        own = (gap + 10 + row_length(o)) * (1 if behind else -1)
        parent = objects.get(o.placement.of)
        return max(own, 0) + (back(parent, depth + 1) if parent and depth < 8 else 0)

    reach = max((back(o) for o in objects.values()), default=0)
    backing = 20 if any(p.action == "reverse" for p in ego.phases) else 0
    return math.ceil(max(25.0, reach) + backing)


def _furthest(objects: dict[str, ObjectSpec], speed: float, place: PlaceSpec) -> float:
    """How far ahead of ego the furthest object on its way starts, m."""

    def at(o: ObjectSpec, seen: int = 0) -> float:
        here = high(o.placement.gap) if o.placement.gap is not None else default_gap(o, max(speed, 14.0), place)
        here += (o.count - 1) * (LENGTH.get(o.type, 5) + 3) + 6
        if o.placement.of != "ego" and o.placement.of in objects and seen < 8:
            here += at(objects[o.placement.of], seen + 1)
        return here

    ways = {"ahead", "left_lane", "right_lane", *_BESIDE}
    return max(
        (at(o) for o in objects.values() if o.placement.position in ways and o.placement.along != "behind"), default=0
    )


def fastest(place: PlaceSpec, speed: float, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> float:
    """The speed of whoever is the fastest, m/s."""
    phases = [high(phase.speed) for phase in all_phases(ego, objects) if phase.speed is not None]
    return max([speed, *phases, *(middle(speed_of(o, place)) for o in objects.values() if is_vehicle(o.type))])


def after(place: PlaceSpec, speed: float, ego: EgoSpec, objects: dict[str, ObjectSpec]) -> float:
    """How much road there must be ahead of ego's start, m: the same however long the run is."""
    far = _furthest(objects, speed, place)
    far = max(
        [far, *(_oncoming_gap(o, speed, place) for o in objects.values() if o.placement.position == "oncoming_lane")]
    )
    limit = {"curve": 450.0, "crosswalk": 150.0}.get(place.kind, 1050.0)
    wanted = max(fastest(place, speed, ego, objects) * USUAL_RUN + far * 0.5, far + 60, 150)
    return min(math.ceil(wanted / 50) * 50.0, limit)


def behind_junction(objects: dict[str, ObjectSpec], speed: float, place: PlaceSpec) -> float:
    """How much of the lane behind the junction objects take, m."""
    taken = [0.0]
    for o in objects.values():
        if o.placement.position == "intersection_exit":
            gap = high(o.placement.gap) if o.placement.gap is not None else default_gap(o, speed, place)
            taken.append(gap + row_length(o) - LENGTH[o.type] / 2)
    return math.ceil(max(taken))


def distance(
    place: PlaceSpec, speed: float, ego: EgoSpec, objects: dict[str, ObjectSpec], room: float, met: bool = False
) -> float | tuple[float, float] | None:
    """From ego's start to what lies ahead of it, m; `met`: somebody who stands there is to set out in time."""
    if place.kind not in JUNCTION | RAMP | {"crosswalk"}:
        return None
    far = max((_junction_side(o, speed, place) for o in objects.values()), default=0)
    if place.distance is not None:
        if high(place.distance) < far:
            raise too_near(high(place.distance))
        return place.distance if low(place.distance) >= far else (far, high(place.distance))
    if far > LONGEST_APPROACH:
        raise too_far(far)
    if speed == 0 and place.kind in JUNCTION:  # ego stands at the junction's edge
        return round(max(AT_THE_EDGE, far + 4), 1)
    base = max(
        min(9.5 * speed, LONGEST_APPROACH - 20) if met else min(4.0 * speed, 120),
        min(35.0, 6.0 * speed),
        12.0,
        *(_to_pass(o, speed, place) for o in objects.values()),
        *(_to_meet(o, speed, place) for o in objects.values()),
        *(_to_overtake(cid, o, ego, speed, place) for cid, o in objects.items()),
        *(_to_turn_off(cid, o, ego, speed, place) for cid, o in objects.items()),
    )
    if place.kind in RAMP:  # the whole acceleration lane comes first where something is to happen at its end
        moves = any(p.action in ("lane_change", "cut_in", "cut_out") for o in objects.values() for p in o.phases)
        base = MERGES_SOON if to_merge_end(ego, objects) else max(base, MOVES_OVER * speed if moves else 60.0)
    return round(max(base * max(room, SHORTEST), far + 4), 1)


def to_merge_end(ego: EgoSpec, objects: dict[str, ObjectSpec]) -> bool:
    """Whether somebody does something at the end of the acceleration lane."""
    return any(p.trigger is not None and p.trigger.place == "merge_end" for p in all_phases(ego, objects))


def _to_pass(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far (m) ego drives until it is well past a slower rider at the edge of its lane."""
    ahead = o.placement.position == "partly_in_lane" and o.placement.along != "behind"
    if not ahead or is_static(o) or not is_vehicle(o.type) or ego_speed <= 0:
        return 0
    gap = middle(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)
    closing = 1 - middle(speed_of(o, place)) / ego_speed
    return min((gap + 12) / closing, 90.0) if closing > 0.2 else 0


def _to_meet(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far (m) ego is from the junction when one that comes by another road is at it, however slowly, that is then
    in ego's way together with ego."""
    own = middle(speed_of(o, place))
    comes = o.placement.position in APPROACH_ANGLE and o.placement.gap is None and is_vehicle(o.type)
    return min((ego_speed / own - 1) * INSIDE, LONGEST_APPROACH) if comes and 0 < own < ego_speed else 0


def _to_overtake(cid: str, o: ObjectSpec, ego: EgoSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far (m) ego drives while it overtakes an object before the junction, or that one ego."""
    by_ego = o.placement.position == "ahead" and _overtakes(ego.phases, (cid,))
    lane = o.placement.position in ("behind", "left_lane", "right_lane")
    by_it = lane and "behind" in (o.placement.position, o.placement.along) and _overtakes(o.phases, (None, "ego"))
    beside = o.placement.position == "partly_in_lane" and o.placement.along == "behind" and not is_static(o)
    by_it = by_it or beside and middle(speed_of(o, place)) > ego_speed + 2
    if ego_speed <= 0 or not (by_ego or by_it):
        return 0
    gap = middle(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)
    own = middle(speed_of(o, place))
    closing = max(abs(ego_speed - own), 5.0)
    turns = any(p.action in ("turn_left", "turn_right") for p in (ego if by_ego else o).phases)
    slows = max(own, ego_speed) ** 2 / 4 if turns else 0  # it brakes at 2 m/s2 for its turn
    return min((gap + PAST) / closing * ego_speed + slows, LONGEST_APPROACH)


def _to_turn_off(cid: str, o: ObjectSpec, ego: EgoSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far (m) ego starts from a junction at which one turns off whom it plainly follows first, and which then slows
    down for its turn."""
    followed = ego.phases[:1] and ego.phases[0].action == "follow" and ego.phases[0].target == cid
    if o.placement.position != "ahead" or not followed or not any(p.action in TURN for p in o.phases):
        return 0
    gap = middle(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)
    own = middle(speed_of(o, place))
    return min(gap + LENGTH[o.type] + own * FOLLOWED + own**2 / 6, LONGEST_APPROACH - 20)


def _overtakes(phases: tuple[Phase, ...], whom: tuple[str | None, ...]) -> bool:
    """Whether one of some is overtaken before a turn."""
    before = takewhile(lambda p: p.action not in TURN, phases)
    return any(p.action == "overtake" and p.target in whom for p in before)


def _junction_side(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    """How far ahead of ego an object reaches that must stand before the junction, m."""
    placement = o.placement
    ways = {"ahead", "left_lane", "right_lane", "oncoming_lane", *_BESIDE}
    behind = placement.along == "behind" and placement.position != "oncoming_lane"
    marked = has_marking(place) and uses_crosswalk(o)
    if placement.position not in ways or behind or marked or at_corner(o, place):
        return 0
    if placement.along == "abreast" or placement.position == "beside":
        return row_length(o) / 2
    gap = high(placement.gap) if placement.gap is not None else default_gap(o, ego_speed, place)
    return gap + 5 + row_length(o)


def _oncoming_gap(o: ObjectSpec, ego_speed: float, place: PlaceSpec) -> float:
    return high(o.placement.gap) if o.placement.gap is not None else default_gap(o, ego_speed, place)

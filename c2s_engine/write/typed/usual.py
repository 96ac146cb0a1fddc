"""What is usual where the specs leave it open: how fast somebody starts, how far off, by which manoeuvre."""

from itertools import takewhile

from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, Trigger
from c2s_engine.structure.vocabulary import WITH_SIREN
from c2s_engine.write.typed.tables import (
    DEFAULT_SPEED,
    HEIGHT,
    JUNCTION,
    LENGTH,
    MOVES_OFF_ROAD,
    RAMP,
    TURN,
    WIDTH,
    is_static,
    is_vehicle,
    is_walker,
)

UNDISTURBED = 3.0
"""s for which everybody drives on before what nothing triggers."""
SETS_OUT = 8.0
"""m/s at which somebody drives on that stood."""
SPEEDS_UP = 0.75
"""Of the speed to which one speeds up first, at what it does that, where nothing says how fast it is; of its own, to
what one slows down at most."""
STEADY = ("keep_lane", "cross_road", "move_along", "follow", "go_straight", "run_red", "run_stop", "turn_left",
          "turn_right", "lane_change", "cut_in", "cut_out", "oncoming", "overtake")  # fmt: skip
"""What one does first at a speed that is then its own."""
STOPS, STOPS_HARD = 3.5, 7.0
"""m/s2 with which one comes to a stand where nothing says how hard, and where it is said to brake hard."""
SLOWS_DOWN = 3.0
"""m/s2 at which one slows down for a turn."""
ROOM_BEHIND = 4.0
"""m that drivers keep behind who stands."""
TO_PULL_OUT = 3.0
"""s that it takes to get out from behind another."""
TO_COME_UP = 5.0
"""s before one with a siren is there, so that ego has the time to make way."""
LONGEST_VIEW = 320.0
"""m ahead of ego up to which others are placed of themselves."""


def turn_of(phases: tuple[Phase, ...], default: str = "STRAIGHT") -> str:
    """The manoeuvre type by which a behaviour passes the junction."""
    for phase in phases:
        if phase.action in TURN and phase.action != "u_turn":
            return TURN[phase.action]
    return default


def lets_ego_come(o: ObjectSpec) -> bool:
    """Whether one stands, at a junction, until ego has come near."""
    stands = next((i for i, p in enumerate(o.phases) if p.action in ("stop", "wait", "stationary")), len(o.phases))
    then = [p.trigger for p in o.phases[stands + 1 :] if p.trigger]
    return any(t.kind in ("ttc", "distance") and t.of in (None, "ego") for t in then)


def stopping(spec: EgoSpec | ObjectSpec, phase: Phase) -> float:
    """The m/s2 with which one comes to a stand in a phase."""
    if phase.rate is not None:
        return middle(phase.rate)
    return STOPS_HARD if getattr(spec, "hard", False) else STOPS


def slows_before(speed: float, slower: float, rate: float = SLOWS_DOWN) -> Trigger:
    """When one brakes from a speed so as to come to a junction at a slower one (m/s, m/s2)."""
    metres = max(speed**2 - slower**2, 0.0) / (2 * rate)
    return Trigger(kind="place", place="intersection", value=round(max(metres, 0.5), 1))


def speed_of(spec: EgoSpec | ObjectSpec, place: PlaceSpec) -> float | tuple[float, float]:
    """The initial speed of a road user, m/s: its own, that of its first phase, or the usual one of its kind there, at
    most what is posted; of who is on foot or crosses, that at which it goes."""
    if isinstance(spec, ObjectSpec) and (crosses(spec) or is_walker(spec)):
        return pace_of(spec)
    if spec.speed is not None:
        return spec.speed
    if spec.phases:
        first = spec.phases[0]
        if first.action in ("stationary", "wait", "start", "enter_road", "reverse") and first.trigger is None:
            return 0.0
        if first.speed is not None and first.action in STEADY:
            return first.speed
    kind = spec.type if spec.type in DEFAULT_SPEED else "car"
    usual, first_to = DEFAULT_SPEED[kind], _first_speed(spec)
    if first_to > 0:  # another speed than its own
        common = middle(usual[place.kind if place.kind in usual else "road"])
        gains = spec.phases[0].action == "accelerate"
        return min(common, SPEEDS_UP * first_to) if gains else max(common, first_to / SPEEDS_UP)
    turns = isinstance(spec, ObjectSpec) and turn_of(spec.phases) != "STRAIGHT" and "turning" in usual
    found = usual["turning"] if turns else usual[place.kind if place.kind in usual else "road"]
    return found if place.speed_limit is None else min(found, place.speed_limit)


def _first_speed(spec: EgoSpec | ObjectSpec) -> float:
    """To which speed (m/s) somebody first speeds up or slows down; 0: it does neither, or nothing says to which."""
    first = spec.phases[0] if spec.phases else None
    changes = first is not None and first.action in ("accelerate", "brake")
    return middle(first.speed) if changes and first.speed is not None else 0.0  # type: ignore[union-attr]


def pace_of(o: ObjectSpec) -> float | tuple[float, float]:
    """How fast somebody on foot, or who rides over the road, goes when it goes, m/s."""
    stated = [s for s in (o.speed, *(p.speed for p in o.phases)) if s is not None and high(s) > 0]
    usual = DEFAULT_SPEED.get(o.type, DEFAULT_SPEED["thing"])["road"]
    return stated[0] if stated else usual if o.phases or o.speed is None else 0.0


IN_QUEUE = 3.0
"""m between those who wait at a junction one behind the other."""
QUEUED = 2.0
"""m between those who stand in a queue."""


NOSE_TO_TAIL = 1.0
"""m between those that are parked one behind the other."""
CLOSEST = 0.3
"""m between the members of a row at least."""
SIDE_BY_SIDE = 0.5
"""m between people who go together."""


def spacing_of(o: ObjectSpec) -> float | tuple[float, float]:
    """The m between the members of a row: as stated; nose to tail where parked or in a queue, closer for people."""
    if o.spacing is not None:
        return o.spacing
    if is_walker(o):
        return SIDE_BY_SIDE
    queues = o.speed == 0 and o.placement.position in ("ahead", "left_lane", "right_lane", "oncoming_lane")
    return NOSE_TO_TAIL if o.placement.position == "parked" else QUEUED if queues and is_vehicle(o.type) else 3.0


def extent(o: ObjectSpec) -> float:
    """How much of the road's length one takes, m."""
    return WIDTH[o.type] if o.placement.facing == "across" else LENGTH[o.type]


def row_step(o: ObjectSpec) -> float:
    """From one member of a row to the next, m."""
    return extent(o) + max(middle(spacing_of(o)), CLOSEST)


def row_length(o: ObjectSpec) -> float:
    """How long a row is at most, m."""
    return o.count * extent(o) + (o.count - 1) * max(high(spacing_of(o)), CLOSEST)


def default_gap(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None = None) -> float:
    """The gap (m) where the text gives none: about two seconds to a moving object, more to a standing one.

    Whom ego catches up with is so far off that ego drives a while at its speed before it has to brake.
    """
    gap = _open_gap(o, ego_speed, place)
    if place is None or place.distance is None or place.kind not in {*JUNCTION, *RAMP, "crosswalk"}:
        return gap
    return min(gap, max(low(place.distance) - row_length(o) - 6.0, 3.0))  # it stands before what lies ahead


def _open_gap(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None) -> float:
    position = o.placement.position
    if position == "beside" or (o.placement.along == "abreast" and position in ("left_lane", "right_lane")):
        return 0.0
    drives = is_vehicle(o.type) and not is_static(o)
    against = position in ("ahead", "partly_in_lane") and o.placement.facing == "against" and drives
    if position == "oncoming_lane" or against:
        if place and place.kind in JUNCTION | RAMP:  # it is still before the junction
            return 60.0
        own = 0.0 if is_static(o) else middle(speed_of(o, place)) if place else ego_speed
        return max(60.0, min(5.5 * (ego_speed + own), 260.0))
    if position == "intersection_exit":
        return 3.0 if place and place.kind == "roundabout" else 14.0  # on the ring, whose pieces are short
    queues = ego_speed == 0 and position in ("ahead", "behind") and place is not None and place.kind in JUNCTION
    if queues and middle(speed_of(o, place)) == 0:  # type: ignore[arg-type]
        return IN_QUEUE
    if is_static(o) and position == "behind":
        return 8.0  # of interest only to who backs up
    if rides_beside(o) and o.placement.along == "behind":
        return 5.0
    if is_static(o) or not is_vehicle(o.type) or position in MOVES_OFF_ROAD:
        catching = _to_catch(o, ego_speed, place) if position not in MOVES_OFF_ROAD else 0.0
        return max(30.0, min(4.0 * ego_speed, 90.0), while_crossing(o, ego_speed, place), catching)
    if position == "behind" or o.placement.along == "behind":
        own = middle(speed_of(o, place)) if place else ego_speed
        first, closing = o.phases[0].action if o.phases else "", max(own - ego_speed, 0.0)
        brakes = position != "behind" and first in ("brake", "stop") and closing > 1
        pulls_out = position == "behind" and first != "follow" and any(p.action == "overtake" for p in o.phases)
        comes_up = ego_speed == 0 and position == "behind" and o.placement.of == "ego"  # to ego that stands
        comes_up = comes_up and all(p.action != "collide" for p in o.phases)
        return max(
            12.0,
            ROOM_BEHIND + 1.5 * ego_speed if first == "follow" else 1.2 * ego_speed,  # as it then keeps it
            own**2 / 8 if brakes else 0.0,
            (UNDISTURBED + TO_PULL_OUT / 2) * own + own**2 / (2 * SLOWS_DOWN) + ROOM_BEHIND if comes_up else 0.0,
            (TO_COME_UP if o.type in WITH_SIREN else TO_PULL_OUT) * closing + ROOM_BEHIND if pulls_out else 0.0,
        )
    if position in ("left_lane", "right_lane") and any(p.action == "cut_in" for p in o.phases) and o.speed != 0:
        return 10.0
    return max(12.0, min(1.6 * ego_speed, 45.0), _to_catch(o, ego_speed, place) - ROOM_BEHIND)


def _to_catch(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None) -> float:
    """How far (m) ahead a slower one must be for ego to hold its speed for some seconds and then to brake at 2 m/s2."""
    if place is None or o.placement.along == "behind":
        return 0.0
    own = 0.0 if is_static(o) else middle(speed_of(o, place))
    closing = max(ego_speed - own, 0.0)
    calm = {p.action for p in o.phases} <= {"keep_lane", "move_along", "follow"}
    to_stand = 2.5 if 12 < closing < 18 else 1.0  # so that it stands within the run
    to_creep = min(max(closing - 8, 1.0), 6.0) if calm else 1.0
    seconds = to_stand if is_static(o) else to_creep
    limit = 150.0 if place.kind in {*JUNCTION, *RAMP, "crosswalk"} else LONGEST_VIEW  # approaches are short
    return min(closing**2 / 4 + seconds * closing + ROOM_BEHIND, limit)


def reach(o: ObjectSpec, place: PlaceSpec) -> float:
    """From where somebody stands beside the road to the middle of ego's lane, m (over one or two lanes of the other
    direction)."""
    own = 3.2 if o.placement.hidden_by else 4.75 if o.placement.position == "sidewalk" else 3.25
    return own + (5.25 if far_side(o, place) else 0)


def far_side(o: ObjectSpec, place: PlaceSpec) -> bool:
    """Whether lanes of the other direction lie between somebody beside the road and ego's: the map says how many."""
    return o.placement.side == "left" and place.kind not in {"motorway", *RAMP} and not o.placement.hidden_by


def at_corner(o: ObjectSpec, place: PlaceSpec) -> bool:
    """Whether it stands at the corner of the junction before ego: what hides who comes from the side there."""
    at = o.placement
    beside = at.position in MOVES_OFF_ROAD and at.of == "ego" and at.gap is None and at.along != "behind"
    return o.type in HEIGHT and o.count == 1 and place.kind in JUNCTION and beside


def has_marking(place: PlaceSpec) -> bool:
    """Whether a crosswalk lies on ego's road, over which those go who cross it."""
    return place.kind == "crosswalk" or place.kind == "intersection" and bool(place.crosswalk)


def uses_crosswalk(o: ObjectSpec) -> bool:
    """Whether somebody crosses by the crosswalk on ego's way, where there is one: not who is placed otherwise."""
    placement = o.placement
    crosses = is_walker(o) and any(p.action == "cross_road" for p in o.phases)
    own = placement.gap is not None or placement.of != "ego" or placement.along in ("abreast", "behind")
    return crosses and placement.position in ("roadside", "sidewalk") and not own and not right_behind(o)


def crosses_there(o: ObjectSpec) -> bool:
    """Whether somebody on foot or on a bicycle crosses ego's road, where nothing says how far ahead."""
    placement = o.placement
    crosses = (is_walker(o) or o.type == "bicycle") and any(p.action == "cross_road" for p in o.phases)
    own = placement.of != "ego" or placement.along in ("abreast", "behind") or placement.hidden_by
    triggered = any(p.trigger is not None for p in o.phases)
    return crosses and placement.position in ("roadside", "sidewalk") and not own and not triggered


RIDES = {"move_along", "keep_lane", "go_straight", "overtake", "follow", "accelerate", "brake", "stop", "wait", "start",
         "swerve"}  # fmt: skip
"""What riders do who go along the road beside its lanes, and over a junction."""


def rides_beside(o: ObjectSpec) -> bool:
    """Whether a vehicle first goes along the road on the right of its lanes: on a cycle lane or the shoulder."""
    drives = is_vehicle(o.type) and o.placement.facing in (None, "along") and not is_static(o)
    beside = o.placement.position in ("roadside", "sidewalk") and o.placement.side != "left"
    actions = [p.action for p in o.phases]
    first = list(takewhile(lambda action: action in RIDES, actions))
    rides = o.type in ("bicycle", "motorcycle")
    passes = bool(o.speed and first) and first[0] != "start"
    return drives and beside and (first == actions if rides else passes)


def walks_first(o: ObjectSpec) -> bool:
    """Whether somebody on foot goes along the road before crossing it."""
    return is_walker(o) and bool(o.phases) and o.phases[0].action == "move_along"


def right_behind(o: ObjectSpec) -> bool:
    """Whether it stands by what hides it, wherever that is: who is on foot, things, and riders that cross."""
    beside = o.placement.position in MOVES_OFF_ROAD and (crosses(o) or not is_vehicle(o.type))
    return beside and o.placement.hidden_by is not None


def crosses(o: ObjectSpec) -> bool:
    """Whether somebody on foot or on a bicycle comes over the road or onto it."""
    does = any(p.action in ("cross_road", "enter_road") for p in o.phases)
    return does and (is_walker(o) or o.type == "bicycle")


TO_BEGIN = 2.0
"""s from the start until somebody sets out across the road."""


def while_crossing(o: ObjectSpec, ego_speed: float, place: PlaceSpec | None) -> float:
    """How far (m) ego drives until it is where somebody comes from beside the road into its lane: they must be that far
    ahead."""
    if place is None or not crosses(o):
        return 0.0
    seconds = TO_BEGIN + reach(o, place) / max(low(pace_of(o)), 0.8) + 0.5
    return min(seconds * ego_speed, 150.0)

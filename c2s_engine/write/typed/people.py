"""Who crosses ego's way from beside the road, on foot or riding: when they set out, how far they go."""

from itertools import takewhile

from c2s_engine.structure.components import Structure
from c2s_engine.structure.crossers import ANSWERS, crossed_vehicle
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import Quantity, high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.stations import at_door, inside, way_out
from c2s_engine.write.typed.tables import LENGTH, MOVES_OFF_ROAD, RUNS, WIDTH, is_walker
from c2s_engine.write.typed.threats import is_hit, room_left
from c2s_engine.write.typed.usual import crosses, pace_of, speed_of
from c2s_engine.write.typed.watching import watches

ACROSS = {"cross_road", "enter_road", "collide"}
ON_LANE = {"stop", "stationary", "wait", "move_along"}
"""What somebody does on ego's lane who came onto it."""
IN_WAY = 1.15
"""m from the middle of ego's way within which ego touches somebody."""
GONE = 2.2
"""m from the middle of ego's way from which ego takes somebody who walks on to be out of it."""
NEAR_MISS = (0.45, 0.85)
"""s by which somebody has left the middle of ego's way and `IN_WAY` before ego is there that does nothing about it."""
DRAWN = 0.2
"""s within which the moment is drawn that S leaves open."""
BEHIND = 0.5
"""s after ego would be there by which somebody is in its way yet."""
BRAKES = 7.0
"""m/s2 at which ego stops for who comes out in front of it."""
REACTS = 0.3
"""s that pass besides before ego brakes for who is on foot."""
YET = 0.5
"""s after which it still is a near miss where somebody has just left ego's way."""
TO_STOP = 0.7
"""s that ego needs for that besides: to see it, to react, and room to spare."""
SLOWS = 3.0
"""m/s2 at which it slows down for who it sees in time."""
AT_KERB = 2.0
"""s before ego is level with them by which they are there."""
PULLS_OUT = 2.4
"""m/s2 at which one pulls out from the kerb."""
BACKS_OUT = 3
"""m/s2 at which one backs out."""
CORNER = 0.3
"""m of its rear that are in ego's way when that is struck which backs out."""


def constants(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """`X_ARRIVES`, where somebody sets out across ego's way so as to meet it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    walks_into = is_walker(spec) and first is not None and first.action == "collide"
    if not (crosses(spec) or walks_into) or ego_stays(structure, plan):
        return []
    again, later = comes_again(structure, cid, spec), middle(spec.placement.later or 0.0)
    name = scope.constant(structure, cid)
    due = {} if states_when(spec) else {"ARRIVES": _arrival(structure, cid, spec, plan, again)}
    if again:
        due["RETURNS"] = round(_struck_at(structure, cid, spec, plan, max(middle(pace_of(spec)), 0.5)), 2)
    met = "RETURNS" if again else "ARRIVES"
    if later and met in due:
        due[met] = round(low(due[met]) + later, 2), round(high(due[met]) + later, 2)
    where = "at the kerb, by its way" if first and first.abandoned else "in the middle of its way, unhindered"
    whom = scope.reference(structure, crossed_vehicle(structure, cid))
    return [f"{name}_{when} = {scope.quantity(seconds)}  # s after {whom} {where}" for when, seconds in due.items()]


def comes_again(structure: Structure, cid: str, spec: ObjectSpec) -> Phase | None:
    """The second crossing of somebody on foot who has halted on the way, or gone back, and then meets ego."""
    across = [p for p in spec.phases if p.action in ("cross_road", "enter_road")]
    again = across[1] if len(across) > 1 and across[1].trigger is None else None
    return again if is_walker(spec) and _meets(structure, cid, spec) else None


def _arrival(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, again: Phase | None) -> Quantity:
    """How long (s) after ego's front somebody is in the middle of ego's way, if neither reacts.

    Where S leaves it open: so that they touch where S says so; that ego can just stop where it reacts; that ego takes
    them to be gone in time where they stop unexpectedly; that they just miss each other where ego does nothing.
    """
    pace = max(middle(pace_of(spec)), 0.5)
    if spec.placement.arrives is not None:
        return spec.placement.arrives
    if (other := crossed_vehicle(structure, cid)) != EGO:
        return _before(structure, cid, other, plan)
    if _meets(structure, cid, spec) and not again:
        return round(_struck_at(structure, cid, spec, plan, pace), 2)
    at = next(i for i, p in enumerate(spec.phases) if p.action in ACROSS)
    if spec.phases[at].abandoned:
        return -AT_KERB
    stays = spec.phases[at].action == "enter_road" or stays_there(spec.phases[at + 1 : at + 2])
    if spec.phases[at].action == "cross_road" and stays_there(spec.phases[at + 1 : at + 2]):
        ahead = max(GONE / pace, _to_slow(structure, plan))
    elif ego_reacts(structure, spec) and not _left_to_itself(structure, cid):
        by = structure[spec.placement.hidden_by].spec if spec.placement.hidden_by else None
        covered = inside(by) if isinstance(by, ObjectSpec) else 0.0
        seen = (way_out(structure, spec, plan.place) - covered) / pace
        needed = _to_slow(structure, plan) + REACTS - seen
        room = room_left(structure, cid)
        said = any(p.clearance is not None for p in getattr(structure.ego.spec, "phases", ()) if p.action == "stop")
        needed += (room or 0.0) / max(plan.ego_top, 1.0) if said else 0.0
        gone = IN_WAY / pace + (YET if said else 0.0)
        surprises, stays = by is not None or at_door(structure, spec) or again is not None, stays or again is not None
        ahead = max(0.0, needed if stays else min(needed, gone)) if surprises else 0.0
        if not stays and room is not None:  # it is there yet as ego stands
            ahead = max(ahead - IN_WAY / pace / 2, -BEHIND)
    else:
        least, most = (round(IN_WAY / pace + clear, 2) for clear in NEAR_MISS)
        return -most, -least
    return round(-ahead - DRAWN, 2), round(0.0 - ahead, 2)


def _before(structure: Structure, cid: str, other: str, plan: Plan) -> Quantity:
    """The same before another than ego: so that they touch, that the other can just stop, or that it is missed."""
    spec, crosser = structure[other].spec, structure[cid].spec
    assert isinstance(spec, ObjectSpec) and isinstance(crosser, ObjectSpec)
    stops = next((p for p in spec.phases if p.action in ("brake", "stop")), None)
    pace = max(middle(pace_of(crosser)), 0.5)
    if any(p.action == "collide" for p in (*spec.phases, *crosser.phases)):
        return 0.0
    if stops is None:
        least, most = (round(IN_WAY / pace + clear, 2) for clear in NEAR_MISS)
        return -most, -least
    rate = middle(stops.rate) if stops.rate is not None else SLOWS
    to_stand = TO_STOP + middle(speed_of(spec, plan.place)) / (2 * rate)
    ahead = max(to_stand - way_out(structure, crosser, plan.place) / pace, 0.0)
    return round(-ahead - DRAWN, 2), round(-ahead, 2)


def _to_slow(structure: Structure, plan: Plan) -> float:
    """How long (s) before ego would be there somebody is for whom it slows down, or stops, as S says."""
    phase = next((p for p in getattr(structure.ego.spec, "phases", ()) if p.action in ("brake", "stop")), None)
    goal = middle(phase.speed) if phase is not None and phase.action == "brake" and phase.speed is not None else 0.0
    rate = middle(phase.rate) if phase is not None and phase.rate is not None else SLOWS if goal else BRAKES
    top = max(plan.ego_top, 1.0)
    return TO_STOP + max(top**2 - goal**2, 0.0) / (2 * rate * top)


def _struck_at(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, pace: float) -> float:
    """The same where they touch: by the part of ego that S says; corners are a quarter of its width from its middle."""
    ego, part = structure.ego.spec, egos_part(structure, cid, spec)
    assert isinstance(ego, EgoSpec)
    from_left, width, passes = spec.placement.side == "left", WIDTH[ego.type], LENGTH[ego.type] / max(plan.ego_speed, 1)
    if part in ("front_left", "front_right"):
        short = (part == "front_left") == from_left
        return (width if short else -width) / 4 / pace
    if part in ("left", "right", "rear_left", "rear_right"):  # into its side, as it goes by
        share = 0.5 if part in ("left", "right") else 0.9
        return share * passes + (width + WIDTH[spec.type]) / 2 / pace
    return 0.0


def egos_part(structure: Structure, cid: str, spec: ObjectSpec) -> str | None:
    """The part of ego that touches somebody, as S says."""
    own = next((p.target_part for p in spec.phases if p.action == "collide"), None)
    phases = getattr(structure.ego.spec, "phases", ())
    return own or next((p.part for p in phases if p.action == "collide" and p.target in (None, cid)), None)


def stays_there(after: tuple[Phase, ...]) -> bool:
    """Whether what comes next is to stay on ego's lane."""
    return any(p.trigger is None and p.action in ON_LANE for p in after)


def comes_out(structure: Structure, cid: str, plan: Plan, phase: Phase, pace: float) -> str:
    """Until when a vehicle waits that pulls out from the kerb, or backs out of a space or driveway, so as to meet ego;
    "": nothing is to be met. `arrives` is when it comes into ego's way."""
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position not in MOVES_OFF_ROAD or _stated_by(phase):
        return ""
    meets, reacts = _meets(structure, cid, spec), ego_reacts(structure, spec)
    if ego_stays(structure, plan) or not (meets or reacts or spec.placement.arrives is not None):
        return ""
    corner = CORNER / max(pace, 0.5) if phase.action == "reverse" else 0.0
    ahead = corner if meets else TO_STOP + plan.ego_top / (2 * BRAKES)
    arrives = middle(spec.placement.arrives) if spec.placement.arrives is not None else -ahead
    if phase.action == "reverse":  # with its rear
        width = WIDTH[getattr(structure.ego.spec, "type", "car")]
        arrives += (LENGTH[spec.type] + width) / 2 / max(pace, 0.5)
        return f"until sets_out(self, ego, line, {scope.number(pace)}, {scope.number(round(arrives, 2))}, {BACKS_OUT})"
    rate = scope.number(middle(phase.rate) if phase.rate else PULLS_OUT)
    return f"until pulls_out(self, ego, line, {rate}, {scope.number(round(arrives, 2))})"


def _stated_by(phase: Phase) -> bool:
    comes = phase.action in ("enter_road", "reverse") and phase.target in (None, "ego")
    return phase.trigger is not None or not comes


def states_when(spec: ObjectSpec) -> bool:
    """Whether S says when somebody sets out across the road."""
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    return first is not None and tells_when(first.trigger)


def tells_when(t: Trigger | None) -> bool:
    """Whether a trigger says when; one that says only that somebody is near leaves it open."""
    if t is None:
        return False
    return watches(t) or t.kind in ("time", "action") or t.kind in ("distance", "ttc") and t.value is not None


def ego_stays(structure: Structure, plan: Plan) -> bool:
    """Whether ego stands there all the time."""
    phases = getattr(structure.ego.spec, "phases", ())
    return plan.ego_speed <= 0 and all(p.action in ON_LANE | {"yield"} for p in phases)


def ego_reacts(structure: Structure, spec: ObjectSpec) -> bool:
    """Whether ego does something about somebody: not what it does once it has run past its line, beyond them."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    beyond = spec.placement.position == "intersection_exit"
    phases = takewhile(lambda p: beyond or p.action not in RUNS, ego.phases)
    return ego.reaction != "none" or any(p.action in ANSWERS for p in phases)


def _left_to_itself(structure: Structure, cid: str) -> bool:
    """Whether all that ego does is about others."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    named = {whom for p in ego.phases for whom in (p.target, p.trigger.of if p.trigger else None)}
    return ego.react_to not in (None, cid) and cid not in named


def _meets(structure: Structure, cid: str, spec: ObjectSpec) -> bool:
    """Whether ego is to hit it, or it ego."""
    ego = structure.ego.spec
    return isinstance(ego, EgoSpec) and is_hit(ego, cid) or any(p.action == "collide" for p in spec.phases)



"""Who crosses ego's way from beside the road, on foot or riding: when they set out, how far they go."""

from itertools import takewhile

from c2s_engine.structure.components import Structure
from c2s_engine.structure.crossers import ANSWERS, crossed_vehicle
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import Quantity, high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.meetings import way_of_ego
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.stations import at_door, inside, way_out
from c2s_engine.write.typed.tables import LANE_NAME, LENGTH, MOVES_OFF_ROAD, RUNS, WIDTH, is_walker
from c2s_engine.write.typed.threats import is_hit, room_left
from c2s_engine.write.typed.usual import crosses, pace_of, speed_of, walks_first
from c2s_engine.write.typed.watching import watched, watches

ACROSS = {"cross_road", "enter_road", "collide"}
ON_LANE = {"stop", "stationary", "wait", "move_along"}
"""What somebody does on ego's lane who came onto it."""
IN_WAY = 1.15
"""m from the middle of ego's way within which ego touches somebody."""
AT_CORNER = 0.7
"""m from the middle of ego's way to who stands before a corner of ego."""
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
SLOWED = 0.25
"""m/s within which it has."""
RIDER_GAINS = 1.5
"""m/s2"""
SHORT_OF_LANE = 2.5
"""m from the middle of ego's way to where those stand who let it pass."""
SHORT_OF_KERB = 0.5
"""m before the road's edge where those halt who do not cross after all."""
AT_KERB = 2.0
"""s before ego is level with them by which they are there."""
STARTLED = 0.5
"""s in which somebody on foot does something about what comes into view."""
STEPS_BACK = 1.5
"""m that somebody on foot goes back who has come too far."""
PULLS_OUT = 2.4
"""m/s2 at which one pulls out from the kerb."""
BACKS_OUT = 3
"""m/s2 at which one backs out."""
CORNER = 0.3
"""m of its rear that are in ego's way when that is struck which backs out."""
RUN_OUT = 14
"""m by which a rider's line goes on beyond the road: it slows down on the last of them."""


def constants(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """`X_ARRIVES`, where somebody sets out across ego's way so as to meet it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    walks_into = is_walker(spec) and first is not None and first.action == "collide"
    if not (crosses(spec) or walks_into) or _ego_stays(structure, plan):
        return []
    again, later = _comes_again(structure, cid, spec), middle(spec.placement.later or 0.0)
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


def _comes_again(structure: Structure, cid: str, spec: ObjectSpec) -> Phase | None:
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
    stays = spec.phases[at].action == "enter_road" or _stays(spec.phases[at + 1 : at + 2])
    if spec.phases[at].action == "cross_road" and _stays(spec.phases[at + 1 : at + 2]):
        ahead = max(GONE / pace, _to_slow(structure, plan))
    elif _ego_reacts(structure, spec) and not _left_to_itself(structure, cid):
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
    ego, part = structure.ego.spec, _egos_part(structure, cid, spec)
    assert isinstance(ego, EgoSpec)
    from_left, width, passes = spec.placement.side == "left", WIDTH[ego.type], LENGTH[ego.type] / max(plan.ego_speed, 1)
    if part in ("front_left", "front_right"):
        short = (part == "front_left") == from_left
        return (width if short else -width) / 4 / pace
    if part in ("left", "right", "rear_left", "rear_right"):  # into its side, as it goes by
        share = 0.5 if part in ("left", "right") else 0.9
        return share * passes + (width + WIDTH[spec.type]) / 2 / pace
    return 0.0


def _egos_part(structure: Structure, cid: str, spec: ObjectSpec) -> str | None:
    """The part of ego that touches somebody, as S says."""
    own = next((p.target_part for p in spec.phases if p.action == "collide"), None)
    phases = getattr(structure.ego.spec, "phases", ())
    return own or next((p.part for p in phases if p.action == "collide" and p.target in (None, cid)), None)


def _stays(after: tuple[Phase, ...]) -> bool:
    """Whether what comes next is to stay on ego's lane."""
    return any(p.trigger is None and p.action in ON_LANE for p in after)


def walker(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of somebody on foot."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    phases = spec.phases or (Phase(action="stationary" if spec.speed == 0 else "move_along"),)
    across = f"self.heading {'-' if spec.placement.side == 'left' else '+'} 90 deg"
    heading = across if walks_first(spec) else "self.heading"
    usual, again = f"{scope.constant(structure, cid)}_SPEED", _comes_again(structure, cid, spec)
    lines = [f"line = {_egos_way(plan)}"] if any(map(_by_egos_way, phases)) else []
    begun = False
    for i, phase in enumerate(phases):
        then = phases[i + 1] if i + 1 < len(phases) else None
        if phase.action == "collide" and begun:  # it is on its way already
            continue
        own = scope.quantity(phase.speed) if phase.speed is not None and i > 0 else usual
        until = f" for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else ""
        waits = then is not None and (
            then.trigger and not until
            or _crosses_next(then) and (then is again or not begun) and phase.action not in ACROSS
        )
        if phase.until is not None:
            until = f" until {watched(structure, plan, phase.until, cid)}"
        elif then is not None and waits:
            until = f" until {_sets_out(structure, cid, spec, then, plan, own)}"
        if phase.action in ACROSS:
            if i == 0:
                lines.append(f"do Stand() until {_sets_out(structure, cid, spec, phase, plan, own)}")
                lines[-1] += _as_it_comes_out(structure, spec, phase, plan)
                if phase.trigger and phase.trigger.delay is not None:
                    lines.append(f"do Stand() for {scope.quantity(phase.trigger.delay)} seconds")
            lines.append(f"do Walk({heading}, {own}, {_how_far(structure, cid, phase, then, heading)}){until}")
            heading, begun = "self.heading", True
            if until and then is not None and then.action == "reverse":
                lines.append(f"do Stand(){until}")
        elif phase.action == "reverse":
            lasts = until if phase.duration is not None or phase.until is not None else ""
            back = "self.heading + 180 deg"
            off = i > 0 and phases[i - 1].action in ACROSS  # to where it came from
            metres = f"to_far_side(self, line, {back})" if off else f"{STEPS_BACK}"
            lines.append(f"do Walk({back}, {own}{'' if lasts else f', {metres}'}){lasts}")
            heading = "self.heading + 180 deg"
            if until != lasts:
                lines.append(f"do Stand(){until}")
        elif phase.action == "leave_road":
            if not begun:  # it is in the lane, and has come along it
                left = (phase.side == "left") != (spec.placement.facing == "against")
                back = f"self.heading {'+' if left else '-'} 90 deg"
            else:
                returns = phase.side in (None, spec.placement.side or "right")
                back = "self.heading + 180 deg" if returns else "self.heading"
            lines.append(f"do Walk({back}, {own}, to_far_side(self, line, {back})){until}")
        elif phase.action in ("stop", "stationary", "wait", "yield"):
            if phase.action == "yield" and not until:
                other = scope.reference(structure, phase.target) if phase.target else "ego"
                until = f" until passed({other}, self, 0)"
            lines.append(f"do Stand(){until or ('' if then is None else _stands_until(structure, cid, then))}")
        else:
            lines.append(f"do Walk(self.heading, {own}){until or ('' if then is None else ' for 2 seconds')}")
        if then is not None and waits and then.trigger and (delay := _delay(then.trigger)):
            lines.append(f"{lines[-1].removesuffix(until)} for {scope.quantity(delay)} seconds")
    return lines


def _stands_until(structure: Structure, cid: str, then: Phase) -> str:
    """How long one stands before what comes next: 2 s, or until ego, which answers to that, has slowed down before."""
    ego = getattr(structure.ego.spec, "phases", ())
    for before, phase in zip(ego, ego[1:], strict=False):
        t = phase.trigger
        if t and (t.kind, t.of, t.action) == ("action", cid, then.action) and before.action == "brake" and before.speed:
            return f" until ego.speed < {scope.number(round(middle(before.speed) + SLOWED, 1))}"
    return " for 2 seconds"


def _delay(t: Trigger) -> Quantity | None:
    """How long after what it waits for somebody on foot does something (s): what it sees takes it by surprise."""
    return t.delay if t.delay is not None or t.kind != "seen" else STARTLED


def _by_egos_way(phase: Phase) -> bool:
    """Whether what somebody does, or when, is told by ego's way."""
    return phase.action in {*ACROSS, "leave_road"} or phase.trigger is not None and phase.trigger.kind == "ttc"


def comes_out(structure: Structure, cid: str, plan: Plan, phase: Phase, pace: float) -> str:
    """Until when a vehicle waits that pulls out from the kerb, or backs out of a space or driveway, so as to meet ego;
    "": nothing is to be met. `arrives` is when it comes into ego's way."""
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.position not in MOVES_OFF_ROAD or _stated_by(phase):
        return ""
    meets, reacts = _meets(structure, cid, spec), _ego_reacts(structure, spec)
    if _ego_stays(structure, plan) or not (meets or reacts or spec.placement.arrives is not None):
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


def _crosses_next(then: Phase) -> bool:
    """Whether what comes next is to set out so that ego is met: what comes before lasts until then."""
    return then.action in ACROSS and then.trigger is None


def rider(structure: Structure, cid: str, plan: Plan) -> list[str]:
    """The behaviour of a cyclist that crosses the road from beside it."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    i = next(i for i, p in enumerate(spec.phases) if p.action in ACROSS)
    then = spec.phases[i + 1] if i + 1 < len(spec.phases) else None
    own = f"{scope.constant(structure, cid)}_SPEED"
    drive = f"Drive(straight_on(self, far), {own}, rate={RIDER_GAINS})"
    stops = then is not None and then.action in ON_LANE
    due = _sets_out(structure, cid, spec, spec.phases[i], plan, own, RIDER_GAINS)
    return [
        f"line = {_egos_way(plan)}",
        f"do Stop(straight_on(self)) until {due}",
        f"far = to_far_side(self, line, self.heading) + {RUN_OUT}",
        f"do {drive} until along_line(line, self.position)[1] < 1.5" if stops else f"do {drive}",
        *(["do Stop(straight_on(self))"] if stops else []),
    ]


def _egos_way(plan: Plan) -> str:
    """The way on which somebody meets ego."""
    return way_of_ego(plan) if plan.turning else f"route({LANE_NAME[0]})"


def states_when(spec: ObjectSpec) -> bool:
    """Whether S says when somebody sets out across the road."""
    first = next((p for p in spec.phases if p.action in ACROSS), None)
    return first is not None and _tells_when(first.trigger)


def _tells_when(t: Trigger | None) -> bool:
    """Whether a trigger says when; one that says only that somebody is near leaves it open."""
    if t is None:
        return False
    return watches(t) or t.kind in ("time", "action") or t.kind in ("distance", "ttc") and t.value is not None


def _ego_stays(structure: Structure, plan: Plan) -> bool:
    """Whether ego stands there all the time."""
    phases = getattr(structure.ego.spec, "phases", ())
    return plan.ego_speed <= 0 and all(p.action in ON_LANE | {"yield"} for p in phases)


def _ego_reacts(structure: Structure, spec: ObjectSpec) -> bool:
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


def _how_far(structure: Structure, cid: str, phase: Phase, then: Phase | None, heading: str) -> str:
    """To the other side of the road, or as far as what comes next asks; who comes onto it is in ego's way then."""
    if phase.abandoned:
        return f"to_kerb(self, {heading}, {scope.number(middle(phase.clearance or SHORT_OF_KERB))})"
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    remains = then is None and phase.action == "enter_road" and _ego_reacts(structure, spec)
    returns = then is not None and then.action in ("leave_road", "reverse")
    if remains or returns or then is not None and _stays((then,)):
        corner = {"front_left": 1, "front_right": -1}.get(_egos_part(structure, cid, spec) or "", 0)
        further = corner * (-1 if spec.placement.side == "left" else 1) * AT_CORNER
        return "along_line(line, self.position)[1]" + (f" {'+' if further > 0 else '-'} {AT_CORNER}" if corner else "")
    if then is not None and then.trigger is None and then.action == "yield":
        return f"along_line(line, self.position)[1] - {SHORT_OF_LANE}"
    return f"to_far_side(self, line, {heading})"


def _come_out(structure: Structure, spec: ObjectSpec, t: Trigger, plan: Plan) -> Trigger:
    """The trigger of somebody hidden: it is as it comes out that ego is so far away, which it does some steps later."""
    hider = structure[spec.placement.hidden_by].spec if spec.placement.hidden_by else None
    if t.kind != "distance" or t.of not in (None, "ego") or t.value is None or not isinstance(hider, ObjectSpec):
        return t
    sooner = plan.ego_top * inside(hider) / max(middle(pace_of(spec)), 0.5)
    return t.model_copy(update={"value": (round(low(t.value) + sooner, 1), round(high(t.value) + sooner, 1))})


def _as_it_comes_out(structure: Structure, spec: ObjectSpec, phase: Phase, plan: Plan) -> str:
    """A comment that says why somebody hidden sets out sooner than at the distance that S says; "": it does not."""
    t = phase.trigger
    if t is None or t.value is None or not _tells_when(t) or _come_out(structure, spec, t, plan) == t:
        return ""
    return f"  # {scope.number(middle(t.value))} m away as it comes out from behind what hides it"


def _sets_out(
    structure: Structure, cid: str, spec: ObjectSpec, phase: Phase, plan: Plan, speed: str, rate: float = 0
) -> str:
    """When somebody goes over to a phase: the stated trigger, or so that ego meets it on its way."""
    t = phase.trigger
    if t and t.kind == "ttc" and t.value is not None and not watches(t):  # of who stands until then
        other, value = scope.reference(structure, t.of or "ego"), scope.number(middle(t.value))
        if other != "ego":
            return f"gap(self, {other}) < {value} * max({other}.speed, 3)"
        return f"seconds_to(ego, line, along_line(line, self.position)[0]) < {value}"
    if t and _tells_when(t):
        return watched(structure, plan, _come_out(structure, spec, t, plan), cid)
    if _ego_stays(structure, plan):
        return "clock() >= 2"
    gained = f", {scope.number(rate)}" if rate else ""
    when = "RETURNS" if phase is _comes_again(structure, cid, spec) else "ARRIVES"
    if phase.abandoned:
        gained += f", metres={_how_far(structure, cid, phase, None, 'self.heading')}"
    whom = scope.reference(structure, crossed_vehicle(structure, cid))
    found = f"sets_out(self, {whom}, line, {speed}, {scope.constant(structure, cid)}_{when}{gained})"
    return f"{found} or {scope.reference(structure, cid)}.speed > 0.3" if spec.count > 1 else found

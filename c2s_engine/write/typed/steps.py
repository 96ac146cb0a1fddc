"""What a phase does: statements, the last of them a `do`, and the condition that ends it ("": nothing does)."""

import re
from collections.abc import Callable

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import lateral, scope, traffic
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.causes import comes, drives_ahead
from c2s_engine.write.typed.collisions import (
    Step,
    backs_into,
    brakes_into,
    collides,
    hit_next,
    sets_out_to_meet,
    struck_beside,
)
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.evasion import goes_round, loses_control, slides_there, swerves_by, swerves_too_late
from c2s_engine.write.typed.lanes import pulls_over
from c2s_engine.write.typed.overtakings import overtakes
from c2s_engine.write.typed.people import BACKS_OUT, PULLS_OUT
from c2s_engine.write.typed.tables import (
    AT_REST,
    LANE_WIDTH,
    LENGTH,
    MOVES_OFF_ROAD,
    RAMP,
    TURN,
)
from c2s_engine.write.typed.threats import every, is_hit
from c2s_engine.write.typed.towards import IN_MIDDLE, ROOM, SHORT, ending, held_for, stops_in_way, yields
from c2s_engine.write.typed.usual import SETS_OUT, STOPS, crosses, reach, stopping

NEAR_SPEED = 0.5
"""m/s within which a speed is reached, as `SlowTo` and `SpeedUpTo` have it."""


class Reached(str):
    """An end of a step: until its own speed is that at which it drives, within `NEAR_SPEED`."""

    def library(self, drive: str) -> str:
        """The driving library's behaviour for such a step."""
        return drive.replace("do Drive(", f"do {'SlowTo' if '<' in self else 'SpeedUpTo'}(", 1)


AT_LINE = Trigger(kind="place", place="intersection", value=0)
"""When somebody stops at the stop line of its approach."""
BROKEN_OFF = 1.7
"""m to the side after which a lane change is broken off: about half of the body is over the line then."""
BEYOND_EDGE = 4
"""m beyond the road's edge to where who leaves it heads."""
IN_JUNCTION = "until self._intersection"
"""When one is in the junction."""
HITS_SOON = "for 1 seconds"
"""How long one leaves its lane that then hits another."""
NOSE = 1.5
"""m by which one is in another's way that stops there."""
BACKING = 4.0
"""m/s above which nobody goes on backwards as it went ahead."""
CLOSER = 2.5
"""m by which one comes nearer to whom it follows than where it does something about that."""
SET_OUT = 3.0
"""m/s from which one that sets out changes lanes, where nothing says how fast it is by then."""
AT_MOST = 8
"""m/s2 that one brakes at most behind another that brakes hard."""
FULL = 5
"""m/s2 from which braking is meant to be full."""


def steps(course: Course, phase: Phase) -> list[Step]:
    """The steps of one phase; the course is moved on."""
    if slides_there(course, phase):
        return []
    course.out = course.out and phase.action in AT_REST
    if not course.backwards or phase.action == "reverse":
        return _OF.get(phase.action, _keep_lane)(course, phase)
    if phase.action in AT_REST:
        return [(["do Backwards(0)"], ending(phase, "for 3 seconds"))]
    if phase.action in ("leave_road", "drift"):
        steer = scope.number(0.25 * _side(phase, -1 if phase.action == "drift" else 1) * -1)
        out = f"do Backwards({scope.number(course.wanted(phase, course.value or 2))}, {steer})"
        return [([out], ending(phase, "for 4 seconds")), (["do Backwards(0)"], "for 3 seconds")]
    course.backwards = False
    (first, until), *rest = _OF.get(phase.action, _keep_lane)(course, phase)
    return [(["take SetReverseAction(False)", *first], until), *rest]


def _side(phase: Phase, default: int) -> int:
    return -1 if phase.side == "right" else 1 if phase.side == "left" else default


# Along the lane.


def _keep_lane(c: Course, p: Phase) -> list[Step]:
    goal = c.set(c.wanted(p, c.value))
    aside = f"lambda: leaving_room(self, line, {c.actor.ref(p.target)}, {scope.number(middle(p.clearance))})" \
        if p.clearance is not None else ""  # fmt: skip
    return [([c.drive(goal, middle(p.rate) if p.rate else None, aside)], ending(p, ""))]


def _over_junction(c: Course, p: Phase) -> list[Step]:
    """The line already turns; the phase is over when the junction is behind."""
    goal, rate = c.set(c.wanted(p, _moving(c))), middle(p.rate) if p.rate else None
    drive = c.drive(goal, rate)
    if not (c.actor.plan.junction and (c.actor.is_ego or c.actor.approach or c.lane is not None)):
        return [([drive], ending(p, ""))]
    phases = c.actor.spec.phases
    then = next(iter(phases[phases.index(p) + 1 :]), None) if p in phases else None
    if then is not None and held_for(c, then):  # it stops in the middle of its turn
        return [([drive], "until self.speed > 1.5")] if c.held else []
    over = [([drive], IN_JUNCTION), ([drive], "until not self._intersection")]
    over = over[c.held :]
    if not c.aside or p.action == "go_straight":
        return over
    c.aside = ""  # it turned from beside another
    return [*over, ([c.drive(goal, rate)], "")]


def _past_line(c: Course, p: Phase) -> list[Step]:
    """Past its red light or its stop sign: what comes next, of its own accord, begins in the junction."""
    goal, then = c.set(c.wanted(p, _moving(c))), _then(c, p)
    over = then is not None and then.action not in TURN and hit_next(c, p) is None
    return [([c.drive(goal, middle(p.rate) if p.rate else None)], ending(p, IN_JUNCTION if over else ""))]


def _stationary(c: Course, p: Phase) -> list[Step]:
    return [([c.drive("0", 4)], ending(p, ""))]


def _accelerate(c: Course, p: Phase) -> list[Step]:
    goal, own = c.wanted(p, max(c.value * 1.4, c.value + 5)), c.speed
    more = f"{own} + {scope.number(goal - c.value)}"
    c.set(goal, more if p.speed is None and c.value > 0 and own == c.actor.speed else "")
    c.value = goal
    drive = c.drive(rate=middle(p.rate) if p.rate else 2.5)
    return [([drive], ending(p, Reached(f"until self.speed > {scope.number(goal - NEAR_SPEED)}")))]


def _hard(c: Course) -> bool:
    return getattr(c.actor.spec, "hard", False)


def _brake(c: Course, p: Phase) -> list[Step]:
    if (into := brakes_into(c, p)) is not None:
        return into
    rate = middle(p.rate) if p.rate else (6 if _hard(c) else 3)
    lead = p.target or (getattr(c.actor.spec, "react_to", None) if c.actor.is_ego else None)
    if p.speed is None and p.trigger is None and lead and drives_ahead(c, lead):  # to as far behind as one drives
        return [([c.drive(c.pacing(lead, c.speed), rate if p.rate else AT_MOST)], ending(p, "for 4 seconds"))]
    if c.actor.is_ego and (beside := c.other(p.target)) and offset(beside, c.actor.spec, c.actor.plan.place):  # type: ignore
        before = f"short_of_ways(self, line, [{c.actor.ref(p.target)}], {c.speed}, rate={scope.number(rate)})"
        return [([c.drive(f"lambda: {before}", 9)], f"until clear_of_ways(self, line, [{c.actor.ref(p.target)}])")]
    full = (
        rate >= FULL and not c.actor.is_ego and p is c.actor.spec.phases[-1]
    )  # who slams the brakes on comes to a stand
    goal, own = c.wanted(p, 0.0 if full else c.value / 2), c.speed
    c.set(goal, f"{own} / 2" if p.speed is None and goal > 0 and own == c.actor.speed else "")
    c.value = goal or c.value
    drive = c.drive(c.speed if goal else "0", rate)
    return [([drive], ending(p, Reached(f"until self.speed < {scope.number(goal + NEAR_SPEED)}")))]


def _stop(c: Course, p: Phase) -> list[Step]:
    rate = stopping(c.actor.spec, p)
    drive = c.drive("0", rate)
    first: Step = ([drive], "until self.speed < 0.2")
    whom = p.target or (p.trigger.of if p.trigger else None)
    crossing = (other := c.other(whom)) is not None and crosses(other)
    if p.clearance is not None and p.target or crossing and c.actor.is_ego or comes(c, p):
        room = middle(p.clearance) if p.clearance is not None else ROOM
        late = p.rate or _hard(c) or not crossing
        more = f", room={scope.number(room)}" + (f", rate={scope.number(rate)}" if late else "")
        before = f"do StopBefore(line, [{every(c.actor.structure, str(whom))}]{more})"
        return [([before], ""), ([drive], ending(p, "for 1 seconds"))]
    if p.trigger and (p.trigger == AT_LINE or p.trigger.kind == "light") and (lane := c.actor.to_junction):
        own = "" if rate == STOPS else f", rate={scope.number(rate - 0.5)}"
        first = ([f"do StopAtLine(line, {lane}, {c.speed}{own})"], "")
    first = _short_of_them(c, p) or first
    if p.duration is None and (until := sets_out_to_meet(c)):
        return [first, ([drive], until)]
    return [first, ([drive], ending(p, "for 1 seconds"))]


def _short_of_them(c: Course, p: Phase) -> Step | None:
    """To a stand in the junction, short of the ways of those for whom one holds there; None: it holds elsewhere."""
    held = held_for(c, p)
    if not held:
        return None
    c.held = True
    reach: float = SHORT if p.target else IN_MIDDLE
    if c.actor.approach and stops_in_way(p):  # its nose, or where it is hit its middle
        struck = is_hit(c.actor.structure.ego.spec, c.actor.cid)  # type: ignore[arg-type]
        reach = -NOSE - (LENGTH[c.actor.spec.type] / 2 if struck else 0.0)
    rest = f"lambda: short_of_ways(self, line, [{', '.join(held)}], {c.speed}, room={scope.number(reach)})"
    return [c.drive(rest, 5)], "until self.speed < 0.2"


def _wait(c: Course, p: Phase) -> list[Step]:
    until = "" if p.duration is not None else sets_out_to_meet(c)
    first = _short_of_them(c, p)
    return [*([first] if first else []), ([c.drive("0", 4)], until or ending(p, "for 3 seconds"))]


def _start(c: Course, p: Phase) -> list[Step]:
    goal = c.wanted(p, c.actor.value or SETS_OUT)
    c.set(goal)
    phases = c.actor.spec.phases
    if c.actor.is_ego and p in phases and any(q.action == "yield" for q in phases[phases.index(p) + 1 :][:1]):
        return []  # it sets out up to where it lets that one pass
    drive, then = c.drive(scope.number(goal) if not c.actor.value else None, 2), _then(c, p)
    at, moves = goal - NEAR_SPEED, SET_OUT if then is not None and then.action in lateral.LATERAL else goal
    until = f"until self.speed > {scope.number(min(at, moves))}"
    return [([drive], ending(p, Reached(until) if at <= moves else until))]


def _follow(c: Course, p: Phase) -> list[Step]:
    return [([_behind(c, p)], ending(p, ""))]


def _behind(c: Course, p: Phase) -> str:
    """The drive of a phase of following: as fast as the other one goes; nearer than usual where that is to be seen."""
    c.set(c.wanted(p, max(_moving(c), c.target_speed(p))))
    gap = middle(p.gap) if p.gap is not None else _comes_up(c, p)
    return c.drive(c.pacing(p.target, c.speed, gap), 4)


def _comes_up(c: Course, p: Phase) -> float | None:
    """The gap (m) to which one comes up that then does something about whom it follows at a distance that is said."""
    then = _then(c, p)
    near = then.trigger if then is not None else None
    said = near is not None and near.kind == "distance" and near.value is not None and near.subject is None
    return max(middle(near.value) - CLOSER, 1.0) if said and near.of == (p.target or "ego") else None  # type: ignore


def _then(c: Course, p: Phase) -> Phase | None:
    """The phase that comes after one."""
    phases = list(c.actor.spec.phases)
    return next(iter(phases[phases.index(p) + 1 :]), None) if p in phases else None


def _u_turn(c: Course, p: Phase) -> list[Step]:
    back = c.drive(scope.number(c.wanted(p, 8)))
    if hit := hit_next(c, p):
        return [(["do TurnRound()"], f"until near(self, {c.actor.ref(hit.target)})")]
    return [(["do TurnRound()"], ""), (["line = route(place.oncoming_lane)", back], "")]


def _reverse(c: Course, p: Phase) -> list[Step]:
    c.backwards = True
    c.value = pace = c.wanted(p, c.value if 0 < c.value <= BACKING else 2.0)
    spec, back = c.actor.spec, f"do Backwards({scope.number(pace)})"
    if hit := hit_next(c, p):
        return backs_into(c, c.actor.ref(hit.target), pace)
    if isinstance(spec, ObjectSpec) and spec.placement.position in MOVES_OFF_ROAD:  # as far as onto the lane
        seconds = reach(spec, c.actor.plan.place) / max(pace, 0.5) + pace / (2 * BACKS_OUT)
        onto = f"for {scope.number(round(seconds, 1))} seconds"
        return [([back], ending(p, onto)), (["do Backwards(0)"], "for 3 seconds")]
    return [([back], ending(p, "for 3 seconds"))]


# To other lanes.


def _moving(c: Course) -> float:
    """Its speed, or that at which somebody who stood moves off, m/s."""
    return c.value or SETS_OUT


def _lane_change(c: Course, p: Phase) -> list[Step]:
    side, goal = _side(p, 1), c.wanted(p, _moving(c))
    if p.abandoned:
        return _back_again(c, p, side)
    shift = lateral.said(p)
    over = HITS_SOON if hit_next(c, p) else _until_over(p)
    narrow = c.lane is not None and len(c.actor.plan.offsets) == 1 and not c.on_ramp
    if narrow or c.oncoming:  # by the lane of the other direction, or the verge
        drive = c.drive(c.set(goal), offset=scope.number(side * LANE_WIDTH), shift=shift)
        return [([drive], ending(p, over))]
    line, speed, then = c.onto(side), c.set(goal), _then(c, p)
    if then is not None and then.action == "follow" and then.trigger is None and p.speed is None:
        return [([line, _behind(c, then)], ending(p, over))]
    if p.gap is not None and p.target and not traffic.in_front(c.actor.structure, c.actor.cid, p):  # behind that one
        speed = c.pacing(p.target, c.speed, middle(p.gap))
    return [([line, c.drive(speed, shift=shift)], ending(p, over))]


def _cut_in(c: Course, p: Phase) -> list[Step]:
    to = c.target_lane(p) or 0
    if p.abandoned:
        return _back_again(c, p, 1 if to > (c.lane if c.lane is not None else -1) else -1)
    c.lane, c.aside = to, ""
    shift = lateral.said(p)
    drive = c.drive(c.set(c.wanted(p, _moving(c))), shift=shift)
    over = HITS_SOON if hit_next(c, p) else _until_over(p)
    return [([c.along_lane(), drive], ending(p, over))]


def _until_over(p: Phase) -> str:
    """The end of a lane change: as it is all but in the middle of the other lane."""
    return f"for {scope.number(round(lateral.sideways(LANE_WIDTH - 0.7, lateral.shift_of(p)) + 0.4, 1))} seconds"


def _back_again(c: Course, p: Phase, side: int) -> list[Step]:
    """A lane change that is broken off: over the line by some of its width, and back."""
    goal, shift, said = c.set(c.wanted(p, _moving(c))), lateral.shift_of(p), lateral.said(p)
    out = c.drive(goal, offset=scope.number(side * BROKEN_OFF), shift=said)
    back = f"for {scope.number(round(lateral.sideways(BROKEN_OFF, shift) + 1, 1))} seconds"
    return [([out], ending(p, f"for {scope.number(round(lateral.sideways(BROKEN_OFF, shift) + 0.4, 1))} seconds")),
            ([c.drive(goal, shift=said)], back)]  # fmt: skip


def _enter_road(c: Course, p: Phase) -> list[Step]:
    c.lane = 0
    goal = c.wanted(p, c.actor.value or 7)
    c.value, c.speed = goal, scope.number(goal)
    drive = c.drive(scope.number(goal), middle(p.rate) if p.rate else PULLS_OUT)
    return [(["line = route(place.lane)", drive], ending(p, "for 5 seconds"))]


# Out of the lane.


def _sideways(c: Course, p: Phase, metres: float, shift: float, seconds: float | None) -> list[Step]:
    side = _side(p, -1 if metres < 0 else 1)
    if p.lateral_speed is not None:
        shift = lateral.shift_of(p)
        seconds = seconds and max(seconds, round(lateral.sideways(abs(metres), shift) + 0.5, 1))
    from_there = float(c.aside) if re.fullmatch(r"-?[\d.]+", c.aside) else 0.0
    out = c.drive(c.set(c.wanted(p, c.value)), offset=scope.number(from_there + side * abs(metres)), shift=shift)
    if hit := hit_next(c, p):
        return [([out], ending(p, f"until touch(self, {c.actor.ref(hit.target)})"))]
    if seconds is None:
        return [([out], ending(p, ""))]
    return [([out], ending(p, f"for {scope.number(seconds)} seconds")), ([c.drive()], "for 3 seconds")]


def _swerve(c: Course, p: Phase) -> list[Step]:
    if into := struck_beside(c, p) or swerves_too_late(c, p):
        return into
    if p.target is not None and not hit_next(c, p) and (c.actor.is_ego or c.comes_up_to(p.target)):
        return goes_round(c, p)
    found = _sideways(c, p, swerves_by(c), 2.5, 2.5)
    if getattr(c.actor.spec, "reaction", "") == "brake" and p.speed is None and p.trigger is None:  # both at once
        slower = c.drive(scope.number(0.4 * c.value), 6, scope.number(_side(p, 1) * swerves_by(c)), 2.5)
        return [([slower], found[0][1]), *found[1:]]
    return found


def _drift(c: Course, p: Phase) -> list[Step]:
    if into := struck_beside(c, p):
        return into
    c.out = True
    return _sideways(c, p, -3.2, 0.7, None)


def _leave_road(c: Course, p: Phase) -> list[Step]:
    if into := struck_beside(c, p):
        return into
    out = _off_the_road(c, "left" if p.side == "left" else "right")
    drive = c.drive(c.set(c.wanted(p, c.value)), offset=out, shift=2)
    phases = c.actor.spec.phases
    over = p in phases and pulls_over(c.actor.spec, phases.index(p))
    off = "" if p == phases[-1] else "until self._lane is None and self._intersection is None"
    off = "until clear_of_lanes(self) and self._intersection is None" if over else off
    c.out = True
    return [([drive], ending(p, HITS_SOON if hit_next(c, p) else off))]


def _off_the_road(c: Course, side: str) -> str:
    """How far to the left (m) it must get to be off all lanes, however many there are on that side."""
    own = "place.oncoming_lane" if c.oncoming else "place.lane"
    if c.lane is None and not (c.oncoming and c.actor.plan.oncoming):  # a road of which nothing is known
        return scope.number(LANE_WIDTH + 5 if side == "left" else -5)
    if side == "right":
        return f"-{own}.group.rightEdge.distanceTo(self.position) - {BEYOND_EDGE}"
    far = f"{own}.group.opposite.rightEdge"
    if c.actor.plan.place.kind in {"motorway", *RAMP}:
        far = f"{own}.group.leftEdge"
    elif not c.actor.plan.oncoming:
        far = f"({far} if {own}.group._opposite else {own}.group.leftEdge)"
    return f"{far}.distanceTo(self.position) + {BEYOND_EDGE}"


def _oncoming(c: Course, p: Phase) -> list[Step]:
    return _sideways(c, p, LANE_WIDTH, 2, middle(p.duration) if p.duration is not None else None)


_OF: dict[str, Callable[[Course, Phase], list[Step]]] = {
    "stationary": _stationary,
    "accelerate": _accelerate,
    "brake": _brake,
    "stop": _stop,
    "wait": _wait,
    "start": _start,
    "lane_change": _lane_change,
    "cut_out": _lane_change,
    "cut_in": _cut_in,
    "overtake": overtakes,
    "follow": _follow,
    "swerve": _swerve,
    "drift": _drift,
    "turn_left": _over_junction,
    "turn_right": _over_junction,
    "go_straight": _over_junction,
    "run_red": _past_line,
    "run_stop": _past_line,
    "u_turn": _u_turn,
    "enter_road": _enter_road,
    "leave_road": _leave_road,
    "reverse": _reverse,
    "oncoming": _oncoming,
    "yield": yields,
    "lose_control": loses_control,
    "collide": collides,
}
"""The others (keep_lane, cross_road and move_along of riders) keep the lane."""

"""What a phase does: statements, the last of them a `do`, and the condition that ends it ("": nothing does)."""

from collections.abc import Callable

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.tables import LANE_NAME, MOVES_OFF_ROAD, RAMP, is_walker
from c2s_engine.write.typed.threats import every_passed, slowed, standing
from c2s_engine.write.typed.usual import reach

LANE_WIDTH = 3.5
"""m, of most maps' lanes."""

NARROW = 2.0
"""m that riders keep aside from the middle of a car's lane where they pass it on the inside."""
NARROW_TYPES = {"bicycle", "motorcycle"}
LATE = "simulation().currentTime * simulation().timestep > 12"
"""When whoever is to hit another no longer waits for that one to slow down."""
FULL = 5
"""m/s2 from which braking is meant to be full."""

Step = tuple[list[str], str]


def steps(course: Course, phase: Phase) -> list[Step]:
    """The steps of one phase; the course is moved on."""
    if not course.backwards or phase.action == "reverse":
        return _OF.get(phase.action, _keep_lane)(course, phase)
    if phase.action in ("stop", "stationary", "wait"):
        return [(["do Backwards(0)"], _ending(phase, "for 3 seconds"))]
    if phase.action in ("leave_road", "drift"):
        steer = scope.number(0.25 * _side(phase, -1 if phase.action == "drift" else 1) * -1)
        out = f"do Backwards({scope.number(course.wanted(phase, course.value or 2))}, {steer})"
        return [([out], _ending(phase, "for 4 seconds")), (["do Backwards(0)"], "for 3 seconds")]
    course.backwards = False
    (first, until), *rest = _OF.get(phase.action, _keep_lane)(course, phase)
    return [(["take SetReverseAction(False)", *first], until), *rest]


def _ending(phase: Phase, natural: str) -> str:
    return f"for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else natural


def _side(phase: Phase, default: int) -> int:
    return -1 if phase.side == "right" else 1 if phase.side == "left" else default


# Along the lane.


def _keep_lane(c: Course, p: Phase) -> list[Step]:
    goal = c.set(c.wanted(p, c.value))
    return [([c.drive(goal, middle(p.rate) if p.rate else None)], _ending(p, ""))]


def _over_junction(c: Course, p: Phase) -> list[Step]:
    """The line already turns; the phase is over when the junction is behind."""
    goal = c.set(c.wanted(p, c.value))
    if not (c.actor.plan.junction and (c.actor.is_ego or c.actor.approach or c.lane is not None)):
        return [([c.drive(goal)], _ending(p, ""))]
    return [([c.drive(goal)], "until self._intersection"), ([c.drive(goal)], "until not self._intersection")]


def _stationary(c: Course, p: Phase) -> list[Step]:
    return [([c.drive("0", 4)], _ending(p, ""))]


def _accelerate(c: Course, p: Phase) -> list[Step]:
    goal = c.wanted(p, max(c.value * 1.4, c.value + 5))
    c.set(goal)
    c.value = goal
    drive = c.drive(rate=middle(p.rate) if p.rate else 2.5)
    return [([drive], _ending(p, f"until self.speed > {scope.number(goal - 0.5)}"))]


def _hard(c: Course) -> bool:
    return getattr(c.actor.spec, "hard", False)


def _brake(c: Course, p: Phase) -> list[Step]:
    rate = middle(p.rate) if p.rate else (6 if _hard(c) else 3)
    full = (
        rate >= FULL and not c.actor.is_ego and p is c.actor.spec.phases[-1]
    )  # who slams the brakes on comes to a stand
    goal = c.wanted(p, 0.0 if full else c.value / 2)
    c.set(goal)
    drive = c.drive(scope.number(goal), rate)
    return [([drive], _ending(p, f"until self.speed < {scope.number(goal + 0.5)}"))]


def _stop(c: Course, p: Phase) -> list[Step]:
    drive = c.drive("0", middle(p.rate) if p.rate else (7 if _hard(c) else 3.5))
    return [([drive], "until self.speed < 0.2"), ([drive], _ending(p, "for 1 seconds"))]


def _wait(c: Course, p: Phase) -> list[Step]:
    return [([c.drive("0", 4)], _ending(p, "for 3 seconds"))]


def _start(c: Course, p: Phase) -> list[Step]:
    goal = c.wanted(p, c.actor.value or 8)
    c.set(goal)
    drive = c.drive(scope.number(goal) if not c.actor.value else None, 2)
    return [([drive], _ending(p, f"until self.speed > {scope.number(goal - 0.5)}"))]


def _follow(c: Course, p: Phase) -> list[Step]:
    c.set(c.wanted(p, _moving(c)))
    pace = f"lambda: pace(self, {c.actor.ref(p.target)}, {c.speed})"
    return [([c.drive(pace, 4)], _ending(p, ""))]


def _u_turn(c: Course, p: Phase) -> list[Step]:
    back = c.drive(scope.number(c.wanted(p, 8)))
    return [(["do TurnRound()"], ""), (["line = way(oncomingLane)", back], "")]


def _reverse(c: Course, p: Phase) -> list[Step]:
    c.backwards = True
    pace = c.wanted(p, c.value or 2)
    spec, back = c.actor.spec, f"do Backwards({scope.number(pace)})"
    if any(q.action == "collide" for q in spec.phases):  # until it is stopped by whom it hits
        return [([back], "")]
    if isinstance(spec, ObjectSpec) and spec.placement.position in MOVES_OFF_ROAD:  # as far as onto the lane
        onto = f"for {scope.number(reach(spec, c.actor.plan.place) / max(pace, 0.5))} seconds"
        return [([back], _ending(p, onto)), (["do Backwards(0)"], "for 3 seconds")]
    return [([back], _ending(p, "for 3 seconds"))]


# To other lanes.


def _moving(c: Course) -> float:
    """Its speed, or that at which somebody who stood moves off, m/s."""
    return c.value or 8.0


def _lane_change(c: Course, p: Phase) -> list[Step]:
    if c.lane is not None and len(c.actor.plan.offsets) == 1 and not c.on_ramp:  # by the oncoming lane or the verge
        drive = c.drive(c.set(c.wanted(p, _moving(c))), offset=scope.number(_side(p, 1) * LANE_WIDTH))
        return [([drive], _ending(p, "for 6 seconds"))]
    line = c.onto(_side(p, 1))
    return [([line, c.drive(c.set(c.wanted(p, _moving(c))))], _ending(p, "for 5 seconds"))]


def _cut_in(c: Course, p: Phase) -> list[Step]:
    c.lane = c.target_lane(p) or 0
    change = [f"line = way({LANE_NAME[c.lane]})", c.drive(c.set(c.wanted(p, _moving(c))))]
    plan, ego = c.actor.plan, c.actor.structure.ego.spec
    forces = getattr(ego, "reaction", "") == "brake" and c.value > plan.ego_speed - 1
    if forces and p == c.actor.spec.phases[-1]:  # ego has to brake for it, so it does not pull away
        slower = c.drive(scope.number(0.75 * min(c.value, plan.ego_speed)), 3)
        return [(change, "for 2.5 seconds"), ([slower], "for 3 seconds"), ([c.drive()], "")]
    return [(change, _ending(p, "for 4 seconds"))]


def _enter_road(c: Course, p: Phase) -> list[Step]:
    c.lane = 0
    goal = c.wanted(p, c.actor.value or 7)
    c.value, c.speed = goal, scope.number(goal)
    drive = c.drive(scope.number(goal), middle(p.rate) if p.rate else 3)
    return [(["line = way(egoLane)", drive], _ending(p, "for 5 seconds"))]


def _overtake(c: Course, p: Phase) -> list[Step]:
    other = c.actor.ref(p.target)
    c.set(c.wanted(p, max(c.value, c.target_speed(p) + 5)))
    past = f"until lead_on(self, {other}) > 12 + self.length"
    back = c.drive(shift=3) if _scrapes(c, p) else ""
    if back:  # it comes back too early
        past = f"until lead_on(self, {other}) > -2"
    if c.oncoming_both(p):  # by ego's lane
        aside = c.drive(offset=scope.number(LANE_WIDTH), shift=2)
        return [([aside], past), ([c.drive()], "for 5 seconds")]
    if not c.same_lane(p) or c.lane is None:
        return [([c.drive()], past)]
    home, offsets = c.lane, c.actor.plan.offsets
    if home + 1 in offsets or home - 1 in offsets:
        line = c.onto(_side(p, 1))
        c.lane = home
        home_line = f"line = way({LANE_NAME[home]})"
        return [([line, c.drive()], past), ([home_line, back or c.drive()], "for 5 seconds")]
    aside = LANE_WIDTH if p.side != "right" else -NARROW if c.actor.spec.type in NARROW_TYPES else -LANE_WIDTH
    return [([c.drive(offset=scope.number(aside), shift=2)], past), ([back or c.drive()], "for 5 seconds")]


def _scrapes(c: Course, p: Phase) -> bool:
    """Whether it hits the one that it overtakes."""
    phases = c.actor.spec.phases
    after = phases[phases.index(p) + 1 :]
    return any(q.action == "collide" and q.target == p.target for q in after)


# Out of the lane.


def _sideways(c: Course, p: Phase, metres: float, shift: float, seconds: float | None) -> list[Step]:
    side = _side(p, -1 if metres < 0 else 1)
    out = c.drive(c.set(c.wanted(p, c.value)), offset=scope.number(side * abs(metres)), shift=shift)
    if seconds is None:
        return [([out], _ending(p, ""))]
    return [([out], _ending(p, f"for {scope.number(seconds)} seconds")), ([c.drive()], "for 3 seconds")]


def _swerve(c: Course, p: Phase) -> list[Step]:
    found = _sideways(c, p, 2.2, 2.5, 2.5)
    if getattr(c.actor.spec, "reaction", "") == "brake" and p.speed is None and p.trigger is None:  # both at once
        slower = c.drive(scope.number(0.4 * c.value), 6, scope.number(_side(p, 1) * 2.2), 2.5)
        return [([slower], found[0][1]), *found[1:]]
    return found


def _lose_control(c: Course, p: Phase) -> list[Step]:
    return _sideways(c, p, 2.0, 4, 1.5)


def _drift(c: Course, p: Phase) -> list[Step]:
    return _sideways(c, p, -3.2, 0.7, None)


def _leave_road(c: Course, p: Phase) -> list[Step]:
    lane, offsets, plan = c.lane or 0, c.actor.plan.offsets, c.actor.plan
    two_way = plan.place.kind not in {"motorway", *RAMP} and not c.oncoming
    if p.side == "left" and two_way and plan.oncoming:  # beyond the oncoming lanes, however many there are
        beyond = "egoLane.group.opposite.rightEdge.distanceTo(self.position) + 4"
        return [([c.drive(c.set(c.wanted(p, c.value)), offset=beyond, shift=2)], _ending(p, ""))]
    width = LANE_WIDTH * (max(offsets) - lane if p.side == "left" else lane - min(offsets))
    if p.side == "left" and two_way:  # beyond the oncoming lanes
        width += LANE_WIDTH * (plan.place.lanes or 2)
    return _sideways(c, p, -(width + 5), 2, None)


def _oncoming(c: Course, p: Phase) -> list[Step]:
    return _sideways(c, p, LANE_WIDTH, 2, middle(p.duration) if p.duration is not None else None)


# Towards another.


def _yield(c: Course, p: Phase) -> list[Step]:
    other, lane = c.actor.ref(p.target), c.actor.to_junction
    go = ([c.drive(c.set(c.wanted(p, c.actor.value or 8)), 2)], "for 4 seconds")
    if lane is None or _on_foot_behind(c, p):
        return [*_until_forced(c, p, other), go]
    end = f"{lane}.centerline[-1]"
    if c.same_lane(p):  # it is ahead: behind it up to the junction, until it has gone on over it
        behind = f"do Drive(line, lambda: pace(self, {other}, {c.speed}), rate=4)"
        clear = f"(distance from {other} to {end}) > 14 and (distance from self to {end}) < 14"
        return [([behind], f"until {clear}"), (go[0], "")]
    near = f"until (distance from self to {end}) < 5 + self.speed ** 2 / 6"
    return [([c.drive()], near), ([c.drive("0", 3)], f"until passed({other}, self)"), go]


def _on_foot_behind(c: Course, p: Phase) -> bool:
    """Whether the other is on foot where ego leaves the junction: it is let pass there, not before the junction."""
    spec = c.actor.structure[p.target].spec if p.target and p.target in c.actor.structure else None
    behind = isinstance(spec, ObjectSpec) and spec.placement.position == "intersection_exit" and is_walker(spec.type)
    return behind and c.actor.is_ego


def _until_forced(c: Course, p: Phase, other: str) -> list[Step]:
    """Where no junction says where to wait: what comes before letting the other pass, and the wait."""
    a, gone = c.actor, f"until passed({other}, self) or passed({other}, self, 0)"
    spec = a.structure[p.target].spec if p.target and p.target in a.structure else None
    if not a.is_ego or not isinstance(spec, ObjectSpec) or a.value <= 0:
        return [([c.drive("0", 4)], gone)]
    if "behind" in (spec.placement.position, spec.placement.along):  # aside, until it is ahead
        aside = c.drive("0", 2.5, "" if a.spec.phases[0].action == "lane_change" else scope.number(-0.8))
        return [([aside], f"until lead_on({other}, self) > self.length + {other}.length")]
    if spec.placement.position == "oncoming_lane":  # behind what stands in the lane, or where they would meet
        stands = standing(a.structure, a.plan.lane_of)
        near = f"(distance from self to {a.ref(stands)}) < 14 + self.speed ** 2 / 6" if stands else ""
        near = near or f"(distance from self to {other}) < 5 * self.speed"
        return [([c.drive()], f"until {near}"), ([c.drive("0", 3)], f"until passed({other}, self, 0)")]
    if p.target and (is_walker(spec.type) or spec.type == "bicycle"):
        waits = f"until {every_passed(a.structure, p.target)}"
        return [([c.drive()], f"until need(self, {other}) > 2"), ([c.drive("0", 3.5)], waits)]
    near = f"{other}.speed > 0.5 and (distance from self to {other}) < 5 + 5 * self.speed"
    return [
        ([c.drive()], f"until {near}"),
        ([c.drive(scope.number(0.5 * a.value), 2.5)], f"until {other}._lane is self._lane"),  # it lets it in
    ]


def _collide(c: Course, p: Phase) -> list[Step]:
    other = c.actor.ref(p.target)
    goal = c.wanted(p, c.value)
    c.set(goal)
    spec = c.actor.spec
    if isinstance(spec, ObjectSpec) and spec.placement.position == "oncoming_lane":  # head-on, in the other's lane
        return [([c.drive(offset=scope.number(LANE_WIDTH), shift=2)], "")]
    if c.actor.is_ego and any(q.action == "oncoming" for q in spec.phases):  # it stays there
        return [([c.drive(offset=scope.number(LANE_WIDTH), shift=2)], "")]
    if c.lane is None and not c.actor.is_ego:
        turn = ", egoTurn" if c.actor.plan.turning else ""
        spot = f"spot = meeting(line, way(egoLane{turn}))"
        later = (
            ", -0.3" if c.actor.plan.turning and p.target in (None, "ego") else ""
        )  # ego is in the midst of its turn
        return [([spot, f"do Drive(line, lambda: strike(self, {other}, spot, {c.speed}{later}))"], "")]
    if c.same_lane(p):
        faster = max(goal, c.target_speed(p) + 4)
        strike = ([c.drive(scope.number(faster) if faster > goal else None)], "")
        if until := slowed(c.actor, p.target):  # behind it until then
            behind = c.drive(f"lambda: pace(self, {other}, {scope.number(faster)})", 4)
            return [([behind], f"until {until} or {LATE}"), strike]
        return [strike]
    if c.lane is not None and not c.actor.is_ego:  # beside it: close behind until it comes over
        return [([f"do Drive(line, lambda: lurk(self, {other}, {c.speed}))"], "")]
    return [([c.drive()], "")]


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
    "overtake": _overtake,
    "follow": _follow,
    "swerve": _swerve,
    "drift": _drift,
    "turn_left": _over_junction,
    "turn_right": _over_junction,
    "go_straight": _over_junction,
    "u_turn": _u_turn,
    "enter_road": _enter_road,
    "leave_road": _leave_road,
    "reverse": _reverse,
    "oncoming": _oncoming,
    "yield": _yield,
    "lose_control": _lose_control,
    "collide": _collide,
}
"""The others (keep_lane, run_red, run_stop, cross_road and move_along of riders) keep the lane."""

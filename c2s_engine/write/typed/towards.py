"""What a driver does towards another one: letting it pass, running into it."""

from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.tables import MOVES_OFF_ROAD, is_walker
from c2s_engine.write.typed.threats import every_passed, slowed, standing

LANE_WIDTH = 3.5
"""m, of most maps' lanes."""
LATE = "simulation().currentTime * simulation().timestep > 12"
"""When whoever is to hit another no longer waits for that one to slow down."""

GOES_THERE = frozenset(
    ("oncoming", "leave_road", "reverse", "lane_change", "overtake", "turn_left", "turn_right", "u_turn")
)
"""What ego does that itself leads it out of its lane."""

Step = tuple[list[str], str]


def ending(phase: Phase, natural: str) -> str:
    """The condition that ends a phase: its stated duration, or what is natural to it."""
    return f"for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else natural


def yields(c: Course, p: Phase) -> list[Step]:
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
    if spec.placement.position == "on_ramp":  # it comes in ahead: no more room than that takes
        room = f"lambda: max({scope.number(0.7 * a.value)}, pace(self, {other}, {scope.number(0.9 * a.value)}, 0.5))"
        near = f"until (distance from self to {other}) < 40 and lead_on(self, {other}) > -40"
        return [([c.drive()], near), ([c.drive(room, 2.5)], f"until {other}._lane is self._lane")]
    near = f"{other}.speed > 0.5 and (distance from self to {other}) < 5 + 5 * self.speed"
    return [
        ([c.drive()], f"until {near}"),
        ([c.drive(scope.number(0.5 * a.value), 2.5)], f"until {other}._lane is self._lane"),  # it lets it in
    ]


def struck_beside(c: Course, p: Phase) -> list[Step]:
    """How one leaves the road towards what it hits there, if it does: straight for it from shortly before."""
    phases = c.actor.spec.phases
    hit = next((q.target for q in phases[phases.index(p) + 1 :] if q.action == "collide"), None)
    spec = c.actor.structure[hit].spec if hit and hit in c.actor.structure else None
    if not hit or not isinstance(spec, ObjectSpec) or spec.placement.position not in MOVES_OFF_ROAD:
        return []
    return _straight_for(c, p, hit)


def _straight_for(c: Course, p: Phase, hit: str) -> list[Step]:
    """Along the lane, and from shortly before straight for what is beside it."""
    other = c.actor.ref(hit)
    near = f"until (distance from self to {other}) < 15 + 1.5 * self.speed"
    straight = f"line = [self.position + ({other}.position - self.position).normalized() * (2 * k) for k in range(99)]"
    return [([c.drive(c.set(c.wanted(p, c.value)))], near), ([straight, c.drive()], "for 8 seconds")]


def collides(c: Course, p: Phase) -> list[Step]:
    other = c.actor.ref(p.target)
    goal = c.wanted(p, c.value)
    c.set(goal)
    beside = _beside_the_lane(c, p) if c.actor.is_ego else ""
    if _over_the_middle(c) or beside == "oncoming_lane":
        return [([c.drive(offset=scope.number(LANE_WIDTH), shift=2)], "")]
    if beside:
        return _straight_for(c, p, p.target or "")
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


def _over_the_middle(c: Course) -> bool:
    """Whether it drives in the lane of those that come towards it, from where it starts or later."""
    spec = c.actor.spec
    if isinstance(spec, ObjectSpec):
        return spec.placement.position == "oncoming_lane"
    return any(q.action == "oncoming" for q in spec.phases)


def _beside_the_lane(c: Course, p: Phase) -> str:
    """Where whom ego hits without having left its lane is, if that is beside ego's lane; else ""."""
    spec = c.actor.structure[p.target].spec if p.target and p.target in c.actor.structure else None
    alone = not {q.action for q in c.actor.spec.phases} & GOES_THERE
    if not alone or c.backwards or not isinstance(spec, ObjectSpec) or {"cross_road", "enter_road"} & _does(spec):
        return ""
    at = spec.placement.position or ""
    along = at in MOVES_OFF_ROAD or at == "partly_in_lane" or at == "oncoming_lane" and "oncoming" not in _does(spec)
    return at if along else ""


def _does(spec: ObjectSpec) -> set[str]:
    return {q.action for q in spec.phases}

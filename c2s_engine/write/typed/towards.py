"""How a driver lets another one pass."""

from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.collisions import Step
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.tables import is_walker
from c2s_engine.write.typed.threats import every_passed, standing


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

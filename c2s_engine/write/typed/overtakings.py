"""How one passes another: out of its lane where there is room, by, and back."""

from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.collisions import LANE_WIDTH, Step
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.lanes import leaves_lane
from c2s_engine.write.typed.tables import LANE_NAME, is_static, is_vehicle
from c2s_engine.write.typed.threats import hits_ego, is_hit, members

NARROW = 2.3
"""m that riders keep aside from the middle of a car's lane where they pass it on the inside."""
NARROW_TYPES = {"bicycle", "motorcycle"}
AHEAD = 12
"""m between the two where one may come back."""
BACK = "for 5 seconds"
BREAKS_OFF = {"brake", "swerve", "collide", "stop", "leave_road", "lane_change"}
"""What ego does after an overtaking that somebody who comes towards it spoils."""


def overtakes(c: Course, p: Phase) -> list[Step]:
    """The steps out, past the other (all of them where they are several) and back."""
    c.set(c.wanted(p, max(c.value, c.target_speed(p) + 5)))
    gains = f"lambda: gain(self, {nearest(c, p)}, {c.speed})"
    rate = braking(c, p)
    scrapes = _scrapes(c, p)  # it comes back too early
    past = " and ".join(f"lead_on(self, {one}) > {-6 if scrapes else f'{AHEAD} + self.length'}" for one in _whom(c, p))
    if c.oncoming_both(p):  # by ego's lane
        aside = c.drive(gains, rate, scope.number(LANE_WIDTH), 2)
        return [([aside], f"until {past}"), ([c.drive()], BACK)]
    if not c.same_lane(p) or c.lane is None:
        return [([c.drive()], f"until {past}")]
    if leaves_lane(c.other(p.target)):  # it clears the way
        return [([c.drive(gains, rate)], f"until {past}")]
    home, offsets = c.lane, c.actor.plan.offsets
    if home + 1 in offsets or home - 1 in offsets:
        line = c.onto(-1 if p.side == "right" else 1)
        c.lane = home
        home_line = f"line = way({LANE_NAME[home]})"
        return [([line, c.drive(gains, rate)], f"until {past}"), *([] if scrapes else [([home_line, c.drive()], BACK)])]
    inside = NARROW if c.actor.spec.type in NARROW_TYPES else LANE_WIDTH
    sideways = scope.number(-inside if p.side == "right" else LANE_WIDTH)
    aside = c.drive(gains, rate, sideways, 2)
    waits = [([c.drive(gains, rate)], f"until {free}")] if (free := _free(c, p)) else []
    return [*waits, ([aside], f"until {past}"), *([] if scrapes else [([c.drive()], BACK)])]


def nearest(c: Course, p: Phase) -> str:
    """The first that it passes: whom it overtakes, or who drives in the lane between the two."""
    cid, seen = p.target, set[str]()
    while (spec := c.other(cid)) and spec.placement.position == "ahead" and c.other(spec.placement.of):
        if spec.placement.of in (*seen, c.actor.cid):
            break
        cid = spec.placement.of
        seen.add(cid)
    return c.actor.ref(cid)


def braking(c: Course, p: Phase) -> float:
    """How hard it brakes at most behind whom it overtakes, m/s2."""
    spec = c.other(p.target)
    return 7 if spec and {"brake", "stop"} & {q.action for q in spec.phases} else 4


def _free(c: Course, p: Phase) -> str:
    """The condition under which nobody comes towards ego in the lane by which it passes; "": it need not wait."""
    ego = c.actor.spec
    after = {q.action for q in ego.phases[ego.phases.index(p) + 1 :]} if p in ego.phases else set()
    if not isinstance(ego, EgoSpec) or p.side == "right" or after & BREAKS_OFF:
        return ""
    comes = [o for o in c.actor.structure.objects if isinstance(o.spec, ObjectSpec) and _comes(o.spec)]
    if any(o.id == ego.react_to or hits_ego(o.spec) or is_hit(ego, o.id) for o in comes):  # type: ignore[arg-type]
        return ""
    gone = [f"(passed({one}, self, 0) or {one}.speed < 0.3)" for o in comes for one in members(c.actor.structure, o.id)]
    return " and ".join(gone)


def _comes(spec: ObjectSpec) -> bool:
    """Whether somebody drives towards ego in the next lane."""
    return spec.placement.position == "oncoming_lane" and is_vehicle(spec.type) and not is_static(spec)


def _whom(c: Course, p: Phase) -> list[str]:
    """Those it passes before it may come back: all members where they are in its lane, else the first."""
    if p.target is None or p.target not in c.actor.structure or not (c.same_lane(p) or c.oncoming_both(p)):
        return [c.actor.ref(p.target)]
    return members(c.actor.structure, p.target)


def _scrapes(c: Course, p: Phase) -> bool:
    """Whether it hits the one that it overtakes."""
    phases = c.actor.spec.phases
    after = phases[phases.index(p) + 1 :]
    return any(q.action == "collide" and q.target == p.target for q in after)

"""Running into another: on the way to it, and from shortly before at it, until both touch."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.lateral import sideways
from c2s_engine.write.typed.tables import APPROACH_ANGLE, LANE_WIDTH, MOVES_OFF_ROAD, is_static
from c2s_engine.write.typed.threats import STANDS, slowed
from c2s_engine.write.typed.usual import SETS_OUT, crosses

NUDGE = 2.0
"""m/s that are left at least to one who brakes too late for another that stands."""
LATE = "clock() > 12"
"""When whoever is to hit another no longer waits for that one to slow down."""
SLOWER = 1.0
"""m/s by which one who is slower than ego falls behind it."""
SETS_OUT_RATE = 2.0
"""m/s2 with which one sets out from its line, as `setting_out_to_meet` of the driving library has it."""
STOPS_AT = 6
"""m/s2 at which those brake who have hit another."""
LEFT, SLIDING = 0.35, 0.5
"""The share of its speed that is left to one that has braked, or slid, as it hits another, nobody says how much."""
BRAKED = 2.6
"""m/s by which one has braked that then slides."""
TRIES = ("brake", "lose_control")
"""What one does that does not keep it from hitting another."""
HARD = 6
"""m/s2 at which ego brakes hard that still hits whom it brakes for."""
TOO_LATE = 5
"""m/s2 at which one brakes hard, and too late."""
FASTER = 2.5
"""m/s by which ego, which brakes too late, is at least faster than whom it then hits."""
ASIDE = 0.6
"""m beside the middle of its lane by which one hits another there with a corner."""
TO_LEFT, TO_RIGHT = frozenset(("front_right", "rear_left")), frozenset(("front_left", "rear_right"))
"""The striker's front corner and the other's rear corner that touch where the striker drives further left, or right."""
OVER_EDGE, DRIFTS = 1.4, 0.8
"""m from the middle of its lane, and m/s sideways, at which one that drifts is over the edge of it."""
SIDEWAYS = frozenset(
    ("overtake", "lane_change", "cut_in", "cut_out", "swerve", "drift", "lose_control", "oncoming", "leave_road")
)
"""What leads out of the lane, so that the other is no longer straight ahead."""
GOES_THERE = frozenset(
    ("oncoming", "leave_road", "reverse", "lane_change", "overtake", "turn_left", "turn_right", "u_turn")
)
"""What ego does that itself leads it out of its lane."""
COMES_OVER = {"lane_change", "cut_in", "cut_out", "overtake", "drift", "swerve"}
"""What ego does that leads it into the next lane."""

Step = tuple[list[str], str]


def collides(c: Course, p: Phase) -> list[Step]:
    """The steps up to the contact: as it drives until both touch, where paths and times make them; nobody aims."""
    sets_off = not c.value and (c.actor.sets_out or "start" in _before(c, p))
    other, goal = c.actor.ref(p.target), c.wanted(p, SETS_OUT if sets_off else c.value)
    if braked := brakes_into(c, p):
        return [*braked, _stands(c)]
    if any(q.action in TRIES and q.rate is None and hits_at(c, q) is not None for q in _right_before(c, p)):
        return [_stands(c)]
    c.set(goal)
    c.aside = c.aside or by_corner(c, p)
    beside = _beside_the_lane(c, p) if c.actor.is_ego else ""
    if _over_the_middle(c) or beside == "oncoming_lane":
        return [([c.drive(offset=scope.number(LANE_WIDTH), shift=2)], f"until touch(self, {other})"), _stands(c)]
    evades = any(q.action == "swerve" and q.target == p.target for q in c.actor.spec.phases)
    if beside == "partly_in_lane" and evades and c.actor.is_ego:  # it has swerved too late
        return [_stands(c)]
    if beside:
        return straight_for(c, p, p.target or "")
    if "overtake" in _before(c, p) and c.lane is not None:  # it comes back too early
        return _from_line(c, c.along_lane(), other)
    if c.actor.approach or "enter_road" in _before(c, p) or _before(c, p) & SIDEWAYS:
        return _drives_on(c, other)
    side = _leaves_the_lane(c.actor.structure)
    if not in_its_lane(c, p):  # it comes over, unless the other does
        if not side or c.actor.is_ego:
            return _comes_over(c, p, other)
        waits = f"lambda: following_speed(self, {other}, {c.speed})"
        until = slowed(c.actor, p.target)
        return [*([([c.drive(waits, 4)], f"until {until} or {LATE}")] if until else []), *_drives_on(c, other)]
    if c.actor.is_ego:
        if p.speed is None and _just_drives(c.other(p.target)):  # nothing else brings ego to it
            c.set(max(goal, c.target_speed(p) + FASTER))
        return _drives_on(c, other)
    faster = max(goal, c.target_speed(p) + 4)
    if side:  # after it
        line = c.onto(side) if (c.lane or 0) + side in c.actor.plan.offsets else ""
        c.set(faster)
        return _from_line(c, line, other)
    until = slowed(c.actor, p.target)
    if not until:  # nothing else brings it to the other than that it is faster
        c.set(faster)
    elif until == STANDS and c.actor.value > 0 and not _pushes(c.actor.structure):  # it looks up too late
        slower = goal < c.actor.plan.ego_speed - SLOWER  # its own speed is that at which it hits ego
        comes = "EGO_SPEED" if slower else c.actor.speed
        left = scope.number(min(goal if p.speed is not None or slower else NUDGE, c.actor.value))
        left = f"{comes} / 3" if p.speed is None and not slower and c.actor.value > 3 * NUDGE else left
        return [([f"do BrakeTooLate(line, {other}, {comes}, {left})"], f"until touch(self, {other})"), _stands(c)]
    return _drives_on(c, other)


def _pushes(structure: Structure) -> bool:
    """Whether ego, which stands, is to be pushed into what stands ahead of it."""
    ego = structure.ego.spec
    targets = (p.target for p in getattr(ego, "phases", ()) if p.action == "collide")
    hit = (structure[cid].spec for cid in targets if cid in structure)
    stops = getattr(ego, "speed", None) == 0 or {"stop", "wait", "stationary"} & _does(ego)  # type: ignore[arg-type]
    return bool(stops) and any(isinstance(o, ObjectSpec) and o.placement.position == "ahead" for o in hit)


def _just_drives(spec: ObjectSpec | None) -> bool:
    """Whether one drives on as it does."""
    return spec is not None and not is_static(spec) and _does(spec) <= {"keep_lane", "follow", "move_along"}


def _comes_over(c: Course, p: Phase, other: str) -> list[Step]:
    """From the next lane onto the other's until both touch."""
    lane = c.target_lane(p)
    step = 0 if lane is None or c.lane is None else max(-1, min(1, lane - c.lane))
    return _from_line(c, c.onto(step) if step else "", other)


def _from_line(c: Course, line: str, other: str) -> list[Step]:
    """Along another line until both touch."""
    first, *rest = _drives_on(c, other)
    return [([*([line] if line else []), *first[0]], first[1]), *rest]


def _right_before(c: Course, p: Phase) -> tuple[Phase, ...]:
    phases = c.actor.spec.phases
    return phases[: phases.index(p)][-1:] if p in phases else ()


def _before(c: Course, p: Phase) -> set[str]:
    """What it does before a phase."""
    phases = c.actor.spec.phases
    return {q.action for q in phases[: phases.index(p)]} if p in phases else set()


def _drives_on(c: Course, other: str) -> list[Step]:
    """As before until both touch: it does not look, or nobody gives way."""
    rate = SETS_OUT_RATE if c.actor.sets_out else None
    return [([c.drive(rate=rate)], f"until touch(self, {other})"), _stands(c)]


def hits_at(c: Course, p: Phase) -> float | None:
    """The speed (m/s) that is left to one that brakes in a phase, too late, as it hits whom it hits then or next; None:
    it does not brake so. Whose ways cross brake though nothing says to what speed."""
    hit = hit_after(c, p) if p.action == "collide" or p.action == "brake" and p.rate is None else None
    cause = {p.target, p.trigger.of if p.trigger else None} - {None}
    if hit is None or not hit.target or hit is not p and (hit.trigger or not cause <= {hit.target}):
        return None
    across = ways_cross(c, hit)
    said = hit.speed if hit.speed is not None else p.speed
    if not across and (p is hit or not in_its_lane(c, hit)) or p is hit and said is None:
        return None
    goal = middle(said) if said is not None else (LEFT if p is hit or hit_next(c, p) else SLIDING) * c.value
    if not across and said is None and c.actor.is_ego:
        if stops_before(c.other(hit.target)):
            return None
        goal = min(max(goal, _ends_at(c, hit) + FASTER), c.value - BRAKED)  # it catches up with who drives on
    return goal if p is not hit or across and goal < c.value - SLOWER else None


def in_its_lane(c: Course, p: Phase) -> bool:
    """Whether whom one hits is in its lane then: from the first, or because that one comes there."""
    spec, lane = c.other(p.target), c.target_lane(p)
    if spec is None or lane is None:
        return c.same_lane(p)
    into = [q for q in spec.phases if q.action in ("cut_in", "lane_change") and not q.abandoned][-1:]
    comes = [0 if q.action == "cut_in" else lane + (-1 if q.side == "right" else 1) for q in into]
    return c.lane in (lane, *comes)


def by_corner(c: Course, hit: Phase) -> str:
    """How far (m) to the left of its lane's middle one drives that hits another in its lane with a corner, or at one of
    the other's; "": in the middle."""
    sides = {part for part in (hit.part, hit.target_part) if part} & {*TO_LEFT, *TO_RIGHT}
    if not sides or c.backwards or ways_cross(c, hit) or not in_its_lane(c, hit):
        return ""
    return scope.number(ASIDE) if sides <= TO_LEFT else scope.number(-ASIDE) if sides <= TO_RIGHT else ""


def stops_before(spec: ObjectSpec | None) -> bool:
    """Whether whom ego hits has come to a stand before it, and not by a slide."""
    does = [q.action for q in spec.phases] if spec is not None else []
    return "stop" in does and "lose_control" not in does


def _ends_at(c: Course, hit: Phase) -> float:
    """The speed (m/s) to which whom one hits has slowed down by then, at the most."""
    spec, speed = c.other(hit.target), c.target_speed(hit)
    if spec is not None and {"lose_control", "stop"} <= _does(spec):
        return 0.0
    brakes = [q for q in spec.phases if q.action == "brake"] if spec is not None else []
    if not brakes:
        return speed
    return middle(brakes[-1].speed) if brakes[-1].speed is not None else speed / 2


def too_late(c: Course, p: Phase) -> str:
    """Until when one drives on that then brakes and hits somebody nevertheless; "": it brakes as soon as it can."""
    goal, hit = hits_at(c, p), hit_after(c, p)
    soon = c.actor.is_ego and not getattr(c.actor.spec, "hard", False)
    lies = hit is not None and (whom := c.other(hit.target)) is not None and is_static(whom)
    if goal is None or hit is None or soon and not lies and not ways_cross(c, hit):
        return ""
    return f"until braking_to_hit(self, {c.actor.ref(hit.target)}, {scope.number(round(goal, 1))}) > {TOO_LATE}"


def brakes_into(c: Course, p: Phase) -> list[Step] | None:
    """Braking by which one has slowed down to what is said, or to `LEFT`, as it hits whom it hits next; None: it does
    not brake so."""
    goal, until, hit = hits_at(c, p), too_late(c, p), hit_after(c, p)
    if goal is None or hit is None:
        return None
    c.aside = c.aside or by_corner(c, hit)
    other, waits = c.actor.ref(hit.target), [([c.drive()], until)] if until and p.trigger else []
    slides, speed = hit is not p and hit_next(c, p) is None, scope.number(round(goal, 1))
    until_then = f"self.speed < {scope.number(round(c.value - BRAKED, 1))}" if slides else f"touch(self, {other})"
    c.set(goal)
    c.value = goal
    if waits and not ways_cross(c, hit):  # as soon as its trigger says
        rate = HARD if getattr(c.actor.spec, "hard", False) else None
        return [([c.drive(speed, rate)], f"until touch(self, {other})")]
    return [*waits, ([c.drive(speed, f"lambda: braking_to_hit(self, {other}, {speed})")], f"until {until_then}")]


def ways_cross(c: Course, hit: Phase) -> bool:
    """Whether one comes to whom it hits by a way that crosses that one's."""
    spec = c.other(hit.target)
    by_road = spec is not None and (crosses(spec) or spec.placement.position in APPROACH_ANGLE)
    return by_road or bool(c.actor.approach) and hit.target == "ego"


def _stands(c: Course) -> Step:
    return [c.drive("0", STOPS_AT)], ""


def sets_out_to_meet(c: Course) -> str:
    """Until when one waits who stands before the junction and sets out into ego's way; "": it does not."""
    if not c.actor.sets_out:
        return ""
    metres = f"{scope.constant(c.actor.structure, c.actor.cid)}_SETS_OUT"
    return f"until (distance from ego to place.lane.centerline[-1]) < {metres} or {LATE}"


def hit_after(c: Course, p: Phase) -> Phase | None:
    """The collision that a phase is, or that comes after it and what else one tries."""
    phases = c.actor.spec.phases
    then = next((q for q in phases[phases.index(p) :] if q.action not in TRIES), None) if p in phases else None
    return then if then is not None and then.action == "collide" else None


def hit_next(c: Course, p: Phase) -> Phase | None:
    """The collision that comes right after a phase, if one does."""
    phases = c.actor.spec.phases
    later = phases[phases.index(p) + 1 :] if p in phases else ()
    return later[0] if later and later[0].action == "collide" else None


def backs_into(c: Course, other: str, pace: float) -> list[Step]:
    """Backwards until both touch: who stands beside the road waited until it meets the other so."""
    spec = c.actor.spec
    straight = isinstance(spec, ObjectSpec) and spec.placement.position in MOVES_OFF_ROAD and other == "ego"
    back = f"do Backwards({scope.number(pace)})" if straight else f"do BackInto({other}, {scope.number(pace)})"
    return [([back], f"until touch(self, {other})")]


def _leaves_the_lane(structure: Structure) -> int:
    """To which side ego changes lanes of its own accord (1: left, -1: right, 0: it does not)."""
    over = [p for p in getattr(structure.ego.spec, "phases", ()) if p.action in COMES_OVER]
    return (-1 if over[0].side == "right" else 1) if over else 0


def struck_beside(c: Course, p: Phase) -> list[Step]:
    """How one leaves the road towards what it hits there, if it does: straight for it from shortly before."""
    hit = hit_beside(c, p)
    return straight_for(c, p, hit) if hit else []


def hit_beside(c: Course, p: Phase) -> str:
    """What stands beside the road that somebody hits who leaves its lane in a phase; "": nothing."""
    phases = c.actor.spec.phases
    later = phases[phases.index(p) + 1 :] if p in phases and p.action in SIDEWAYS else ()
    hit = next((q.target for q in later if q.action == "collide"), None)
    spec = c.other(hit)
    beside = spec is not None and spec.placement.position in MOVES_OFF_ROAD and is_static(spec)
    return hit if hit and beside else ""


def straight_for(c: Course, p: Phase, hit: str) -> list[Step]:
    """Along the lane, and from shortly before straight for what is beside it; one that drifts is slowly over the edge
    of its lane first."""
    other, goal = c.actor.ref(hit), c.set(c.wanted(p, c.value))
    ram = [f"do Ram({other}, {c.speed})"], f"until touch(self, {other})"
    if p.action != "drift":
        return [([c.drive(goal)], f"until (distance from self to {other}) < leaves_for(self, line, {other})"), ram]
    spec = c.other(hit)
    left = spec is not None and spec.placement.side == "left"
    out = c.drive(goal, offset=scope.number(OVER_EDGE if left else -OVER_EDGE), shift=DRIFTS)
    seconds = round(sideways(OVER_EDGE, DRIFTS) + 0.3, 1)
    drifts = f"{scope.number(round(seconds - 1, 1))} * self.speed"
    near = f"until (distance from self to {other}) < leaves_for(self, line, {other}) + {drifts}"
    return [([c.drive(goal)], near), ([out], f"for {scope.number(seconds)} seconds"), ram]


def _over_the_middle(c: Course) -> bool:
    """Whether it drives in the lane of those that come towards it, from where it starts or later."""
    spec = c.actor.spec
    if isinstance(spec, ObjectSpec):
        return spec.placement.position == "oncoming_lane"
    return any(q.action == "oncoming" for q in spec.phases)


def _beside_the_lane(c: Course, p: Phase) -> str:
    """Where whom ego hits without having left its lane is, if that is beside ego's lane; else ""."""
    spec = c.other(p.target)
    alone = not {q.action for q in c.actor.spec.phases} & GOES_THERE
    if not alone or c.backwards or spec is None or {"cross_road", "enter_road"} & _does(spec):
        return ""
    at = spec.placement.position or ""
    along = at in MOVES_OFF_ROAD or at == "partly_in_lane" or at == "oncoming_lane" and "oncoming" not in _does(spec)
    return at if along else ""


def _does(spec: ObjectSpec) -> set[str]:
    return {q.action for q in spec.phases}

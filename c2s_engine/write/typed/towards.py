"""How a driver lets another one pass."""

from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.structure.vocabulary import WITH_SIREN
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.collisions import Step
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.order import goes_after, turns_left
from c2s_engine.write.typed.tables import (
    APPROACH_ANGLE,
    LANE_WIDTH,
    RUNS,
    TURN,
    WORKS,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.threats import every, every_passed, standing
from c2s_engine.write.typed.usual import SETS_OUT, walks_first

SETS_OFF = {*TURN, *RUNS, "start"}
"""What one does that then is in the junction, or on its way there, and no longer before it."""
HOLDS = {"stop", "wait"}
STAYS = {*HOLDS, "yield", "stationary"}
"""What one who has let another pass does that stays where it stands."""
IN_MIDDLE, SHORT = 4, 1
"""m before another's way at which one waits in the middle of a junction, and stops for one that it then sees."""
GENTLY = 1.5
"""m/s2 at which one comes up to a roundabout in which others are."""
ROOM = 4
"""m before somebody on foot where one stands to let them pass."""


def ending(phase: Phase, natural: str) -> str:
    """The condition that ends a phase: its stated duration, or what is natural to it."""
    return f"for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else natural


def yields(c: Course, p: Phase) -> list[Step]:
    other, lane = c.actor.ref(p.target), c.actor.to_junction
    phases = c.actor.spec.phases
    then = next(iter(phases[phases.index(p) + 1 :]), None) if p in phases else None
    if lane is not None and (beside := c.other(p.target)) and c.actor.is_ego \
            and offset(beside, c.actor.spec, c.actor.plan.place):  # type: ignore[arg-type]  # fmt: skip
        goal = c.set(_moving_on(c, p))
        hold = c.drive(f"lambda: short_of_ways(self, line, [{other}], {goal}, room={SHORT})", 5)
        return [([hold], f"until clear_of_ways(self, line, [{other}])"), *_onward(c, then)]
    go = ([c.drive(c.set(_moving_on(c, p)), 2)], "for 4 seconds")
    stays = then is not None and (then.action in STAYS or then.trigger is not None and then.trigger.kind == "passed")
    if in_next_lane(c, p):
        return [*_let_by(c, other), *([] if then and then.action == "lane_change" else [go])]
    if lane is None or _on_foot_behind(c, p) or c.behind and _comes_towards(c, p):
        return [*_until_forced(c, p, other), go]
    end = f"{lane}.centerline[-1]"
    if _in_front(c, p):  # it is ahead: behind it up to the junction, until it has gone on over it
        behind = f"do Drive(line, lambda: following_speed(self, {other}, {c.speed}), rate=4)"
        clear = f"(distance from {other} to {end}) > 14 and (distance from self to {end}) < 14"
        return [([behind], f"until {clear}"), (go[0], "")]
    near = f"until to_line(self, {lane}) < 0.5 + self.speed ** 2 / 6"
    stop = c.drive(f"lambda: up_to(to_line(self, {lane}), {c.speed})", 5)
    first = its_turn(c.actor, p.target)
    by = c.other(p.target)
    across = by is not None and by.placement.position == "opposite_approach" and turns_left(c.actor.structure, "E")
    rings = c.actor.plan.place.kind == "roundabout" and by is not None
    all_of = every(c.actor.structure, p.target) if p.target else other
    if rings:  # whose stop line may be far from it
        stop = c.drive(f"lambda: short_of_ways(self, line, [{all_of}], {c.speed}, {GENTLY})", 5)
    gone = f"clear_of_ways(self, line, [{all_of}])" if across and c.actor.is_ego or rings else f"passed({other}, self)"
    gone += f" and {first}" if first else f" or left_ring({other})" if rings else ""
    before = phases[phases.index(p) - 1].action if p in phases[1:] else ""
    up = [] if before in STAYS or rings or _waits_there(c, p) else [([c.drive()], near)]
    return [*up, ([stop], f"until {gone}"), *([] if stays else [go])]


def _onward(c: Course, then: Phase | None) -> list[Step]:
    """How one goes on that has let another pass in the junction: by what comes next, where something does."""
    return [] if then is not None else [([c.drive(rate=2)], "")]


def held_for(c: Course, p: Phase) -> list[str]:
    """Those short of whose ways somebody stops in the junction, in the middle of its turn: the one that it stops for,
    or by whose passing that ends; none where it stops elsewhere."""
    phases, i = c.actor.spec.phases, c.actor.spec.phases.index(p) if p in c.actor.spec.phases else 0
    inside = p.trigger is not None and p.trigger.place == "in_intersection"
    begun = inside or any(q.action in SETS_OFF for q in phases[:i])
    if p.action not in HOLDS or not begun or not c.actor.plan.junction or c.actor.to_junction is None:
        return []
    if c.actor.approach and stops_in_way(p):
        return ["ego"]
    ends = p.until or next((q.until or q.trigger for q in phases[i + 1 :]), None)
    whom = p.target or (ends.subject if ends is not None else None)
    spec = c.other(whom)
    drives = spec is not None and is_vehicle(spec.type) and not is_static(spec)
    meets = drives and not _in_front(c, p.model_copy(update={"target": whom}))
    return [c.actor.ref(whom)] if meets else []


def stops_in_way(p: Phase) -> bool:
    """Whether one that comes by another road stops in the junction, nobody says for whom: in ego's way."""
    inside = p.trigger is not None and p.trigger.place == "in_intersection" and p.trigger.subject is None
    return inside and p.action in HOLDS and p.target is None


def _waits_there(c: Course, p: Phase) -> bool:
    """Whether ego stands at the junction from the first for one who comes by another road."""
    spec = c.actor.structure[p.target].spec if p.target and p.target in c.actor.structure else None
    crossing = isinstance(spec, ObjectSpec) and spec.placement.position in APPROACH_ANGLE
    return c.actor.is_ego and c.actor.value <= 0 and crossing


def _in_front(c: Course, p: Phase) -> bool:
    """Whether the other starts ahead of it in its lane or on its approach."""
    queued = getattr(getattr(c.actor.spec, "placement", None), "of", None) == p.target
    spec = c.other(p.target)
    behind = spec is not None and "behind" in (spec.placement.position, spec.placement.along)
    return not behind and c.same_lane(p) and (c.lane is not None or queued)


def its_turn(actor: Actor, besides: str | None = None) -> str:
    """The condition under which those who go before a driver at the junction are in it, or where one of the two turns
    left have gone by; `besides` one of them; "": there are none."""
    conditions = []
    for cid in goes_after(actor.structure, actor.cid):
        one = "ego" if cid == "E" else actor.ref(cid)
        within = "" if any(turns_left(actor.structure, c) for c in (actor.cid, cid)) else f"{one}._intersection or "
        conditions += [f"({within}passed({one}, self))" if within else f"passed({one}, self)"] if cid != besides else []
    return " and ".join(conditions)


def in_next_lane(c: Course, p: Phase) -> bool:
    """Whether the other drives in the lane beside its own, behind it or level with it."""
    spec = c.other(p.target)
    if spec is None or is_static(spec) or is_walker(spec) or c.actor.value <= 0:
        return False
    along, lane, own = spec.placement.along or spec.placement.position, c.target_lane(p), c.actor.lane
    return None not in (lane, own) and lane != own and along in ("behind", "abreast", "beside")


def _let_by(c: Course, other: str) -> list[Step]:
    """Slower than the other, and behind what stands in its way, until that one is ahead."""
    stands = standing(c.actor.structure, c.actor.plan.lane_of)
    goal = f"max(0, min({scope.number(0.8 * c.value)}, {other}.speed - 3))"
    slower = f"lambda: following_speed(self, {c.actor.ref(stands)}, {goal})" if stands else f"lambda: {goal}"
    return [([c.drive(slower, 2)], f"until ahead_by({other}, self) > 2")]


def _comes_towards(c: Course, p: Phase) -> bool:
    """Whether the other is in the lane by which it overtakes later."""
    spec = c.other(p.target)
    return spec is not None and spec.placement.position == "oncoming_lane"


def _on_foot_behind(c: Course, p: Phase) -> bool:
    """Whether the other is on foot where ego leaves the junction: it is let pass there, not before the junction."""
    spec = c.other(p.target)
    behind = spec is not None and spec.placement.position == "intersection_exit" and is_walker(spec)
    return behind and c.actor.is_ego


def _until_forced(c: Course, p: Phase, other: str) -> list[Step]:
    """Where no junction says where to wait: what comes before letting the other pass, and the wait."""
    a, spec = c.actor, c.other(p.target)
    if round_it := opposite_standing(c) if p.target in (None, "ego") else None:
        return _lets_ego_by(c, p, other, round_it)
    if not a.is_ego or spec is None or a.value <= 0:
        return [([c.drive("0", 4)], f"until passed({other}, self) or passed({other}, self, 0)")]
    if "behind" in (spec.placement.position, spec.placement.along):
        return _makes_way(c, spec, other)
    if spec.placement.position == "oncoming_lane":
        return _waits_for_oncoming(c, other)
    if p.target and (is_walker(spec) or spec.type == "bicycle"):
        waits = f"until {every_passed(a.structure, p.target)}"
        they = every(a.structure, p.target)
        before = f"lambda: short_of(self, line, [{they}], {c.speed}, 2.5, {ROOM})"
        sets_out = "" if is_static(spec) or walks_first(spec) else f" or {other}.speed > 0.3"
        return [([c.drive()], f"until braking_needed(self, {other}) > 2{sets_out}"), ([c.drive(before, 5)], waits)]
    if spec.placement.position == "on_ramp":  # it comes in ahead: no more room than that takes
        near = f"(distance from self to {other}) < 40 and lead_on(self, {other}) > -40"
        least, most = scope.number(0.7 * a.value), scope.number(0.9 * a.value)
        pace = f"lambda: max({least}, following_speed(self, {other}, {most}, 0.5))"
    else:
        beside = c.target_lane(p) in (1, -1) and spec.placement.along == "ahead"
        near = f"{other}.speed > 0.5 and (distance from self to {other}) < 5 + 5 * self.speed"
        near, pace = f"off_lane({other})" if beside else near, scope.number(0.5 * a.value)
    return [([c.drive()], f"until {near}"), ([c.drive(pace, 2.5)], f"until {other}._lane is self._lane")]


def _makes_way(c: Course, spec: ObjectSpec, other: str) -> list[Step]:
    """Aside for one that comes from behind, until it is ahead: at a stand for a siren."""
    past, first = f"until lead_on({other}, self) > self.length + {other}.length", c.actor.spec.phases[0]
    pace = "0" if spec.type in WITH_SIREN else scope.number(0.5 * c.actor.value)
    if first.action == "lane_change":  # it is aside
        verge = LANE_WIDTH * (1 if first.side == "left" else -1) if len(c.actor.plan.offsets) == 1 else 0
        return [([c.drive(pace, 2.5, scope.number(verge) if verge else "")], past)]
    near = f"until (distance from self to {other}) < 15 + 3 * {other}.speed"
    return [([c.drive()], near), ([c.drive(pace, 2.5, scope.number(-0.8))], past)]


def _waits_for_oncoming(c: Course, other: str) -> list[Step]:
    """Behind what stands in its lane, behind whom it overtakes then, or before where they would meet."""
    stands, gone = standing(c.actor.structure, c.actor.plan.lane_of), f"until passed({other}, self, 0)"
    if c.behind and not stands:
        return [([c.drive(f"lambda: following_speed(self, {c.behind}, {c.speed})", 4)], gone)]
    near = f"(distance from self to {other}) < 5 * self.speed"
    if stands:
        near = f"(distance from self to {c.actor.ref(stands)}) < 14 + self.speed ** 2 / 6"
    return [([c.drive()], f"until {near}"), ([c.drive("0", 3)], gone)]


def opposite_standing(c: Course) -> str | None:
    """What stands in the lane of one that comes towards ego, if anything does."""
    if not c.oncoming:
        return None
    objects = [(o.id, o.spec) for o in c.actor.structure.objects if isinstance(o.spec, ObjectSpec)]
    return next((i for i, o in objects if o.placement.position == "oncoming_lane" and is_static(o)), None)


def before_standing(c: Course, cid: str) -> str:
    """So near to what stands in its lane that one comes to a stand before it, with room to drive round it."""
    room = 26 if getattr(c.actor.structure[cid].spec, "type", "") in WORKS else 14  # of works the sign comes first
    return f"until (distance from self to {c.actor.ref(cid)}) < {room} + self.speed ** 2 / 6"


def _lets_ego_by(c: Course, p: Phase, ego: str, cid: str) -> list[Step]:
    """Up to what stands in its lane, a stand there until ego has gone by, and then round it by ego's lane."""
    obstacle, waits = c.actor.ref(cid), [([c.drive()], before_standing(c, cid))]
    waits += [([c.drive("0", 3)], f"until passed({ego}, self, 0)")]
    if any(q.action in ("overtake", "oncoming", "swerve") for q in c.actor.spec.phases):
        return waits
    c.set(_moving_on(c, p))
    return [*waits, ([c.drive(offset=scope.number(LANE_WIDTH), shift=2)], f"until lead_on(self, {obstacle}) > 16")]


def _moving_on(c: Course, p: Phase) -> float:
    """The speed at which somebody drives on that has let another pass, m/s."""
    return c.wanted(p, c.actor.value or SETS_OUT)

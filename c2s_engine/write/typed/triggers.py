"""When a phase begins: its stated trigger, or what its action waits for where none is stated."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import ahead, lateral, scope, traffic
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.causes import because, drives_ahead
from c2s_engine.write.typed.collisions import hit_beside, hit_next, too_late
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.evasion import last_moment
from c2s_engine.write.typed.facing import AHEAD
from c2s_engine.write.typed.overtakings import pulls_out
from c2s_engine.write.typed.passing import CAUGHT_UP, FOLLOWS
from c2s_engine.write.typed.people import REACTS, comes_out
from c2s_engine.write.typed.reach import EVADED_AT
from c2s_engine.write.typed.stations import parked_in_way
from c2s_engine.write.typed.tables import LENGTH, MOVES_OFF_ROAD, WORKS, is_static
from c2s_engine.write.typed.threats import (
    ASIDE,
    IN_WAY,
    STAYS,
    beside_way,
    is_stopped,
    on_foot,
    once_seen,
    standing,
    threatening,
)
from c2s_engine.write.typed.towards import before_standing, held_for, in_next_lane, opposite_standing
from c2s_engine.write.typed.usual import crosses, slows_before, speed_of
from c2s_engine.write.typed.watching import METRES, watched, watches

NO_FASTER = 0.5
"""m/s by which one is no faster whom nothing but its own decision brings out from behind another."""
CAN_STOP = 10
"""Twice the m/s2 at which one stops for a light that changes."""
BEFORE_IT = 2.0
"""m before a crosswalk by which one has slowed down for it."""
AT_LAST = 4.0
"""m/s2 that it takes when ego notices one beside it whose way it turns across."""
NEAR_BY = 8.0
"""m before one beside its way by which ego has slowed down for it."""
TO_END = 6.0
"""m before the end of an acceleration lane at which the middle of one is who stops there."""
FORCED = {"brake", "stop", *ASIDE}
DELAYED = {
    "brake", "stop", "swerve", "lane_change", "cut_out", "drift", "lose_control", "leave_road",
    "accelerate", "oncoming", "u_turn",
}  # fmt: skip


def stated(course: Course, phase: Phase) -> str:
    """The condition that ends what comes before a phase with a trigger: `until ...` or `for ...`."""
    t = phase.trigger
    assert t is not None
    value = middle(t.value) if t.value is not None else None
    if t.place in ("in_intersection", "stop_line") and held_for(course, phase):  # it comes up to there
        return ""
    if not watches(t) and t.kind == "place":
        return _before_junction(course, value or 0, phase)
    if not watches(t) and t.kind == "distance":
        near = phase.model_copy(update={"trigger": None, "target": phase.target or t.of})
        if value is None and course.actor.is_ego and t.of and _awaits(course.actor.structure, t.of, phase.action):
            return f"until ttc(self, {course.actor.ref(t.of)}) < {scope.number(EVADED_AT)}"  # nothing forces it yet
        if value is None and (found := implicit(course, near, first=False)):  # as soon as it has to
            return found
        if phase.action == "cut_in" and course.value > course.target_speed(phase) + 0.3:  # once it is that far ahead
            return f"until ahead_by(self, {course.actor.ref(t.of)}) > {scope.number(value or METRES)}"
    if t.place == "crosswalk" and t.value is None and phase.action in ("brake", "stop"):  # it is that slow by then
        goal = 0.0 if phase.action == "stop" else course.wanted(phase, course.value / 2)
        metres = slows_before(course.value, goal, middle(phase.rate) if phase.rate else 3.0).value
        t = t.model_copy(update={"value": round(middle(metres or 0.0) + BEFORE_IT, 1)})
    if t.kind == "time" and t.delay is not None:
        t = t.model_copy(update={"value": (value or 0) + middle(t.delay)})
    if course.actor.is_ego and phase.action in SLOWS and t.action == "stop" and t.of and drives_ahead(course, t.of):
        t = t.model_copy(update={"action": "brake"})  # who drives behind slows as it does, not once it stands
    condition = watched(course.actor.structure, course.actor.plan, t, course.actor.cid)
    if t.kind == "light" and phase.action == "stop" and (lane := course.actor.to_junction):  # if it still can
        condition += f" and to_line(self, {lane}) > self.speed ** 2 / {CAN_STOP}"
    return f"until {condition}"


COMES_OVER = {
    "oncoming", "drift", "swerve", "lose_control", "lane_change", "overtake", "cut_in", "turn_left",
    "u_turn", "collide",
}  # fmt: skip
"""What leads one that comes towards ego into its lane."""


def implicit(course: Course, phase: Phase, first: bool = True) -> str:
    """The trigger of a phase that names none: what ego is forced to waits for the need, a cut-in for its gap."""
    a = course.actor
    before = a.spec.phases[: a.spec.phases.index(phase)] if phase in a.spec.phases else ()
    other = course.other(phase.target)
    if a.is_ego and phase.action == "stop" and phase.trigger is None and other is not None and crosses(other):
        seen = Trigger(kind="action", of=phase.target, action="cross_road")
        return f"until {watched(a.structure, a.plan, seen, a.cid)}"
    if not a.is_ego and (cause := because(course, phase)):
        return cause
    said = phase.trigger is not None or phase.action == "stop" and phase.clearance is not None
    if said or before and before[-1].action == "collide" or held_for(course, phase):
        return ""
    if until := too_late(course, phase):
        return until
    if first and (until := comes_out(a.structure, a.cid, a.plan, phase, course.wanted(phase, a.value or 2))):
        return until
    if course.on_ramp and (phase.action in ("lane_change", "cut_in") or a.is_ego and phase.action in ("brake", "stop")):
        return "until self._lane is place.acceleration_lane"
    if phase.action in lateral.LATERAL and phase.gap is not None and phase.target and not _sideways_into(course, phase):
        return _at_gap(course, phase, first)
    if first and a.is_ego and phase.action == "enter_road":  # it is seen at the kerb
        return _undisturbed(a)
    if phase.action == "swerve" and (seconds := last_moment(course, phase)[1]):
        return f"until ttc(self, {a.ref(phase.target)}) < {scope.number(seconds)}"
    forced = a.is_ego and phase.action in FORCED and not (_stood(a, phase) or _answered(a, phase))
    if forced and _confronted(course, phase):
        cid = phase.target or getattr(a.spec, "react_to", None) or standing(a.structure, a.plan.lane_of)
        if beside_way(a.structure, cid):
            return f"until ttc(self, {a.ref(cid)}) < {scope.number(EVADED_AT if first else EVADED_AT / 2)}"
        hard = getattr(a.spec, "hard", False) or (phase.rate is not None and middle(phase.rate) >= 4)
        aside = phase.action in ASIDE
        if aside and cid and (spec := course.other(cid)) and crosses(spec):
            return f"until min(lately({a.ref(cid)}, {REACTS:g})) > 0.3"  # it has set out
        still = cid is not None and (o := course.other(cid)) is not None and is_static(o)
        limit = (2 if still else 1.2) if aside else 4 if hard else 2
        them = once_seen(a.structure, [cid])[0] if cid else a.ref(cid)
        need = f"braking_needed(self, {them.removeprefix('*')})"
        if cid and (beside := course.other(cid)) and offset(beside, a.spec, a.plan.place):  # type: ignore[arg-type]
            need, limit = f"needed_before_turn(self, line, {a.ref(cid)})", max(limit, AT_LAST)
        met = any(p.action == "collide" for p in a.spec.phases)
        also = f" or near(self, {a.ref(cid)})" if met else ""
        if phase.action == "stop" and is_stopped(a.spec) and not on_foot(a.structure) and a.value > 0:
            also += " or self.speed < 0.5"  # it was forced to
        elif phase.action in SLOWS and cid and _beside(course, cid):
            goal = course.wanted(phase, course.value / 2) if phase.action == "brake" else 0.0
            rest = max(course.value**2 - goal**2, 0.0) / (2 * (middle(phase.rate) if phase.rate else 3.0))
            also += f" or (distance from self to {a.ref(cid)}) < {scope.number(round(rest + NEAR_BY, 1))}"
        return f"until {need} > {limit}{also}"
    if a.is_ego and phase.action == "stop" and (cid := _stopped_for(course, phase)):
        return f"until (distance from self to {a.ref(cid)}) < 14 + self.speed ** 2 / 6"
    if phase.action == "stop" and not a.is_ego and first and (cid := opposite_standing(course)):
        return before_standing(course, cid)
    if phase.action == "cut_in" and (_sideways_into(course, phase) or a.is_ego and hit_next(course, phase)):
        return ""
    if phase.action == "cut_in":
        return _at_gap(course, phase, first)
    if phase.action in ("overtake", "swerve") and parked_in_way(a.structure, phase.target):
        return _before(course, phase.target)
    if phase.action == "overtake" and (
        course.oncoming_both(phase) or course.lane is not None and course.same_lane(phase)
    ):
        if course.target_speed(phase) > 0:  # it may follow
            calm, follows = {p.action for p in before} <= traffic.CALM, any(p.action == "follow" for p in before[-1:])
            soon = pulls_out(course, phase) if phase.abandoned else ""
            if soon.startswith("until ttc"):
                return soon
            if calm and (follows or course.value < course.target_speed(phase) + NO_FASTER):
                if follows and course.value > course.target_speed(phase) + CAUGHT_UP:
                    return f"until self.speed < {a.ref(phase.target)}.speed + {scope.number(CAUGHT_UP)}"
                return f"for {FOLLOWS} seconds" if follows else _undisturbed(a)
            return pulls_out(course, phase)
        return "" if _stood(a, phase) else _before(course, phase.target)
    stands = standing(a.structure, a.plan.lane_of) if a.is_ego and phase.action == "oncoming" else None
    if stands:
        return _before(course, stands)
    if obstacle := _obstacle(course, phase) if phase.action in ("swerve", "cut_out", "lane_change") else "":
        return f"until (distance from self to {obstacle}) < 12 + 2 * self.speed"
    if phase.action == "u_turn" and first and not a.is_ego and (course.oncoming or a.value <= 0):  # in front of ego
        return f"until (distance from self to ego) < {scope.number(12 + 2.2 * (a.value + a.plan.ego_speed))}"
    if first and phase.action in ("brake", "stop") and _comes_over(a):
        as_fast = a.value < a.plan.ego_speed + NO_FASTER  # ego is no hindrance, and one makes room for it
        return "until braking_needed(self, ego) > 1" + (" or off_lane(ego)" if as_fast else "")
    if phase.action == "yield" and first and in_next_lane(course, phase):
        return _undisturbed(a)
    if phase.action == "start" and first and a.lane is not None and a.value <= 0:  # it stands
        return _undisturbed(a)
    if not first or phase.action not in DELAYED or a.value <= 0 or hit_beside(course, phase):
        return ""
    if course.oncoming:
        early = AHEAD["drift" if phase.action == "drift" else "other"]
        return f"until (distance from self to ego) < {scope.number(early * (a.value + a.plan.ego_speed))}"
    return _undisturbed(a)


def _undisturbed(actor: Actor) -> str:
    """What goes before the first thing that somebody does of its own accord."""
    return f"for {scope.number(ahead.begins(actor.structure, actor.cid))} seconds"


def _stood(actor: Actor, phase: Phase) -> bool:
    """Whether it gets past another from where it came to a stand: nothing forces it any more."""
    phases = actor.spec.phases
    before = phases[: phases.index(phase)] if phase in phases else ()
    stands = ("stop", "wait", "yield") if phase.action == "overtake" else ("stop", "wait")
    return phase.action in ("lane_change", "swerve", "overtake") and any(p.action in stands for p in before)


def _answered(actor: Actor, phase: Phase) -> bool:
    """Whether an earlier phase has left the lane for the same one: what comes then waits for it no more."""
    phases, cause = actor.spec.phases, getattr(actor.spec, "react_to", None)
    before = phases[: phases.index(phase)] if phase in phases else ()
    return any(p.action in ASIDE and (p.target or cause) == (phase.target or cause) for p in before)


def _beside(course: Course, cid: str) -> bool:
    """Whether one is, and stays, beside ego's way: nothing but being near it forces ego to slow down for it."""
    spec = course.other(cid)
    beside = spec is not None and spec.placement.position in {*MOVES_OFF_ROAD, "intersection_exit"}
    return beside and {p.action for p in spec.phases} <= STAYS  # type: ignore[union-attr]


def _before(course: Course, cid: str | None) -> str:
    """So near to one that stands that there is just room to get out of its lane; of works the sign comes first."""
    spec = course.actor.structure[cid].spec if cid and cid in course.actor.structure else None
    kind = spec.type if isinstance(spec, ObjectSpec) else "car"
    room = 18 if kind in WORKS else round(9.5 + LENGTH[kind] / 2)
    return f"until (distance from self to {course.actor.ref(cid)}) < {room} + 1.9 * self.speed"


def _before_junction(course: Course, value: float, phase: Phase) -> str:
    if phase.trigger is not None and phase.trigger.place == "merge_end":
        there, metres = "place.acceleration_lane", scope.number(max(value, ahead.MERGES))
        if phase.action in ("stop", "brake"):  # as far before it as that takes
            rate = middle(phase.rate) if phase.rate else 3.5 if phase.action == "stop" else 3.0
            slow = course.wanted(phase, course.value / 2) if phase.action == "brake" else 0.0
            metres = f"{scope.number(max(value + TO_END - slow**2 / (2 * rate), 0))} + self.speed ** 2 / {2 * rate:g}"
        return f"until self._lane is {there} and (distance from self to {there}.centerline[-1]) < {metres}"
    lane = course.actor.to_junction
    if lane is None:
        return "for 4 seconds"
    room = value + 4
    if phase.action in ("stop", "yield", "wait", "brake") and value < 12 and not phase.speed:
        hard = phase.action == "stop" and getattr(course.actor.spec, "hard", False)
        rate = middle(phase.rate) if phase.rate else 6 if hard else 3
        return f"until to_line(self, {lane}) < {scope.number(value + 0.5)} + self.speed ** 2 / {scope.number(2 * rate)}"
    return f"until (distance from self to {lane}.centerline[-1]) < {scope.number(room)}"


def _comes_over(actor: Actor) -> bool:
    """Whether ego comes from the next lane, not at its bidding, in front of one that comes up behind it."""
    spec, ego = actor.spec, actor.structure.ego.spec
    if not isinstance(spec, ObjectSpec) or spec.placement.along != "behind" or actor.plan.lane_of.get(actor.cid) == 0:
        return False
    own = (p for p in getattr(ego, "phases", ()) if p.trigger is None or p.trigger.of != actor.cid)
    return spec.placement.of == "ego" and any(p.action in ("u_turn", "lane_change", "cut_in") for p in own)


def _obstacle(course: Course, phase: Phase) -> str:
    """Whom another swerves round, or what stands in its lane ahead of it: its evasion waits for that."""
    a = course.actor
    if not a.is_ego and phase.action == "swerve" and phase.target and course.comes_up_to(phase.target):
        return a.ref(phase.target)
    if a.is_ego or course.lane is None:
        return ""
    for c in a.structure.objects:
        spec = c.spec
        if c.id == a.cid or not isinstance(spec, ObjectSpec) or not is_static(spec):
            continue
        at = spec.placement
        ahead = at.position == "ahead" or at.position in ("left_lane", "right_lane") and at.along == "ahead"
        ahead = ahead and at.of in (a.cid, "ego")
        if ahead and a.plan.lane_of.get(c.id) == course.lane:
            return a.ref(c.id)
    return ""


def _stays_opposite(spec: ObjectSpec) -> bool:
    """Whether one that comes towards ego, or stands on the other side, keeps to its own lane."""
    return spec.placement.position == "oncoming_lane" and not COMES_OVER & {p.action for p in spec.phases}


def _stopped_for(course: Course, phase: Phase) -> str | None:
    """The one on the other side of the road that ego stops for, as for a school bus."""
    a = course.actor
    for c in a.structure.objects:
        if phase.target in (None, c.id) and isinstance(c.spec, ObjectSpec) and _stays_opposite(c.spec):
            return c.id if phase.target or is_static(c.spec) or "stop" in {p.action for p in c.spec.phases} else None
    return None


def _in_front(actor: Actor, cid: str) -> bool:
    """Whether an object is in ego's lane ahead of it, comes onto it, or comes from elsewhere than the next lanes."""
    spec, lane = actor.structure[cid].spec, actor.plan.lane_of.get(cid)
    if isinstance(spec, ObjectSpec) and _stays_opposite(spec):
        return False
    if not isinstance(spec, ObjectSpec) or "behind" in (spec.placement.position, spec.placement.along):
        return False
    if {p.action for p in spec.phases} <= STAYS and spec.placement.position in MOVES_OFF_ROAD:
        return False  # it stays beside the road
    comes = {"cut_in", "lane_change", "drift", "swerve", "lose_control"} & {p.action for p in spec.phases}
    return lane in (0, None) or bool(comes)


def _confronted(course: Course, phase: Phase) -> bool:
    """Whether the one that ego reacts to is, or comes, in its way."""
    a = course.actor
    cid = phase.target or getattr(a.spec, "react_to", None)
    if cid is None:
        forcing = (c for c in threatening(a.structure) if not _awaits(a.structure, c, phase.action))
        return any(_in_front(a, c) and _presses(course, c) for c in forcing)
    if cid == "ego" or cid not in a.structure or _awaits(a.structure, cid, phase.action):
        return False
    spec = a.structure[cid].spec
    if not isinstance(spec, ObjectSpec) or phase.action == "stop" and _stays_opposite(spec):
        return False
    if offset(spec, a.spec, a.plan.place):  # type: ignore[arg-type]
        return True  # ego turns across its way
    if spec.placement.position == "behind" or spec.placement.along == "behind":
        comes = any(p.action in ("cut_in", "overtake") for p in spec.phases) and phase.action in ("brake", "stop")
        return comes and getattr(a.spec, "reaction", "") != "yield"  # else it has been let by
    abreast = "beside" in (spec.placement.position, spec.placement.along) or spec.placement.along == "abreast"
    if abreast and {p.action for p in spec.phases} <= STAYS:
        return False  # there is no room beside it, and it keeps ego from nothing else
    return (spec.placement.position in IN_WAY or not is_static(spec)) and _presses(course, cid)


def _awaits(structure: Structure, cid: str, action: str) -> bool:
    """Whether an object begins something when ego does what that is then no answer to."""
    phases = getattr(structure[cid].spec, "phases", ()) if cid in structure else ()  # not of ego itself
    triggers = [p.trigger for p in phases if p.trigger is not None]
    return any(t.kind == "action" and t.of == "ego" and t.action == action for t in triggers)


def _presses(course: Course, cid: str) -> bool:
    """Whether an object comes to be in ego's way at all: not one that drives on before it as fast as ego does."""
    a, spec = course.actor, course.actor.structure[cid].spec
    if not isinstance(spec, ObjectSpec) or a.plan.lane_of.get(cid) is None or spec.placement.facing == "against":
        return True
    calm = {p.action for p in spec.phases} <= {"keep_lane", "follow", "accelerate", "move_along", "go_straight"}
    slower = is_static(spec) or middle(speed_of(spec, a.plan.place)) < course.value - 1
    return slower or not calm


def _at_gap(course: Course, phase: Phase, first: bool) -> str:
    """When one begins to come over so that it is as far from the other as is said as it comes over the lane line, both
    driving on as they do: once it has come so far ahead, or fallen back so far, or what stands in its lane is near."""
    other, gains = course.actor.ref(phase.target), course.value - course.target_speed(phase)
    gap = middle(phase.gap) if phase.gap is not None else ahead.LEAST
    if abs(gains) < 0.3 or phase.gap is None and gains < 0:
        return _undisturbed(course.actor) if first else ""
    seconds = scope.number(lateral.to_line(course.actor.spec.type, phase))
    before = traffic.in_front(course.actor.structure, course.actor.cid, phase)
    one, two = ("self", other) if before else (other, "self")
    sign = ">" if (gains > 0) == before else "<"
    obstacle = _obstacle(course, phase)
    near = f" or (distance from self to {obstacle}) < 12 + 2 * self.speed" if obstacle else ""
    return f"until ahead_by({one}, {two}, {seconds}) {sign} {scope.number(gap)}{near}"


def _sideways_into(course: Course, phase: Phase) -> bool:
    """Whether one comes over from abreast into whom it then hits: there is no gap for which it waits."""
    spec = course.actor.spec
    abreast = isinstance(spec, ObjectSpec) and spec.placement.along == "abreast"
    return abreast and any(p.action == "collide" and p.target == phase.target for p in spec.phases)

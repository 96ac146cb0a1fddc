"""When a phase begins that S gives no trigger: as its cause comes, at its gap, or of its own accord after a while."""

from collections.abc import Callable

from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase, Trigger
from c2s_engine.write.typed import ahead, lateral, scope, traffic
from c2s_engine.write.typed.causes import because
from c2s_engine.write.typed.collisions import hit_beside, hit_next, too_late
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.evasion import last_moment
from c2s_engine.write.typed.facing import AHEAD
from c2s_engine.write.typed.forced import as_it_is_forced, before, stood
from c2s_engine.write.typed.overtakings import pulls_out
from c2s_engine.write.typed.passing import CAUGHT_UP, FOLLOWS
from c2s_engine.write.typed.people import comes_out
from c2s_engine.write.typed.stations import parked_in_way
from c2s_engine.write.typed.tables import LENGTH, WORKS, is_static
from c2s_engine.write.typed.threats import standing
from c2s_engine.write.typed.towards import before_standing, held_for, in_next_lane, opposite_standing
from c2s_engine.write.typed.usual import crosses
from c2s_engine.write.typed.watching import watched

NO_FASTER = 0.5
"""m/s by which one is no faster whom nothing but its own decision brings out from behind another."""
DELAYED = {
    "brake", "stop", "swerve", "lane_change", "cut_out", "drift", "lose_control", "leave_road",
    "accelerate", "oncoming", "u_turn",
}  # fmt: skip
"""What one does a while after the start, where nothing else says when."""


def implicit(course: Course, phase: Phase, first: bool = True) -> str:
    """The condition that ends what comes before a phase without a trigger: `until ...`, `for ...`, or "" where it
    begins as that is over."""
    return next((found for rule in _RULES if (found := rule(course, phase, first)) is not None), "")


def _as_its_cause_comes(course: Course, phase: Phase, first: bool) -> str | None:
    a, other = course.actor, course.other(phase.target)
    if not a.is_ego:
        return because(course, phase) or None
    if phase.action != "stop" or phase.trigger is not None or other is None or not crosses(other):
        return None
    seen = Trigger(kind="action", of=phase.target, action="cross_road")
    return f"until {watched(a.structure, a.plan, seen, a.cid)}"


def _at_once(course: Course, phase: Phase, first: bool) -> str | None:
    earlier = before(course.actor, phase)
    said = phase.trigger is not None or phase.action == "stop" and phase.clearance is not None
    return "" if said or earlier and earlier[-1].action == "collide" or held_for(course, phase) else None


def _where_it_begins(course: Course, phase: Phase, first: bool) -> str | None:
    """Out of where it stood, from the ramp, or so late that it touches whom it hits."""
    a = course.actor
    if until := too_late(course, phase):
        return until
    if first and (until := comes_out(a.structure, a.cid, a.plan, phase, course.wanted(phase, a.value or 2))):
        return until
    slows = a.is_ego and phase.action in SLOWS
    if course.on_ramp and (phase.action in ("lane_change", "cut_in") or slows):
        return "until self._lane is place.acceleration_lane"
    return None


def _sideways(course: Course, phase: Phase, first: bool) -> str | None:
    """At the gap that S says, or at the last moment before whom it hits all the same."""
    a = course.actor
    if phase.action in lateral.LATERAL and phase.gap is not None and phase.target and not _sideways_into(course, phase):
        return _at_gap(course, phase, first)
    if first and a.is_ego and phase.action == "enter_road":  # it is seen at the kerb
        return _undisturbed(a)
    if phase.action == "swerve" and (seconds := last_moment(course, phase)[1]):
        return f"until ttc(self, {a.ref(phase.target)}) < {scope.number(seconds)}"
    return None


def _opposite_who_stands(course: Course, phase: Phase, first: bool) -> str | None:
    other_stops = phase.action == "stop" and not course.actor.is_ego and first
    return before_standing(course, cid) if other_stops and (cid := opposite_standing(course)) else None


def _cutting_in(course: Course, phase: Phase, first: bool) -> str | None:
    if phase.action != "cut_in":
        return None
    hits = _sideways_into(course, phase) or course.actor.is_ego and hit_next(course, phase)
    return "" if hits else _at_gap(course, phase, first)


def _passing(course: Course, phase: Phase, first: bool) -> str | None:
    """Out of its lane to get past another: near what stands, in time behind who drives, or once it has come up."""
    a = course.actor
    if phase.action in ("overtake", "swerve") and parked_in_way(a.structure, phase.target):
        return _near(course, phase.target)
    in_row = course.oncoming_both(phase) or course.lane is not None and course.same_lane(phase)
    if phase.action != "overtake" or not in_row:
        return None
    if course.target_speed(phase) <= 0:
        return "" if stood(a, phase) else _near(course, phase.target)
    earlier, out = before(a, phase), pulls_out(course, phase)
    follows = any(p.action == "follow" for p in earlier[-1:])
    by_cause = phase.abandoned and out.startswith("until ttc")
    calm = {p.action for p in earlier} <= traffic.CALM
    if by_cause or not calm or not follows and course.value >= course.target_speed(phase) + NO_FASTER:
        return out
    if not follows:
        return _undisturbed(a)
    if course.value > course.target_speed(phase) + CAUGHT_UP:
        return f"until self.speed < {a.ref(phase.target)}.speed + {scope.number(CAUGHT_UP)}"
    return f"for {FOLLOWS} seconds"


def _before_what_stands(course: Course, phase: Phase, first: bool) -> str | None:
    a = course.actor
    if a.is_ego and phase.action == "oncoming" and (stands := standing(a.structure, a.plan.lane_of)):
        return _near(course, stands)
    if phase.action in ("swerve", "cut_out", "lane_change") and (obstacle := _obstacle(course, phase)):
        return f"until (distance from self to {obstacle}) < 12 + 2 * self.speed"
    return None


def _for_ego(course: Course, phase: Phase, first: bool) -> str | None:
    """In front of ego as that is near, or behind it as it comes over."""
    a = course.actor
    if phase.action == "u_turn" and first and not a.is_ego and (course.oncoming or a.value <= 0):
        return f"until (distance from self to ego) < {scope.number(12 + 2.2 * (a.value + a.plan.ego_speed))}"
    if first and phase.action in SLOWS and _comes_over(a):
        as_fast = a.value < a.plan.ego_speed + NO_FASTER  # ego is no hindrance, and one makes room for it
        return "until braking_needed(self, ego) > 1" + (" or off_lane(ego)" if as_fast else "")
    return None


def _of_its_own_accord(course: Course, phase: Phase, first: bool) -> str:
    a = course.actor
    lets_by = phase.action == "yield" and first and in_next_lane(course, phase)
    sets_off = phase.action == "start" and first and a.lane is not None and a.value <= 0
    if lets_by or sets_off:
        return _undisturbed(a)
    if not first or phase.action not in DELAYED or a.value <= 0 or hit_beside(course, phase):
        return ""
    if course.oncoming:
        early = AHEAD["drift" if phase.action == "drift" else "other"]
        return f"until (distance from self to ego) < {scope.number(early * (a.value + a.plan.ego_speed))}"
    return _undisturbed(a)


_RULES: tuple[Callable[[Course, Phase, bool], str | None], ...] = (
    _as_its_cause_comes, _at_once, _where_it_begins, _sideways, as_it_is_forced, _opposite_who_stands, _cutting_in,
    _passing, _before_what_stands, _for_ego, _of_its_own_accord,
)  # fmt: skip
"""What may say when, the first that does; None: the next one may."""


def _undisturbed(actor: Actor) -> str:
    """What goes before the first thing that somebody does of its own accord."""
    return f"for {scope.number(ahead.begins(actor.structure, actor.cid))} seconds"


def _near(course: Course, cid: str | None) -> str:
    """So near to one that stands that there is just room to get out of its lane; of works the sign comes first."""
    spec = course.actor.structure[cid].spec if cid and cid in course.actor.structure else None
    kind = spec.type if isinstance(spec, ObjectSpec) else "car"
    room = 18 if kind in WORKS else round(9.5 + LENGTH[kind] / 2)
    return f"until (distance from self to {course.actor.ref(cid)}) < {room} + 1.9 * self.speed"


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

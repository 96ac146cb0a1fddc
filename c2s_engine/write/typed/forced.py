"""When ego does what another forces it to: as it takes so much to keep from that one."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.alongside import offset
from c2s_engine.write.typed.causes import AT_LAST
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.people import REACTS
from c2s_engine.write.typed.reach import EVADED_AT
from c2s_engine.write.typed.tables import MOVES_OFF_ROAD, is_static
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
from c2s_engine.write.typed.usual import crosses, speed_of

NEAR_BY = 8.0
"""m before one beside its way by which ego has slowed down for it."""
HARD = 4.0
"""m/s2 from which a braking is a hard one."""
FORCED = {"brake", "stop", *ASIDE}
"""What others force ego to do."""
COMES_OVER = {
    "oncoming", "drift", "swerve", "lose_control", "lane_change", "overtake", "cut_in", "turn_left",
    "u_turn", "collide",
}  # fmt: skip
"""What leads one that comes towards ego into its lane."""


def as_it_is_forced(course: Course, phase: Phase, first: bool) -> str | None:
    """The condition under which ego is forced to a phase; None: nobody forces it."""
    a = course.actor
    if not a.is_ego or phase.action not in FORCED:
        return None
    if not stood(a, phase) and not _answered(a, phase) and _confronted(course, phase):
        return _forced(course, phase, first)
    if phase.action == "stop" and (cid := _stopped_for(course, phase)):
        return f"until (distance from self to {a.ref(cid)}) < 14 + self.speed ** 2 / 6"
    return None


def _forced(course: Course, phase: Phase, first: bool) -> str:
    a = course.actor
    cid = phase.target or getattr(a.spec, "react_to", None) or standing(a.structure, a.plan.lane_of)
    if beside_way(a.structure, cid):
        return f"until ttc(self, {a.ref(cid)}) < {scope.number(EVADED_AT if first else EVADED_AT / 2)}"
    other = course.other(cid) if cid else None
    if phase.action in ASIDE and other is not None and crosses(other):
        return f"until min(lately({a.ref(cid)}, {REACTS:g})) > 0.3"  # it has set out
    need, limit = _need(course, phase, cid)
    also = f" or near(self, {a.ref(cid)})" if any(p.action == "collide" for p in a.spec.phases) else ""
    if phase.action == "stop" and is_stopped(a.spec) and not on_foot(a.structure) and a.value > 0:
        also += " or self.speed < 0.5"  # it was forced to
    elif phase.action in SLOWS and cid and _beside(course, cid):
        goal = course.wanted(phase, course.value / 2) if phase.action == "brake" else 0.0
        rest = max(course.value**2 - goal**2, 0.0) / (2 * (middle(phase.rate) if phase.rate else 3.0))
        also += f" or (distance from self to {a.ref(cid)}) < {scope.number(round(rest + NEAR_BY, 1))}"
    return f"until {need} > {limit}{also}"


def _need(course: Course, phase: Phase, cid: str | None) -> tuple[str, float]:
    """The deceleration that it takes, and how much of it (m/s2) makes ego do something."""
    a, other = course.actor, course.other(cid) if cid else None
    hard = getattr(a.spec, "hard", False) or (phase.rate is not None and middle(phase.rate) >= HARD)
    limit = 4 if hard else 2
    if phase.action in ASIDE:
        limit = 2 if other is not None and is_static(other) else 1.2  # type: ignore[assignment]
    if other is not None and offset(other, a.spec, a.plan.place):  # type: ignore[arg-type]
        return f"needed_before_turn(self, line, {a.ref(cid)})", max(limit, AT_LAST)
    them = once_seen(a.structure, [cid])[0] if cid else a.ref(cid)
    return f"braking_needed(self, {them.removeprefix('*')})", limit


def before(actor: Actor, phase: Phase) -> tuple[Phase, ...]:
    """What one does before a phase."""
    phases = actor.spec.phases
    return phases[: phases.index(phase)] if phase in phases else ()


def stood(actor: Actor, phase: Phase) -> bool:
    """Whether it gets past another from where it came to a stand: nothing forces it any more."""
    stands = ("stop", "wait", "yield") if phase.action == "overtake" else ("stop", "wait")
    gets_past = phase.action in ("lane_change", "swerve", "overtake")
    return gets_past and any(p.action in stands for p in before(actor, phase))


def _answered(actor: Actor, phase: Phase) -> bool:
    """Whether an earlier phase has left the lane for the same one: what comes then waits for it no more."""
    cause = getattr(actor.spec, "react_to", None)
    return any(p.action in ASIDE and (p.target or cause) == (phase.target or cause) for p in before(actor, phase))


def _beside(course: Course, cid: str) -> bool:
    """Whether one is, and stays, beside ego's way: nothing but being near it forces ego to slow down for it."""
    spec = course.other(cid)
    beside = spec is not None and spec.placement.position in {*MOVES_OFF_ROAD, "intersection_exit"}
    return beside and {p.action for p in spec.phases} <= STAYS  # type: ignore[union-attr]


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
        forcing = (c for c in threatening(a.structure) if not awaits(a.structure, c, phase.action))
        return any(_in_front(a, c) and _presses(course, c) for c in forcing)
    if cid == "ego" or cid not in a.structure or awaits(a.structure, cid, phase.action):
        return False
    spec = a.structure[cid].spec
    if not isinstance(spec, ObjectSpec) or phase.action == "stop" and _stays_opposite(spec):
        return False
    if offset(spec, a.spec, a.plan.place):  # type: ignore[arg-type]
        return True  # ego turns across its way
    if spec.placement.position == "behind" or spec.placement.along == "behind":
        comes = any(p.action in ("cut_in", "overtake") for p in spec.phases) and phase.action in SLOWS
        return comes and getattr(a.spec, "reaction", "") != "yield"  # else it has been let by
    abreast = "beside" in (spec.placement.position, spec.placement.along) or spec.placement.along == "abreast"
    if abreast and {p.action for p in spec.phases} <= STAYS:
        return False  # there is no room beside it, and it keeps ego from nothing else
    return (spec.placement.position in IN_WAY or not is_static(spec)) and _presses(course, cid)


def awaits(structure: Structure, cid: str, action: str) -> bool:
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

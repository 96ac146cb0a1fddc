"""For what others than ego brake or stop: what S names comes into their way, or is ahead in their lane."""

from c2s_engine.structure.facts import called
from c2s_engine.structure.objects import SLOWS, is_ahead, slows_for
from c2s_engine.structure.specs import Phase, Trigger
from c2s_engine.write.typed.collisions import hit_next
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.tables import is_static, is_vehicle
from c2s_engine.write.typed.usual import crosses
from c2s_engine.write.typed.watching import watched

COMES = (
    "cross_road", "enter_road", "cut_in", "lane_change", "swerve", "drift", "lose_control", "oncoming", "reverse",
    "u_turn",
)  # fmt: skip
"""What leads one into another's way."""
AT_LAST = 4
"""m/s2 that it takes by when one gets round ego that comes into its way, or ego notices whose way it turns across."""
NEED = 2
"""m/s2 that it takes to stay behind another, from which one brakes for that one."""


def because(course: Course, phase: Phase) -> str:
    """Until when one drives on that then brakes, or stops, for its target; "": it does so of its own accord."""
    a = course.actor
    if a.approach and phase.action == "swerve" and phase.trigger is None and phase.target in (None, "ego"):
        return f"until braking_needed(self, ego) > {AT_LAST}"
    if _answers(course, phase) and (does := comes(course, phase)):
        seen = Trigger(kind="action", of=phase.target, action=does)
        return f"until {watched(a.structure, a.plan, seen, a.cid)}"
    if _answers(course, phase) and course.same_lane(phase) and not course.oncoming:
        return f"until braking_needed(self, {a.ref(phase.target)}) > {NEED}"
    return ""


def comes(course: Course, phase: Phase) -> str | None:
    """What the target of such a phase does that leads it into one's way; None: it does nothing of the kind."""
    whom = course.party(phase.target) if _answers(course, phase) else None
    does = next((p.action for p in whom.phases if p.action in (*SLOWS, *COMES)), None) if whom is not None else None
    return does if does in COMES else None


def _answers(course: Course, phase: Phase) -> bool:
    """Whether a phase of another than ego answers to its target, and hits nobody next; not before a junction."""
    a, whom = course.actor, course.party(phase.target) if phase.target else None
    if a.is_ego or a.approach or phase.trigger is not None or hit_next(course, phase):
        return False
    return slows_for(a.cid, a.spec, phase, whom)


def drives_ahead(course: Course, cid: str) -> bool:
    """Whether another vehicle drives ahead in one's lane, on its own or once it has come into it."""
    a, spec = course.actor, course.other(cid)
    if spec is None or is_static(spec) or not is_vehicle(spec.type) or spec.placement.facing == "against":
        return False
    if a.is_ego:
        ahead = spec.placement.of == "ego" and spec.placement.position == "ahead"
    else:
        ahead = course.lane is not None and a.plan.lane_of.get(cid) == course.lane and not is_ahead(a.spec, cid)
    before = any(p.action == "cut_in" and p.target in (None, called(a.cid)) for p in spec.phases)
    return ahead and not crosses(spec) or before

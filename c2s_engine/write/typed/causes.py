"""For what others than ego brake or stop: what S names comes into their way, or is ahead in their lane."""

from c2s_engine.structure.objects import is_ahead
from c2s_engine.structure.specs import Phase, Trigger
from c2s_engine.write.typed.collisions import hit_next
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.watching import watched

SLOWS = ("brake", "stop")
COMES = (
    "cross_road", "enter_road", "cut_in", "lane_change", "swerve", "drift", "lose_control", "oncoming", "reverse",
    "u_turn",
)  # fmt: skip
"""What leads one into another's way."""
NEED = 2
"""m/s2 that it takes to stay behind another, from which one brakes for that one."""


def because(course: Course, phase: Phase) -> str:
    """Until when one drives on that then brakes, or stops, for its target; "": it does so of its own accord."""
    a = course.actor
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
    """Whether a phase of another than ego answers to its target: not where that waits for it, or is behind it, nor
    before a junction."""
    a, whom = course.actor, course.party(phase.target) if phase.target else None
    if a.is_ego or a.approach or whom is None or phase.action not in SLOWS or phase.trigger is not None:
        return False
    if is_ahead(a.spec, phase.target):  # nobody brakes for whom it has behind it
        return False
    return not any(p.trigger is not None and p.trigger.of == a.cid for p in whom.phases) and not hit_next(course, phase)

"""When a phase begins: its stated trigger, as a condition of the program."""

from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import Phase
from c2s_engine.write.typed import ahead, scope
from c2s_engine.write.typed.causes import drives_ahead
from c2s_engine.write.typed.course import Course
from c2s_engine.write.typed.forced import awaits
from c2s_engine.write.typed.implied import implicit
from c2s_engine.write.typed.reach import EVADED_AT
from c2s_engine.write.typed.towards import held_for
from c2s_engine.write.typed.usual import slows_before
from c2s_engine.write.typed.watching import METRES, watched, watches

CAN_STOP = 10
"""Twice the m/s2 at which one stops for a light that changes."""
BEFORE_IT = 2.0
"""m before a crosswalk by which one has slowed down for it."""
TO_END = 6.0
"""m before the end of an acceleration lane at which the middle of one is who stops there."""


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
        if value is None and course.actor.is_ego and t.of and awaits(course.actor.structure, t.of, phase.action):
            return f"until ttc(self, {course.actor.ref(t.of)}) < {scope.number(EVADED_AT)}"  # nothing forces it yet
        if value is None and (found := implicit(course, near, first=False)):  # as soon as it has to
            return found
        if phase.action == "cut_in" and course.value > course.target_speed(phase) + 0.3:  # once it is that far ahead
            return f"until ahead_by(self, {course.actor.ref(t.of)}) > {scope.number(value or METRES)}"
    if t.place == "crosswalk" and t.value is None and phase.action in SLOWS:  # it is that slow by then
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


def _before_junction(course: Course, value: float, phase: Phase) -> str:
    if phase.trigger is not None and phase.trigger.place == "merge_end":
        there, metres = "place.acceleration_lane", scope.number(max(value, ahead.MERGES))
        if phase.action in SLOWS:  # as far before it as that takes
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

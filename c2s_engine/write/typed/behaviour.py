"""Phases to a Scenic behaviour: each becomes one `do`, ended by the next phase's trigger or its own completion."""

from c2s_engine.structure.specs import Phase, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.steps import Step, steps
from c2s_engine.write.typed.triggers import implicit, stated

ONWARD = {"start", "wait", "go_straight", "turn_left", "turn_right", "accelerate", "collide"}
ON_THE_WAY = {
    "go_straight",
    "turn_left",
    "turn_right",
    "run_red",
    "run_stop",
    "keep_lane",
    "move_along",
    "brake",
    "accelerate",
}
"""What the line over the junction, its lights and signs already say."""
SLOW = "5"
"""m/s at which somebody comes up to where it first stands."""
AT_EDGE = Trigger(kind="place", place="intersection", value=0)


def body(actor: Actor) -> list[str]:
    """The statements of the behaviour (not indented)."""
    course = Course(actor)
    out = [f"line = {actor.line}"]
    if actor.value > 0:
        out.append(f"take SetSpeedAction({SLOW if actor.cid in actor.plan.set_out else actor.speed})")
    done = _steps(course)
    for i, (statements, until) in enumerate(done):
        *before, final = statements
        out += before
        last = i == len(done) - 1
        if last or (not final.startswith("do Drive") and not until):
            out.append(final)
        else:
            out.append(f"{final} {until or _usual(done[i + 1])}")
    return out


def _usual(then: Step) -> str:
    """How long a step lasts that nothing ends: one before a collision at a spot is short, so that there is time to
    arrive there with the other."""
    return "for 0.5 seconds" if "strike(" in then[0][-1] else "for 3 seconds"


def _up_to_contact(phases: list[Phase]) -> list[Phase]:
    """The phases of one who comes by another road, without what is no more than its way to whom it hits there."""
    hit = next((i for i, p in enumerate(phases) if p.action == "collide"), 0)
    return [p for i, p in enumerate(phases) if i >= hit or p.action not in ON_THE_WAY or p.trigger is not None]


def _steps(course: Course) -> list[Step]:
    phases = _phases(course.actor)
    done: list[Step] = []
    if not phases or phases[0].trigger is not None or implicit(course, phases[0]):
        done.append(([course.drive(SLOW if course.actor.cid in course.actor.plan.set_out else None)], ""))
    for i, phase in enumerate(phases):
        condition = stated(course, phase) if phase.trigger else implicit(course, phase, i == 0)
        if condition:
            if not done:
                done.append(([course.drive()], ""))
            gaining = course.catching_up(phase) if phase.action == "cut_in" and not phase.trigger else None
            before = [course.drive(scope.number(gaining))] if gaining and i == 0 else done[-1][0]
            done[-1] = (before, condition)
        done.extend(steps(course, phase))
    return done


def _phases(actor: Actor) -> list[Phase]:
    """The phases, with what the place asks of ego (its red light, its stop sign) put first."""
    phases = list(actor.spec.phases)
    if actor.approach:
        phases = _up_to_contact(phases)
    if not actor.is_ego and 1 not in actor.plan.offsets:  # by the oncoming lane: the overtaking says so
        after = [*(p.action for p in phases[1:]), ""]
        phases = [p for i, p in enumerate(phases) if (p.action, after[i]) != ("oncoming", "overtake")]
    if not actor.plan.junction or not (actor.is_ego or actor.approach):
        return phases
    for i, (phase, then) in enumerate(zip(phases, phases[1:], strict=False)):
        stands = phase.action == "stop" or i == 0 and actor.cid in actor.plan.set_out
        if stands and phase.trigger is None and then.action in ONWARD:  # at the junction's edge
            phases[i] = phase.model_copy(update={"action": "stop", "trigger": AT_EDGE, "duration": None})
    if not actor.is_ego:
        return phases
    actions = {p.action for p in phases}
    light = getattr(actor.structure.settings.spec, "light", None)
    control = actor.plan.place.control
    if control == "signal" and light == "red" and not actions & {"run_red", "stop", "stationary"}:
        return [*phases, Phase(action="stop", trigger=AT_EDGE)]
    gives_way = actions & {"run_stop", "stop", "yield"} or getattr(actor.spec, "reaction", "") == "yield"
    if control == "stop" and not gives_way:
        stop = Phase(action="stop", trigger=AT_EDGE)
        return [stop, Phase(action="wait", duration=1.0), Phase(action="start"), *phases]
    return phases

"""Phases to a Scenic behaviour: each becomes one `do`, ended by the next phase's trigger or its own completion."""

from c2s_engine.structure.sentences import action_of
from c2s_engine.structure.specs import Phase
from c2s_engine.write.typed import ahead, scope
from c2s_engine.write.typed.at_junction import phases_of
from c2s_engine.write.typed.causes import drives_ahead
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.forced import FORCED
from c2s_engine.write.typed.implied import implicit
from c2s_engine.write.typed.lanes import leaves_behind
from c2s_engine.write.typed.lateral import LATERAL
from c2s_engine.write.typed.overtakings import nearest
from c2s_engine.write.typed.steps import AT_LINE, IN_JUNCTION, Reached, Step, steps
from c2s_engine.write.typed.tables import AT_REST
from c2s_engine.write.typed.towards import its_turn
from c2s_engine.write.typed.triggers import stated
from c2s_engine.write.typed.usual import SETS_OUT
from c2s_engine.write.typed.watching import watched

SLOW = "5"
"""m/s at which somebody comes up to where it first stands."""
LOST = 2.5
"""m/s that one loses whose braking is to be seen, where nothing says to what speed."""
COMMENTED = 84
"""Characters of a statement with its comment, in a line of 100."""


def body(actor: Actor) -> list[str]:
    """The statements of the behaviour (not indented), each with what it does as a comment where a phase begins."""
    course = Course(actor)
    out = [f"line = {actor.line}"]
    if actor.value > 0:
        out.append(f"take SetSpeedAction({SLOW if actor.sets_out else actor.speed})")
    done, begun = _steps(course)
    while len(done) > 1 and done[-2][0] == done[-1][0]:  # it goes on with the same for good
        begun[len(done) - 2] = begun.get(len(done) - 2) or begun.get(len(done) - 1, "")
        del done[-2]
    line = out[0]
    for i, (statements, until) in enumerate(done):
        *before, final = statements
        out += [s for s in before if s != line]
        line = next((s for s in reversed(before) if s.startswith("line = ")), line)
        last = i == len(done) - 1
        if not last and isinstance(until, Reached) and final.startswith("do Drive(") and "lambda" not in final:
            final = until.library(final)
        elif not last and (final.startswith(("do Drive(", "do Stop(")) or until):
            first = ahead.awaited(actor.structure, actor.cid) if i == 0 else 0.0
            final += f" {until or f'for {scope.number(first or 3)} seconds'}"
        comment = begun.get(i) if len(done) > 1 else ""
        out.append(f"{final}  # {comment}" if comment and len(final) + len(comment) < COMMENTED else final)
    return out


def _steps(course: Course) -> tuple[list[Step], dict[int, str]]:
    """The steps, and in words what those do, by number, with which a phase begins."""
    phases = phases_of(course.actor)
    done: list[Step] = []
    begun: dict[int, str] = {}
    since, was = 0, course.value  # the first step of the phase before, and how fast it was then
    first = phases[0].trigger if phases else None
    nears = first is not None and first.kind in ("ttc", "distance")  # as it drives
    course.behind = "" if nears else _overtaken_later(course, phases)
    if not phases or phases[0].trigger is not None or implicit(course, phases[0]):
        done.append(([course.drive(SLOW if course.actor.sets_out else _behind_awaited(course, phases))], ""))
    for i, phase in enumerate(phases):
        ended = i > 0 and phases[i - 1].until is not None  # what comes before lasts until that
        condition = stated(course, phase) if phase.trigger else "" if ended else implicit(course, phase, i == 0)
        if condition:
            if not done:
                done.append(([course.drive()], ""))
            if phase.trigger is None and done[-1][1] == IN_JUNCTION:  # then, no sooner or (to answer) later
                answers = getattr(course.actor.spec, "reaction", "none") not in ("none", "yield")
                condition = f"{IN_JUNCTION} and ({condition.removeprefix('until ')})" if answers else IN_JUNCTION
            merges = course.on_ramp and phase.action in ("cut_in", "lane_change")  # before that lane ends
            reached = done[-1][1] if phase.trigger and phase.trigger.kind == "action" and not merges else ""
            finishes = reached.startswith("until self.speed") and phase.action not in FORCED
            if finishes:  # it finishes what it does: what others do can still be seen
                slowed = phases[i - 1].action == "brake" and phases[i - 1].speed is None and was > LOST
                least = f"until self.speed < {scope.number(was - LOST)}" if slowed else reached
                condition = f"{least} and {condition.removeprefix('until ')}"
            stands = i > 0 and phases[i - 1].action == "stop" and done[-1][1] == "for 1 seconds"
            if stands and phase.trigger and phase.trigger.kind == "passed":  # even if that one has gone by before
                done.append(done[-1])
            done[-1] = (done[-1][0], condition)
            if phase.trigger and phase.trigger.kind == "contact":  # it breaks off whatever is being done
                done[since:] = [(statements, until or condition) for statements, until in done[since:]]
            if phase.trigger and phase.trigger.delay is not None and phase.trigger.kind != "time":
                done.append((done[-1][0][-1:], f"for {scope.quantity(phase.trigger.delay)} seconds"))
            if phase.trigger and merges:
                done.append((done[-1][0][-1:], "until self._lane is place.acceleration_lane"))
        course.behind = _overtaken_later(course, phases[i:])
        home, course.home = course.home, []
        was = course.value
        own, since = steps(course, phase), len(done)
        if own:
            begun[len(done)] = action_of(phase, course.actor.structure)
        done.extend(own)
        if home:
            done.extend(home)
            course.aside = ""
        if phase.until is not None and done:
            actor = course.actor
            back = {**dict.fromkeys(LATERAL, 1), "overtake": 2}.get(phase.action, 0) if phase.abandoned else 0
            out = -max(min(1 + back, len(own)), 1)  # what it is broken off by, before the steps home
            done[out] = (done[out][0], f"until {watched(actor.structure, actor.plan, phase.until, actor.cid)}")
            if i + 1 == len(phases):  # it drives on
                done.append(([course.drive(course.set(actor.value or SETS_OUT))], ""))
        if _at_line(course.actor, phase, i) and (turn := its_turn(course.actor)):
            done.append(([course.drive("0", 4)], f"until {turn}"))
    return done, begun


def _behind_awaited(course: Course, phases: list[Phase]) -> str | None:
    """The pace of one that comes up to another ahead in its lane and waits for what that does; None: its own."""
    trigger = phases[0].trigger if phases else None
    whom = trigger.of if trigger is not None and trigger.kind == "action" else None
    if leaves_behind(course.actor.spec):
        return course.pacing(whom, course.speed)
    if not course.actor.is_ego or whom is None or not drives_ahead(course, whom):
        return None
    faster = course.value > course.target_speed(phases[0].model_copy(update={"target": whom})) + 1
    return course.pacing(whom, course.speed) if faster else None


def _overtaken_later(course: Course, phases: list[Phase]) -> str:
    """Whom it overtakes in its lane, where it does something else before; "": nobody."""
    later = next((p for p in phases[1:] if p.action == "overtake"), None)
    if later is None or course.lane is None or not course.same_lane(later):
        return ""
    return nearest(course, later)


def _at_line(actor: Actor, phase: Phase, i: int) -> bool:
    """Whether somebody stands at the stop line after its i-th phase."""
    return phase.trigger == AT_LINE or i == 0 and actor.is_ego and actor.value <= 0 and phase.action in AT_REST



"""Phases to a Scenic behaviour: each becomes one `do`, ended by the next phase's trigger or its own completion."""

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.sentences import action_of
from c2s_engine.structure.specs import ObjectSpec, Phase, SettingsSpec, Trigger
from c2s_engine.write.typed import ahead, lights, scope
from c2s_engine.write.typed.causes import drives_ahead
from c2s_engine.write.typed.course import Actor, Course
from c2s_engine.write.typed.forced import FORCED
from c2s_engine.write.typed.implied import implicit
from c2s_engine.write.typed.lanes import leaves_behind
from c2s_engine.write.typed.lateral import LATERAL
from c2s_engine.write.typed.overtakings import nearest
from c2s_engine.write.typed.steps import AT_LINE, IN_JUNCTION, Reached, Step, steps
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST, TURN
from c2s_engine.write.typed.towards import SETS_OFF, its_turn
from c2s_engine.write.typed.triggers import stated
from c2s_engine.write.typed.usual import SETS_OUT, SLOWS_DOWN, slows_before
from c2s_engine.write.typed.watching import watched

ONWARD = {"start", "wait", "yield", "go_straight", "turn_left", "turn_right", "accelerate", "collide"}
ON_THE_WAY = {"go_straight", "turn_left", "turn_right", "run_red", "run_stop", "keep_lane", "move_along", "accelerate"}
"""What the line over the junction, its lights and signs already say, or the speed at which it arrives."""
ELSEWHERE = {*APPROACH_ANGLE, "behind", "oncoming_lane"}
"""Where those start who are no reason for ego to stop before the junction."""
BEFORE_IT = Trigger(kind="place", place="intersection", value=6)
"""When one brakes on its way to a junction."""
SLOW = "5"
"""m/s at which somebody comes up to where it first stands."""
AT_SIGN = {"run_stop", "stop", "yield", "wait", "stationary"}
"""What says itself what ego does at its stop sign."""
LOST = 2.5
"""m/s that one loses whose braking is to be seen, where nothing says to what speed."""
COMMENTED = 84
"""Characters of a statement with its comment, in a line of 100."""
QUEUED = 3.0
"""s for which one stands before the junction, so that those behind come to a stand, too."""


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


def _up_to_contact(phases: list[Phase], speed: float) -> list[Phase]:
    """The phases of one who comes by another road, without what is no more than its way to whom it hits there; where
    nothing says when, it brakes before the junction."""
    hit = next((i for i, p in enumerate(phases) if p.action == "collide"), 0)
    kept = [p for i, p in enumerate(phases) if i >= hit or p.action not in ON_THE_WAY or p.trigger is not None]
    slower = {"trigger": BEFORE_IT, "speed": round(speed / 2, 1)}
    late = bool(hit) and all(p.rate is None for p in kept)  # it brakes, and hits it nevertheless
    brakes = [p.action == "brake" and not late and p.trigger is None for p in kept[:-1]] + [False] * bool(kept)
    return [p.model_copy(update=slower | ({"speed": p.speed} if p.speed is not None else {})) if b else p
            for p, b in zip(kept, brakes, strict=True)]  # fmt: skip


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


def _at_stop_line(phase: Phase) -> bool:
    """Whether somebody stops at its line."""
    t = phase.trigger
    there = phase.action == "stop" and t is not None and t.place == "stop_line" and t.subject is None
    return there and t is not None and not middle(t.value or 0.0) and t.delay is None


def _just_waits(phase: Phase) -> bool:
    return phase.action == "wait" and phase.duration is None and phase.trigger is None


def _gives_way_first(phases: list[Phase]) -> list[Phase]:
    """The phases with letting others pass before the way over the junction that S names first."""
    for i, (phase, then) in enumerate(zip(phases, phases[1:], strict=False)):
        if phase.action in TURN and then.action == "yield" and phase.trigger is None and then.trigger is None:
            return [*phases[:i], then, phase, *phases[i + 2 :]]
    return phases


def _held_at_line(phases: list[Phase]) -> list[Phase]:
    """The phases with letting another pass, before the junction, instead of a turn that waits for its passing."""
    found: list[Phase] = []
    for phase in phases:
        t, last = phase.trigger, found[-1:] if found and found[-1].action == "start" else found  # it has gone on
        stood = any(p.action in AT_REST or p.action == "yield" for p in last)
        waits = t is not None and t.kind == "passed" and t.subject not in (None, "ego") and t.delay is None
        if phase.action in TURN and waits and t is not None and not stood:
            found += [Phase(action="yield", target=t.subject), phase.model_copy(update={"trigger": None})]
        else:
            found.append(phase)
    return found


def _before_junction(actor: Actor, phases: list[Phase]) -> bool:
    """Whether the stop that comes last in these phases is for the junction: nobody on ego's own way is there to stop
    for, and it has not turned yet."""
    if {p.action for p in phases[:-1]} & SETS_OFF or any(p.action == "collide" for p in actor.spec.phases):
        return False
    specs = [c.spec for c in actor.structure.objects if isinstance(c.spec, ObjectSpec)]
    return not actor.is_ego or all(s.placement.position in ELSEWHERE for s in specs)


def _on_egos_approach(actor: Actor) -> bool:
    """Whether somebody starts on ego's approach."""
    placement = getattr(actor.spec, "placement", None)
    return placement is not None and placement.position in lights.BESIDE_EGO and placement.facing != "against"


def _red(actor: Actor) -> bool:
    """Whether the light before the junction is red."""
    settings = actor.structure.settings.spec
    if actor.plan.place.control != "signal" or not isinstance(settings, SettingsSpec):
        return False
    return settings.light == "red" or any(c.to in lights.HALTS for c in settings.light_changes)


def _at_the_line(phases: list[Phase], red: bool) -> list[Phase]:
    """The phases of one who stops before the junction for its light, or and then goes over it: where that stop is. Who
    does nothing else stops there for a red light; who only waits for one goes on as it turns green."""
    goes_on = Phase(action="start", trigger=Trigger(kind="light", light="green"))
    if red and all(p.action == "keep_lane" and p.trigger is None for p in phases):
        return [*phases, Phase(action="stop", trigger=AT_LINE), goes_on]
    if red and _just_waits(phases[-1]):
        return [*phases, goes_on]
    if red and len(phases) == 1 and phases[0].action == "stop" and phases[0].trigger is None:
        return [phases[0].model_copy(update={"trigger": AT_LINE})]
    if red and [p.action for p in phases[:2]] == ["stop", "start"] and phases[0].trigger is None:
        return [phases[0].model_copy(update={"trigger": AT_LINE}), *phases[1:]]
    if len(phases) < 2 or phases[0].action != "stop" or phases[0].trigger is not None or phases[1].action not in TURN:
        return phases
    stop = phases[0].model_copy(update={"trigger": AT_LINE, "duration": phases[0].duration or QUEUED})
    return [stop, *phases[1:]]


def phases_of(actor: Actor) -> list[Phase]:
    """The phases, with what the place asks of ego (its red light, its stop sign) put first."""
    first = next((p for p in actor.spec.phases if _at_stop_line(p)), None)  # who sets out again stops beyond it
    phases = [p.model_copy(update={"trigger": AT_LINE}) if p is first else p for p in actor.spec.phases]
    settings, runs = actor.structure.settings.spec, any(p.action == "run_red" for p in phases)
    if actor.is_ego and not runs and isinstance(settings, SettingsSpec) and settings.light_changes:
        phases = lights.obeyed(phases, settings)
    if actor.approach:
        phases = _up_to_contact(phases, actor.value)
    beyond = [q.action == "swerve" and q.target and q.side != "right" for q in phases]  # out there already
    phases = [p for i, p in enumerate(phases) if p.action != "oncoming" or p.trigger or not (i and beyond[i - 1])]
    if 1 not in actor.plan.offsets:  # by the oncoming lane: the overtaking says so
        after = [*(p.action for p in phases[1:]), ""]
        phases = [p for i, p in enumerate(phases) if (p.action, after[i]) != ("oncoming", "overtake")]
    if not actor.plan.junction or not (actor.is_ego or actor.approach):
        return _at_the_line(phases, _red(actor)) if actor.plan.junction and _on_egos_approach(actor) else phases
    phases = _gives_way_first(_held_at_line(phases))
    for i, phase in enumerate(phases):
        then = phases[i + 1] if i + 1 < len(phases) else None
        if phase.action == "brake" and phase.trigger is None and phase.speed and then and then.action in TURN:
            at = slows_before(actor.value, middle(phase.speed), middle(phase.rate or SLOWS_DOWN))
            phases[i] = phase.model_copy(update={"trigger": at})
            continue
        if i == 0 and actor.is_ego and actor.value <= 0 and phase.action == "stop" and then is not None:
            phases[i] = phase.model_copy(update={"action": "stationary"})  # it stands there
            continue
        if i == 0 and actor.sets_out and actor.value <= 0 and phase.action in AT_REST:
            phases[i] = phase.model_copy(update={"action": "wait"})  # it stands at its line
            continue
        under_way = SETS_OFF & {p.action for p in phases[:i]}  # it stops in the junction, not before it
        stands = phase.action == "stop" and not under_way or i == 0 and actor.sets_out
        onward = then is not None and then.action in ONWARD
        if stands and phase.trigger is None and (onward or _before_junction(actor, phases[: i + 1])):
            phases[i] = phase.model_copy(update={"action": "stop", "trigger": AT_LINE, "duration": None})
            if then and _just_waits(then) and its_turn(actor):
                return [*phases[: i + 1], *phases[i + 2 :]]
    if not actor.is_ego:
        return phases
    actions = {p.action for p in phases}
    control = actor.plan.place.control
    standing = actions & {"stop", "stationary"} or actor.value <= 0 and "wait" in actions
    if _red(actor) and "run_red" not in actions and not standing:
        return [*phases, Phase(action="stop", trigger=AT_LINE)]
    gives_way = actions & AT_SIGN or getattr(actor.spec, "reaction", "") == "yield" or actor.value <= 0
    if control == "stop" and not gives_way:
        stop = Phase(action="stop", trigger=AT_LINE)
        return [stop, Phase(action="wait", duration=1.0), Phase(action="start"), *phases]
    return phases

"""What somebody does in which order, with what the place asks: where it stops before a junction, for whom, and when it
goes on."""

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Phase, SettingsSpec, Trigger
from c2s_engine.write.typed import lights
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.steps import AT_LINE
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST, TURN
from c2s_engine.write.typed.towards import SETS_OFF, its_turn
from c2s_engine.write.typed.usual import SLOWS_DOWN, slows_before

ONWARD = {"start", "wait", "yield", "go_straight", "turn_left", "turn_right", "accelerate", "collide"}
ON_THE_WAY = {"go_straight", "turn_left", "turn_right", "run_red", "run_stop", "keep_lane", "move_along", "accelerate"}
"""What the line over the junction, its lights and signs already say, or the speed at which it arrives."""
ELSEWHERE = {*APPROACH_ANGLE, "behind", "oncoming_lane"}
"""Where those start who are no reason for ego to stop before the junction."""
BEFORE_IT = Trigger(kind="place", place="intersection", value=6)
"""When one brakes on its way to a junction."""
AT_SIGN = {"run_stop", "stop", "yield", "wait", "stationary"}
"""What says itself what ego does at its stop sign."""
QUEUED = 3.0
"""s for which one stands before the junction, so that those behind come to a stand, too."""


def phases_of(actor: Actor) -> list[Phase]:
    """The phases, with what the place asks of ego (its red light, its stop sign) put first."""
    phases = _without_way_out(actor, _with_lights(actor))
    if not actor.plan.junction or not (actor.is_ego or actor.approach):
        return _at_the_line(phases, _red(actor)) if actor.plan.junction and _on_egos_approach(actor) else phases
    phases = _stopping_before(actor, _gives_way_first(_held_at_line(phases)))
    return _obeying(actor, phases) if actor.is_ego else phases


def _with_lights(actor: Actor) -> list[Phase]:
    """The phases, with the stop at the stop line where that is, and with how ego obeys a light that changes."""
    first = next((p for p in actor.spec.phases if _at_stop_line(p)), None)  # who sets out again stops beyond it
    phases = [p.model_copy(update={"trigger": AT_LINE}) if p is first else p for p in actor.spec.phases]
    settings, runs = actor.structure.settings.spec, any(p.action == "run_red" for p in phases)
    if actor.is_ego and not runs and isinstance(settings, SettingsSpec) and settings.light_changes:
        phases = lights.obeyed(phases, settings)
    return _up_to_contact(phases, actor.value) if actor.approach else phases


def _without_way_out(actor: Actor, phases: list[Phase]) -> list[Phase]:
    """The phases without driving in the oncoming lane where it is there already, or its overtaking says so."""
    beyond = [q.action == "swerve" and q.target and q.side != "right" for q in phases]
    phases = [p for i, p in enumerate(phases) if p.action != "oncoming" or p.trigger or not (i and beyond[i - 1])]
    if 1 in actor.plan.offsets:
        return phases
    after = [*(p.action for p in phases[1:]), ""]
    return [p for i, p in enumerate(phases) if (p.action, after[i]) != ("oncoming", "overtake")]


def _stopping_before(actor: Actor, phases: list[Phase]) -> list[Phase]:
    """The phases, each stop for the junction at the line, each slowing down for a turn in time."""
    done: list[Phase] = []
    for i, phase in enumerate(phases):
        then = phases[i + 1] if i + 1 < len(phases) else None
        if i and done[-1].trigger == AT_LINE and phases[i - 1].trigger is None and _just_waits(phase) \
                and its_turn(actor):  # it stands there until then
            continue
        done.append(_stopping(actor, done, phase, then))
    return done


def _stopping(actor: Actor, before: list[Phase], phase: Phase, then: Phase | None) -> Phase:
    """A phase, as it is before a junction; `before`: those before it."""
    if phase.action == "brake" and phase.trigger is None and phase.speed and then and then.action in TURN:
        at = slows_before(actor.value, middle(phase.speed), middle(phase.rate or SLOWS_DOWN))
        return phase.model_copy(update={"trigger": at})
    stands_there = not before and actor.value <= 0
    if stands_there and actor.is_ego and phase.action == "stop" and then is not None:
        return phase.model_copy(update={"action": "stationary"})
    if stands_there and actor.sets_out and phase.action in AT_REST:
        return phase.model_copy(update={"action": "wait"})
    under_way = SETS_OFF & {p.action for p in before}  # it stops in the junction, not before it
    stands = phase.action == "stop" and not under_way or not before and actor.sets_out
    onward = then is not None and then.action in ONWARD
    if stands and phase.trigger is None and (onward or _before_junction(actor, [*before, phase])):
        return phase.model_copy(update={"action": "stop", "trigger": AT_LINE, "duration": None})
    return phase


def _obeying(actor: Actor, phases: list[Phase]) -> list[Phase]:
    """Ego's phases with its stop for a red light, or at a stop sign, where they do not say it."""
    actions = {p.action for p in phases}
    standing = actions & {"stop", "stationary"} or actor.value <= 0 and "wait" in actions
    if _red(actor) and "run_red" not in actions and not standing:
        return [*phases, Phase(action="stop", trigger=AT_LINE)]
    gives_way = actions & AT_SIGN or getattr(actor.spec, "reaction", "") == "yield" or actor.value <= 0
    if actor.plan.place.control == "stop" and not gives_way:
        stop = Phase(action="stop", trigger=AT_LINE)
        return [stop, Phase(action="wait", duration=1.0), Phase(action="start"), *phases]
    return phases


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

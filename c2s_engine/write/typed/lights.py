"""The traffic lights that road users come to: what ego's shows, and how that changes in the run."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, LightChange, ObjectSpec, Phase, SettingsSpec, Trigger
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import AT_REST, RAMP, TURN, is_static, is_vehicle
from c2s_engine.write.typed.watching import SECONDS, watched

FOR_ALL = {"flashing", "dark"}
"""What all lights of a junction show at once."""
HALTS = {"yellow", "red"}
"""What one stops for."""
BESIDE_EGO = ("ahead", "behind", "beside", "left_lane", "right_lane")
"""Where those start who come to the same light as ego."""
ACROSS = {"crossing_left", "crossing_right"}
"""Where those start who come to lights that show the opposite of ego's."""
NO_LIGHTS = {"motorway", *RAMP}
"""Kinds of places where nobody comes to a light."""


def changing(spec: SettingsSpec) -> bool:
    """Whether the light changes, or shows what those of all approaches show."""
    return bool(spec.light_changes) or spec.light in FOR_ALL


def of_all(structure: Structure, plan: Plan, spec: EgoSpec) -> list[str]:
    """The lights that everybody comes to: green, but ego's at its junction as S says or as what is done there asks."""
    settings, actions = structure.settings.spec, [p.action for p in spec.phases]
    if plan.place.kind in NO_LIGHTS or plan.ramp or not isinstance(settings, SettingsSpec):
        return []
    if changing(settings):
        return _changes(structure, plan, settings) if plan.place.control == "signal" else []
    crossing = any(position in ACROSS for position, _ in plan.ways_of_others)
    unregulated = "off" if crossing and plan.place.control is None else "green"
    shown = settings.light or ("red" if "run_red" in actions else unregulated)
    stop = next((i for i, a in enumerate(actions) if a in AT_REST), len(actions))
    goes_on = any(a in TURN or a in ("start", "accelerate") for a in actions[stop:])
    arguments = ["place.turn"] if plan.junction and (crossing or shown != "green" or plan.place.control) else []
    arguments += [f"'{shown}'" if arguments else f"shown='{shown}'"] if shown != "green" else []
    on_red = plan.place.manoeuvre == "right" and (spec.reaction == "yield" or "yield" in actions)
    waits = goes_on and not on_red and "run_red" not in actions
    if settings.light == "red" and waits and plan.place.control == "signal":
        arguments.append("turns_green=True")
    comment = f"ego's is {shown}" if arguments else "all are green"
    return [f"require monitor Lights({', '.join(arguments)})  # in CARLA: {comment}"]


def first(settings: SettingsSpec) -> str:
    """What it shows at the start: where S does not say it, what it can change from."""
    if settings.light is not None:
        return settings.light
    return "red" if settings.light_changes[0].to == "green" else "green"


def queued(structure: Structure) -> Structure:
    """S in which those on the approach of an ego that stands at its red light stand there as well, where nothing else
    is said of them."""
    settings, ego = structure.settings.spec, structure.ego.spec
    if getattr(settings, "light", None) != "red" or getattr(ego, "speed", None) != 0:
        return structure
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or not is_vehicle(spec.type) or spec.phases or spec.speed or spec.pace:
            continue
        if spec.placement.position in BESIDE_EGO and spec.placement.facing != "against":
            behind = spec.placement.position == "behind"
            does = Phase(action="follow", target="ego") if behind else Phase(action="wait")
            structure = structure.with_spec(component.id, speed=0.0, phases=(does,))
    return structure


def obeyed(phases: list[Phase], settings: SettingsSpec) -> list[Phase]:
    """The phases of one who comes to that light, with what it does for its changes: it stops where it still can, and
    goes on when it may."""
    found, shows = list(phases), first(settings)
    at = next((i for i, p in enumerate(found) if p.action in TURN), len(found))
    waits = shows == "red"
    if waits and not any(p.action in AT_REST for p in found):
        found.insert(at, Phase(action="stop", trigger=Trigger(kind="place", place="intersection", value=0)))
        at += 1
    for change in settings.light_changes:
        if change.to in HALTS and not waits:
            stop = next((i for i, p in enumerate(found) if p.action == "stop" and p.trigger is None), None)
            trigger = Trigger(kind="light", light=change.to)
            said = next((i for i, p in enumerate(found) if p.action == "stop" and p.trigger == trigger), None)
            if said is not None:
                at = said + 1
            elif stop is None:
                found.insert(at, Phase(action="stop", trigger=trigger))
                at += 1
            else:
                found[stop] = found[stop].model_copy(update={"trigger": trigger})
                at = stop + 1
            waits = True
        elif change.to == "green" and waits:
            if not any(p.action in ("start", "accelerate") and (p.trigger or i >= at) for i, p in enumerate(found)):
                found.insert(at, Phase(action="start", trigger=Trigger(kind="light", light="green")))
                at += 1
            waits = False
    return found


def _changes(structure: Structure, plan: Plan, settings: SettingsSpec) -> list[str]:
    shows, lines = first(settings), []
    for i, change in enumerate(settings.light_changes):
        change = _once_stopped(structure, change) if not i else change
        condition = watched(structure, plan, change.when, "E", "ego")
        if i and change.when.kind == "time" and change.when.value is None:  # as long after the change before it
            lines.append("    since = clock()")
            condition = f"clock() - since >= {SECONDS:g}"
        lines += [f"    while not ({condition}):", *_set(structure, shows), "        wait"]
        if change.when.delay is not None:
            lines += [
                "    since = clock()",
                f"    while clock() - since < {scope.quantity(change.when.delay)}:",
                *_set(structure, shows), "        wait",
            ]  # fmt: skip
        shows = change.to
    return _monitor([*lines, "    while True:", *_set(structure, shows), "        wait"])


def _once_stopped(structure: Structure, change: LightChange) -> LightChange:
    """A change to green at no stated moment: some seconds after ego, where it comes up to that light, has stopped."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    comes = ego.speed != 0 and any(p.action in AT_REST for p in ego.phases)
    if change.to != "green" or change.when.kind != "time" or change.when.value is not None or not comes:
        return change
    stopped = Trigger(kind="action", of="ego", action="stop", delay=change.when.delay or SECONDS)
    return change.model_copy(update={"when": stopped})


def _set(structure: Structure, state: str) -> list[str]:
    value = {"flashing": "'yellow' if clock() % 1 < 0.5 else 'off'", "dark": "'off'"}.get(state, f"'{state}'")
    if state not in FOR_ALL:
        return [f"        setClosestTrafficLightStatus(ego, {value})"]
    cars = [scope.reference(structure, c.id) for c in structure.objects if _drives(c.spec)]
    return [f"        setClosestTrafficLightStatus({car}, {value})" for car in ("ego", *cars)]


def _drives(spec: object) -> bool:
    return isinstance(spec, ObjectSpec) and is_vehicle(spec.type) and not is_static(spec)


def _monitor(lines: list[str]) -> list[str]:
    return ["", "monitor TrafficLight():", "    freezeTrafficLights()", *lines, "require monitor TrafficLight()"]

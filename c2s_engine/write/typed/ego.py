"""E: the ego vehicle and its behaviour."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec
from c2s_engine.write.typed import behaviour, meetings, reactions, scope
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.lanes import pulls_out
from c2s_engine.write.typed.order import STANDS
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import BLUEPRINTS, CLASS, RAMP, TURN
from c2s_engine.write.typed.threats import threatening
from c2s_engine.write.typed.usual import speed_of

ACROSS = {"crossing_left", "crossing_right"}
DEFAULT_MODEL = "vehicle.lincoln.mkz_2017"


def _start(spec: EgoSpec, said: EgoSpec) -> list[str]:
    """Where ego starts: in its lane, or at the kerb where it pulls out from there."""
    point = "place.lane.centerline.pointAlongBy(EGO_AT)"
    if not pulls_out(said):
        return [f"ego = new {CLASS[spec.type]} at {point},"]
    return [
        f"ego = new {CLASS[spec.type]} at beside(place.lane.rightEdge, place.lane, EGO_AT, 1.4),",
        "    facing heading_at(place.lane, EGO_AT),",
        "    with regionContainedIn everywhere,",
    ]


NO_LIGHTS = {"motorway", *RAMP}
"""Kinds of places where nobody comes to a light."""


def _lights(structure: Structure, plan: Plan, spec: EgoSpec) -> list[str]:
    """The lights that everybody comes to: green, but ego's at its junction as S says or as what is done there asks."""
    if plan.place.kind in NO_LIGHTS or plan.ramp:
        return []
    light, actions = getattr(structure.settings.spec, "light", None), [p.action for p in spec.phases]
    crossing = any(position in ACROSS for position, _ in plan.ways_of_others)
    unregulated = "off" if crossing and plan.place.control is None else "green"
    shown = light or ("red" if "run_red" in actions else unregulated)
    stop = next((i for i, a in enumerate(actions) if a in STANDS), len(actions))
    goes_on = any(a in TURN or a in ("start", "accelerate") for a in actions[stop:])
    arguments = ["place.turn"] if plan.junction and (crossing or shown != "green" or plan.place.control) else []
    arguments += [f"'{shown}'" if arguments else f"shown='{shown}'"] if shown != "green" else []
    if light == "red" and goes_on and plan.place.control == "signal" and "run_red" not in actions:
        arguments.append("turns_green=True")
    return [f"require monitor Lights({', '.join(arguments)})"]


def write_ego(structure: Structure, plan: Plan) -> str:
    said = spec = structure.ego.spec
    assert isinstance(said, EgoSpec) and isinstance(spec, EgoSpec)
    speed = speed_of(spec, plan.place)
    others = threatening(structure)
    spec = spec.model_copy(update={"phases": reactions.reacting_phases(spec, others, structure, plan)})
    actor = Actor(
        cid="E",
        spec=spec,
        structure=structure,
        plan=plan,
        line=meetings.way_of_ego(plan),
        lane=0,
        speed="EGO_SPEED",
        value=middle(speed),
        others=[scope.reference(structure, o) for o in others],
    )
    statements = behaviour.body(actor)
    statements = reactions.reaction(actor, statements)
    model = spec.model or (DEFAULT_MODEL if spec.type == "car" else BLUEPRINTS[spec.type][0])
    lines = [
        f"EGO_SPEED = {scope.quantity(speed)}  # m/s",
        "",
        "behavior EgoBehavior():",
        *(f"    {s}" for s in statements),
        "",
        *_start(spec, said),
        f"    with blueprint '{model}',",
        *(["    with regionContainedIn everywhere,"] if spec.type == "bus" and not pulls_out(said) else []),
        "    with behavior EgoBehavior()",
        *_lights(structure, plan, spec),
    ]
    return "\n".join(lines)

"""E: the ego vehicle and its behaviour."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec
from c2s_engine.write.typed import behaviour, lights, meetings, reactions, scope
from c2s_engine.write.typed.answers import reacting_phases
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.lanes import pulls_out
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import BLUEPRINTS, CLASS
from c2s_engine.write.typed.threats import threatening
from c2s_engine.write.typed.usual import speed_of

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


def write_ego(structure: Structure, plan: Plan) -> str:
    said = spec = structure.ego.spec
    assert isinstance(said, EgoSpec) and isinstance(spec, EgoSpec)
    speed = speed_of(spec, plan.place)
    others = threatening(structure)
    spec = spec.model_copy(update={"phases": reacting_phases(spec, others, structure, plan)})
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
        *lights.of_all(structure, plan, spec),
    ]
    return "\n".join(lines)

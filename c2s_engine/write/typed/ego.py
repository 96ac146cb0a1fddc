"""E: the ego vehicle and its behaviour."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec
from c2s_engine.write.typed import behaviour, scope
from c2s_engine.write.typed.plan import Plan, speed_of
from c2s_engine.write.typed.tables import BLUEPRINTS, CLASS

DEFAULT_MODEL = "vehicle.lincoln.mkz_2017"


def write_ego(structure: Structure, plan: Plan) -> str:
    spec = structure.ego.spec
    assert isinstance(spec, EgoSpec)
    speed = speed_of(spec, plan.place)
    others = behaviour.threatening(structure)
    spec = spec.model_copy(update={"phases": behaviour.reacting_phases(spec, others, plan)})
    actor = behaviour.Actor(
        cid="E",
        spec=spec,
        structure=structure,
        plan=plan,
        line="way(egoLane, egoTurn)" if plan.turning else "way(egoLane)",
        lane=0,
        speed="EGO_SPEED",
        value=middle(speed),
        others=[o.lstrip("*") + ("[0]" if o.startswith("*") else "") for o in others],
    )
    statements = behaviour.body(actor)
    actor.others = others
    statements = behaviour.reaction(actor, statements)
    model = spec.model or (DEFAULT_MODEL if spec.type == "car" else BLUEPRINTS[spec.type][0])
    lines = [
        f"EGO_SPEED = {scope.quantity(speed)}  # m/s",
        "",
        "behavior EgoBehavior():",
        *(f"    {s}" for s in statements),
        "",
        f"ego = new {CLASS[spec.type]} at egoLane.centerline.pointAlongBy(EGO_AT),",
        f"    with blueprint '{model}',",
        *(["    with regionContainedIn everywhere,"] if spec.type == "bus" else []),
        "    with behavior EgoBehavior()",
    ]
    return "\n".join(lines)

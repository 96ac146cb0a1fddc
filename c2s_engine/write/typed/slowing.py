"""How much ego slows down, and speeds up again, where S says what comes after and not how much."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.usual import speed_of

BELOW = 0.4
"""The share of the speed to which ego then speeds up again."""
A_LITTLE = 0.75
"""The share of its speed to which ego slows down that then brakes for another."""
SPARE = 2.5
"""m/s that are left to brake then."""
DROP, RATE = 10.0, 5.0
"""m/s from which one brakes with `RATE` m/s2 who then goes on."""
CYCLIST = (5.5, 6.5)
"""m/s at which ego drives, nobody says how fast, and a cyclist follows it; and at which that one can."""


def slowing(structure: Structure) -> Structure:
    """S with the speeds to which ego brakes and speeds up before what S says with a speed; behind ego, a cyclist keeps
    up."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    phases = _chained(ego.phases, middle(speed_of(ego, place)))
    if phases != ego.phases:
        structure = structure.with_spec("E", phases=phases)
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        follows = {p.action for p in spec.phases} == {"follow"} and spec.placement.position == "behind"
        if follows and spec.type == "bicycle" and ego.speed is None and spec.speed is None:
            structure = structure.with_spec("E", speed=CYCLIST[0]).with_spec(component.id, speed=CYCLIST[1])
    return structure


def _chained(phases: tuple[Phase, ...], speed: float) -> tuple[Phase, ...]:
    found = list(phases)
    for i in reversed(range(len(found) - 1)):
        phase, goal = found[i], found[i + 1].speed
        if phase.speed is not None or goal is None:
            continue
        then, after = found[i + 1].action, middle(goal)
        changes: dict[str, float] = {}
        if phase.action == "accelerate" and then == "collide":
            changes = {"speed": after}
        elif phase.action == "brake" and then == "accelerate":
            changes = {"speed": round(min(BELOW * after, speed / 2), 1)}
            if phase.rate is None and speed - changes["speed"] > DROP:
                changes["rate"] = RATE
        elif phase.action == "brake" and then == "collide" and speed > after + 2 * SPARE:
            changes = {"speed": round(max(after + SPARE, A_LITTLE * speed), 1)}
        found[i] = phase.model_copy(update=changes)
    return tuple(found)

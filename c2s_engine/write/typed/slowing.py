"""How much ego slows down, and speeds up again, where S says what comes after and not how much."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.stations import outwards
from c2s_engine.write.typed.tables import HALF_LANE
from c2s_engine.write.typed.usual import crosses, default_gap, far_side, pace_of, speed_of

BELOW = 0.4
"""The share of the speed to which ego then speeds up again."""
A_LITTLE = 0.75
"""The share of its speed to which ego slows down that then brakes for another."""
SPARE = 2.5
"""m/s that are left to brake then."""
DROP, RATE = 10.0, 5.0
"""m/s from which one brakes with `RATE` m/s2 who then goes on."""
NOTICED, GAINS, SPARE_TIME, HARDEST, APART = 0.4, 2.5, 0.3, 8.0, 3.0
"""s until ego brakes, m/s2 of gaining speed, s at that speed before the contact, m/s2 at most, m between the two."""
CYCLIST = (5.5, 6.5)
"""m/s at which ego drives, nobody says how fast, and a cyclist follows it; and at which that one can."""


def slowing(structure: Structure) -> Structure:
    """S with the speeds to which ego brakes and speeds up before what S says with a speed; behind ego, a cyclist keeps
    up."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    phases = _chained(ego.phases, middle(speed_of(ego, place)))
    if phases != ego.phases:
        structure = _second(structure.with_spec("E", phases=phases))
    for component in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        follows = {p.action for p in spec.phases} == {"follow"} and spec.placement.position == "behind"
        if follows and spec.type == "bicycle" and ego.speed is None and spec.speed is None:
            structure = structure.with_spec("E", speed=CYCLIST[0]).with_spec(component.id, speed=CYCLIST[1])
    return structure


def _second(structure: Structure) -> Structure:
    """With who crosses some seconds after another, for whom ego has slowed down, where ego is by then that has sped up
    again; ego brakes as hard as that takes."""
    ego, place = structure.ego.spec, structure.place.spec
    assert isinstance(ego, EgoSpec) and isinstance(place, PlaceSpec)
    actions = [p.action for p in ego.phases]
    at = next((i for i in range(len(actions)) if actions[i : i + 3] == ["brake", "accelerate", "collide"]), None)
    pair = _tied(structure, ego.phases[at + 2].target) if at is not None else None
    if at is None or pair is None:
        return structure
    (first, one), (cid, two) = pair
    trigger, top = two.phases[0].trigger, middle(speed_of(ego, place))
    low, goal = (middle(ego.phases[k].speed or top) for k in (at, at + 1))
    contact = middle((trigger.delay if trigger else None) or 0.0) + _seconds(two, place)
    gaining = (goal - low) / GAINS
    rate = min(max((top - low) / max(contact - NOTICED - gaining - SPARE_TIME, 0.1), RATE), HARDEST)
    braking = (top - low) / rate
    rest = max(contact - NOTICED - braking - gaining, 0.0)
    gone = top * NOTICED + (top + low) / 2 * braking + (low + goal) / 2 * gaining + goal * rest
    gap = one.placement.gap if one.placement.gap is not None else round(default_gap(one, top, place), 1)
    beyond = gone - top * _seconds(one, place)
    beyond = beyond if abs(beyond) > APART else APART if beyond > 0 else -APART
    phases = (*ego.phases[:at], ego.phases[at].model_copy(update={"rate": round(rate, 1)}), *ego.phases[at + 1 :])
    placed = {first: (one, gap), cid: (two, round(middle(gap) + beyond, 1))}
    for who, (spec, metres) in placed.items():
        placement = spec.placement.model_copy(update={"gap": metres})
        structure = structure.with_spec(who, placement=placement)
    return structure.with_spec("E", phases=phases)


def _tied(structure: Structure, cid: str | None) -> tuple[tuple[str, ObjectSpec], tuple[str, ObjectSpec]] | None:
    """Who sets out first, and who is hit that sets out after it, nobody says where."""
    spec = structure[cid].spec if cid and cid in structure else None
    trigger = spec.phases[0].trigger if isinstance(spec, ObjectSpec) and spec.phases else None
    first = trigger.of if trigger and trigger.kind == "action" else None
    other = structure[first].spec if first and first in structure else None
    if not isinstance(spec, ObjectSpec) or not isinstance(other, ObjectSpec) or trigger is None or not cid:
        return None
    open_ = spec.placement.gap is None and not spec.placement.hidden_by and not other.placement.hidden_by
    return ((str(first), other), (cid, spec)) if open_ and crosses(spec) and crosses(other) else None


def _seconds(spec: ObjectSpec, place: PlaceSpec) -> float:
    """How long somebody takes from beside the road to the middle of ego's lane."""
    metres = outwards(spec) + HALF_LANE + (2 * HALF_LANE if far_side(spec, place) else 0.0)
    return metres / max(middle(pace_of(spec)), 0.5)


def _chained(phases: tuple[Phase, ...], speed: float) -> tuple[Phase, ...]:
    found = list(phases)
    for i in reversed(range(len(found) - 1)):
        phase, goal = found[i], found[i + 1].speed
        if phase.speed is not None or goal is None or found[i + 1].trigger is not None:
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

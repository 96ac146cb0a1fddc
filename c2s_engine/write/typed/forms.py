"""One form for each thing that S can say in several: positions that the place or a manoeuvre turns into others."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed import lights
from c2s_engine.write.typed.alongside import beside_ego
from c2s_engine.write.typed.facing import facing
from c2s_engine.write.typed.hiding import standing
from c2s_engine.write.typed.passing import passing
from c2s_engine.write.typed.pockets import own_ways
from c2s_engine.write.typed.sequence import in_sequence
from c2s_engine.write.typed.slowing import slowing
from c2s_engine.write.typed.tables import APPROACH_ANGLE, AT_REST, OBSTRUCTING, TURN, is_static, is_vehicle, is_walker
from c2s_engine.write.typed.threats import IN_WAY, passed_over
from c2s_engine.write.typed.usual import crosses, uses_crosswalk
from c2s_engine.write.typed.waiting import coming_by, together

AVOIDS = {"brake", "stop", "swerve", "lane_change", "collide"}
"""What somebody does about, or to, what lies in its way."""


def normal(structure: Structure) -> Structure:
    """S as the writer reads it."""
    structure = own_ways(beside_ego(coming_by(together(in_sequence(slowing(lights.queued(structure)))))))
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    if place.kind in ("road", "straight") and place.crosswalk and any(map(uses_crosswalk, _objects(structure))):
        place = place.model_copy(update={"kind": "crosswalk"})
    stops = tuple(_for_whom(p, ego, structure) for p in ego.phases[:-1])
    structure = structure.with_spec("E", phases=(*stops, *ego.phases[-1:]))
    turn = _turn(place, ego)
    for component in structure.objects:
        spec = component.spec
        if isinstance(spec, ObjectSpec) and spec.type in OBSTRUCTING and _in_the_way(component.id, structure):
            high = spec.model_copy(update={"model": spec.model or OBSTRUCTING[spec.type]})
            structure = structure.with_spec(component.id, high)
        if not isinstance(spec, ObjectSpec) or not is_vehicle(spec.type) or is_static(spec):
            continue
        found = spec
        if _meets_turning(spec, place, turn):
            found = _placed(spec, position="opposite_approach", along=None, gap=None)
            place = place.model_copy(update={"oncoming": place.oncoming is not False or None})
        elif _leaves_side_road(spec, place, turn):
            found = spec.model_copy(update={"phases": _with_turn(spec.phases)})
        if spec.placement.position in APPROACH_ANGLE and spec.phases and spec.phases[0].action in AT_REST:
            found = found.model_copy(update={"phases": tuple(map(_in_time, found.phases))})
        if found is not spec:
            structure = structure.with_spec(component.id, found)
    if place is not structure.place.spec:
        structure = structure.with_spec("R", place)
    return facing(passing(standing(structure), place), place)


def _in_time(phase: Phase) -> Phase:
    """What one who stands at its line does as ego is near, nobody says how near: it follows from when they meet."""
    t = phase.trigger
    open_ = t is not None and t.kind in ("distance", "ttc") and t.value is None and t.subject is None
    return phase.model_copy(update={"trigger": None}) if open_ and t.of in (None, "ego") else phase  # type: ignore


def _for_whom(phase: Phase, ego: EgoSpec, structure: Structure) -> Phase:
    """A stop of ego's, where S says neither before whom nor where, and drives on after it, is one before who crosses
    and ego reacts to."""
    open_ = phase.action == "stop" and not (phase.target or phase.trigger)
    other = structure[ego.react_to].spec if open_ and ego.react_to and ego.react_to in structure else None
    if isinstance(other, ObjectSpec) and crosses(other) and is_walker(other):
        return phase.model_copy(update={"target": ego.react_to})
    return phase


def _objects(structure: Structure) -> list[ObjectSpec]:
    return [c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)]


def _in_the_way(cid: str, structure: Structure) -> bool:
    """Whether somebody hits what lies there, or ego has to do something about it."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    if passed_over(structure, cid):
        return False
    others = [p for o in _objects(structure) for p in o.phases]
    if any(p.target == cid and p.action in AVOIDS for p in (*ego.phases, *others)):
        return True
    answers = ego.reaction in ("brake", "evade") or any(p.action in AVOIDS and p.target is None for p in ego.phases)
    return answers and spec.placement.position in IN_WAY and ego.react_to in (None, cid)


def _turn(place: PlaceSpec, ego: EgoSpec) -> str | None:
    """Ego's manoeuvre at the junction: what R says, else what ego does."""
    of = {"turn_left": "left", "turn_right": "right", "u_turn": "u_turn"}
    done = next((of[p.action] for p in ego.phases if p.action in of), None)
    return place.manoeuvre or (done if place.kind in ("road", "intersection") else None)


def _meets_turning(spec: ObjectSpec, place: PlaceSpec, turn: str | None) -> bool:
    """Whether an oncoming driver's way crosses ego's at the junction, as one of the two turns there."""
    if place.kind not in ("road", "intersection") or spec.placement.position != "oncoming_lane":
        return False
    own = any(p.action in ("turn_left", "turn_right") for p in spec.phases)
    return spec.placement.of == "ego" and (own or turn == "left")


def _leaves_side_road(spec: ObjectSpec, place: PlaceSpec, turn: str | None) -> bool:
    """Whether somebody, nobody says how, comes out of the side road that ego passes: it cannot but turn."""
    if place.kind != "intersection" or place.arms != 3 or turn not in (None, "straight"):
        return False
    named = any(p.action in TURN for p in spec.phases)
    return spec.placement.position in ("crossing_left", "crossing_right") and not named


def _with_turn(phases: tuple[Phase, ...]) -> tuple[Phase, ...]:
    """Some phases with a turn to the left, across ego's way, before what ends there."""
    at = next((i for i, p in enumerate(phases) if p.action == "collide"), len(phases))
    return (*phases[:at], Phase(action="turn_left"), *phases[at:])


def _placed(spec: ObjectSpec, **changes: object) -> ObjectSpec:
    return spec.model_copy(update={"placement": spec.placement.model_copy(update=changes)})

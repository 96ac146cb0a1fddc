"""Riders and vehicles side by side before a junction, of whom one turns across the other's way."""

from c2s_engine.maps.expressions import MANOEUVRE_TYPE
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec, Trigger
from c2s_engine.write.typed.tables import DEFAULT_SPEED, TURN, WIDTH, is_static, is_vehicle
from c2s_engine.write.typed.usual import slows_before, speed_of, turn_of

RIDERS = {"bicycle", "motorcycle"}
BESIDE = {"beside", "left_lane", "right_lane", "behind", "roadside", "partly_in_lane"}
LATERAL = 1.0
"""m between the two across the road, where nothing says how far."""
SLOWER, SLOWLY = 0.85, 0.7
"""How fast ego comes up to its turn with a rider beside it, of that one's speed, where nothing says how fast; how fast
it still is then, where the rider comes from behind."""
EARLY, COMES = 12, 8.3
"""m before the intersection by which ego is as slow as that, and m/s at most at which it comes there."""
COMES_UP = 6.5
"""m/s of a rider who comes up to ego from behind, where nothing says how fast."""
TURNS_AT = 4.5
"""m/s to which one slows that turns across a rider's way, where nothing says how fast it turns."""
OVERTAKES = 3.0
"""m/s by which one is faster than the rider that it gets past before its turn."""


def offset(spec: ObjectSpec, ego: EgoSpec, place: PlaceSpec) -> float:
    """m to the left of ego's way at which one rides or drives beside it up to a turn of one of the two across the
    other's way; 0: it does not."""
    at, own = spec.placement, turn_of(spec.phases)
    if place.kind not in ("road", "intersection") or at.of != "ego" or at.position not in BESIDE or is_static(spec):
        return 0.0
    if not is_vehicle(spec.type) or not RIDERS & {spec.type, ego.type} or at.facing == "against":
        return 0.0
    ego_turn = MANOEUVRE_TYPE[place.manoeuvre] if place.manoeuvre else turn_of(ego.phases)
    side = {"RIGHT_TURN": -1, "LEFT_TURN": 1}.get(ego_turn, 0) if own == "STRAIGHT" else 0
    if ego_turn == "STRAIGHT":
        side = {"RIGHT_TURN": 1, "LEFT_TURN": -1}.get(own, 0)
    said = {"left_lane": 1, "right_lane": -1}.get(at.position, {"left": 1, "right": -1}.get(str(at.side), side))
    if not side or said != side:
        return 0.0
    if at.position == "partly_in_lane" and at.lateral is None:  # it is where that says
        return 0.0
    lateral = middle(at.lateral) if at.lateral is not None else LATERAL
    return round(side * ((WIDTH[spec.type] + WIDTH[ego.type]) / 2 + lateral), 2)


def beside_ego(structure: Structure) -> Structure:
    """S where those who come up beside ego to a turn of one of the two are in ego's lane or at its edge, as fast as it
    takes to be there together."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or not (aside := offset(spec, ego, place)):
            continue
        if spec.placement.position in ("left_lane", "right_lane") and ego.type in RIDERS:  # room to get past
            room = {"lanes": max(place.lanes or 1, 2), "ego_lane": place.ego_lane or "rightmost"}
            place = place.model_copy(update=room)
            structure = structure.with_spec("R", place)
        if spec.type == "bicycle" and spec.speed is None and _from_behind(spec) and _slows_for_turn(ego):
            spec = spec.model_copy(update={"speed": COMES_UP})
        structure = structure.with_component(_placed(component, spec, ego, aside))
        if spec.type in RIDERS and (changes := _let_up(spec, ego, place)):
            ego = ego.model_copy(update=changes)
            structure = structure.with_spec("E", ego)
    return structure


def _let_up(spec: ObjectSpec, ego: EgoSpec, place: PlaceSpec) -> dict[str, object]:
    """How ego drives so that a rider comes up to it: as slowly as that takes, or slowing down in time for its turn."""
    rides = middle(spec.speed) if spec.speed is not None else DEFAULT_SPEED[spec.type]["road"]
    if _from_behind(spec) and _slows_for_turn(ego):
        own, slow = min(middle(speed_of(ego, place)), COMES), round(SLOWLY * rides, 1)
        own = own if ego.speed is None else middle(ego.speed)
        near = EARLY + middle(slows_before(own, slow).value or 0.0)
        there = Trigger(kind="place", place="intersection", value=round(near))
        slower = Phase(action="brake", speed=slow, trigger=there)
        return {"speed": own, "phases": (slower, *ego.phases)} if own > rides else {}
    return {"speed": round(SLOWER * rides, 1)} if ego.speed is None else {}


def _from_behind(spec: ObjectSpec) -> bool:
    return "behind" in (spec.placement.position, spec.placement.along)


def _slows_for_turn(ego: EgoSpec) -> bool:
    """Whether nothing but its turn, or who comes up to it, makes ego slow down."""
    calm = {"keep_lane", "brake", "collide", *TURN} >= {p.action for p in ego.phases}
    return calm and all(p.trigger is None and p.speed is None for p in ego.phases) and ego.speed != 0


def pulls_out(spec: ObjectSpec) -> bool:
    """Whether one that comes by beside ego comes from behind it in its lane, and pulls out for that."""
    return spec.placement.position == "behind"


def _placed(component: Component, spec: ObjectSpec, ego: EgoSpec, aside: float) -> Component:
    passes = any(p.action == "overtake" for p in spec.phases)
    where: dict[str, object] = {}
    if not pulls_out(spec):
        where = {"position": "partly_in_lane", "side": "left" if aside > 0 else "right", "along": "behind",
                 "lateral": spec.placement.lateral if spec.placement.lateral is not None else LATERAL}  # fmt: skip
    changes: dict[str, object] = {"placement": spec.placement.model_copy(update=where)}
    phases = tuple(p for p in spec.phases if p.action not in ("overtake", "keep_lane", "follow"))
    goes = () if any(p.action in TURN for p in phases) else (Phase(action="go_straight"),)
    if spec.speed is None and passes and ego.speed is not None:
        changes["speed"] = round(middle(ego.speed) + OVERTAKES, 1)
    own = middle(changes.get("speed") or spec.speed or 0.0)  # type: ignore[arg-type]
    if own > TURNS_AT and turn_of(phases) != "STRAIGHT" and all(p.speed is None for p in phases):
        phases = tuple(p.model_copy(update={"speed": TURNS_AT}) if p.action in TURN else p for p in phases)
        phases = (Phase(action="brake", speed=TURNS_AT, trigger=slows_before(own, TURNS_AT)), *phases)
    changes["phases"] = (*phases, *goes)
    return component.model_copy(update={"spec": spec.model_copy(update=changes)})


def other_ways(structure: Structure, place: PlaceSpec, lane_of: dict[str, int | None]) -> tuple[str, ...]:
    """The manoeuvre types, other than ego's, by which those beside ego, or who are in its lane by then, leave that."""
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    found = set()
    for component in structure.objects:
        spec, lane = component.spec, lane_of.get(component.id)
        assert isinstance(spec, ObjectSpec)
        steps = {"right": -1, "left": 1, None: 1}
        for phase in spec.phases:
            if lane is not None and phase.action in ("lane_change", "cut_out"):
                lane += steps[phase.side]
            lane = 0 if lane is not None and phase.action == "cut_in" else lane
        own = place.kind == "intersection" and lane == 0 and any(p.action in TURN for p in spec.phases)
        if own or offset(spec, ego, place):
            found.add(turn_of(spec.phases))
    return tuple(sorted(found - {MANOEUVRE_TYPE.get(place.manoeuvre or "")}))


"""One form for each thing that S can say in several: positions that the place or a manoeuvre turns into others."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.alongside import beside_ego
from c2s_engine.write.typed.facing import facing
from c2s_engine.write.typed.hiding import standing
from c2s_engine.write.typed.lanes import pulls_out
from c2s_engine.write.typed.passing import passing
from c2s_engine.write.typed.pockets import own_ways
from c2s_engine.write.typed.tables import APPROACH_ANGLE, LENGTH, OBSTRUCTING, TURN, is_static, is_vehicle
from c2s_engine.write.typed.threats import IN_WAY, is_hit, passed_over
from c2s_engine.write.typed.usual import default_gap, speed_of

BEYOND = 15
"""m from whom ego runs into to what stands further on."""
PASSES_IN = 3.0
"""s that somebody who comes along the road is away from where ego comes onto it."""
AVOIDS = {"brake", "stop", "swerve", "lane_change", "collide"}
"""What somebody does about, or to, what lies in its way."""


def normal(structure: Structure) -> Structure:
    """S as the writer reads it."""
    structure = own_ways(beside_ego(structure))
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
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
        elif _passes_where_ego_comes_out(component.id, spec, ego):
            hits = [p for p in spec.phases if p.action == "collide"] or [Phase(action="collide", target="ego")]
            found = _placed(spec, position="behind", gap=round(PASSES_IN * max(middle(speed_of(spec, place)), 5)))
            found = found.model_copy(update={"phases": tuple(hits)})
        elif _met_in_turn(component.id, spec, ego, turn):
            found = spec.model_copy(update={"phases": (*spec.phases, Phase(action="collide", target="ego"))})
        elif _is_let_by(component.id, spec, ego):
            found = spec.model_copy(update={"phases": (Phase(action="overtake", target="ego"),)})
        if found is not spec:
            structure = structure.with_spec(component.id, found)
    if place is not structure.place.spec:
        structure = structure.with_spec("R", place)
    structure = _struck_first(passing(standing(structure), place), ego)
    return facing(structure, place)


def _struck_first(structure: Structure, ego: EgoSpec) -> Structure:
    """What stands in ego's lane beyond whom ego runs into there, where nothing says what comes first."""
    ahead = [c for c in structure.objects if isinstance(c.spec, ObjectSpec) and _open_ahead(c.spec)]
    hit = next((c.id for c in ahead if is_hit(ego, c.id)), None)
    if hit is None or any(p.action not in ("collide", "brake", "accelerate", "keep_lane") for p in ego.phases):
        return structure
    struck = structure[hit].spec
    assert isinstance(struck, ObjectSpec)
    beyond = default_gap(struck, middle(ego.speed or 0)) + struck.count * (LENGTH[struck.type] + 3) + BEYOND
    for c in ahead[: [c.id for c in ahead].index(hit)]:
        assert isinstance(c.spec, ObjectSpec)
        if is_static(c.spec):
            structure = structure.with_spec(c.id, _placed(c.spec, gap=round(beyond)))
    return structure


def _open_ahead(spec: ObjectSpec) -> bool:
    """Whether an object is ahead in ego's lane, nobody says how far."""
    at = spec.placement
    return at.position == "ahead" and at.of == "ego" and at.gap is None and at.hidden_by is None


def _in_the_way(cid: str, structure: Structure) -> bool:
    """Whether somebody hits what lies there, or ego has to do something about it."""
    spec, ego = structure[cid].spec, structure.ego.spec
    assert isinstance(spec, ObjectSpec) and isinstance(ego, EgoSpec)
    if passed_over(structure, cid):
        return False
    others = [p for c in structure.objects if isinstance(c.spec, ObjectSpec) for p in c.spec.phases]
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


def _passes_where_ego_comes_out(cid: str, spec: ObjectSpec, ego: EgoSpec) -> bool:
    """Whether somebody who drives along the road collides with ego, which comes onto it from beside it."""
    collides = is_hit(ego, cid) or any(p.action == "collide" and p.target in (None, "ego") for p in spec.phases)
    plain = {p.action for p in spec.phases} <= {"collide", "keep_lane", "go_straight", "move_along"}
    return pulls_out(ego) and collides and plain and _open_ahead(spec) and spec.placement.facing is None


def _met_in_turn(cid: str, spec: ObjectSpec, ego: EgoSpec, turn: str | None) -> bool:
    """Whether ego runs, in its turn, into one that goes straight on over the junction: both drive at each other."""
    actions = [p.action for p in ego.phases]
    after = "turn_left" in actions and "collide" in actions[actions.index("turn_left") :]
    if turn != "left" or not after or not is_hit(ego, cid) or spec.placement.position not in APPROACH_ANGLE:
        return False
    return {p.action for p in spec.phases} <= {"go_straight", "keep_lane", "run_red", "run_stop", "move_along"}


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


def _is_let_by(cid: str, spec: ObjectSpec, ego: EgoSpec) -> bool:
    """Whether ego makes way for one that comes up behind it in its lane: that one then goes by."""
    stays = not any(p.action in ("lane_change", "cut_out") for p in ego.phases)
    let_by = ego.reaction == "yield" and ego.react_to == cid
    let_by = let_by or any(p.action == "yield" and p.target == cid for p in ego.phases)
    return let_by and spec.placement.position == "behind" and stays and not spec.phases


def _placed(spec: ObjectSpec, **changes: object) -> ObjectSpec:
    return spec.model_copy(update={"placement": spec.placement.model_copy(update=changes)})

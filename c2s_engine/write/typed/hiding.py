"""What hides somebody who crosses: where it stands, when and how far off, and where who is hidden by it stands."""

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec
from c2s_engine.write.typed import scope, stations
from c2s_engine.write.typed.beside import beside_road
from c2s_engine.write.typed.course import EDGE, HALF_LANE
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.spot import Spot, member
from c2s_engine.write.typed.stations import RIGHT_BEHIND
from c2s_engine.write.typed.tables import (
    LANE_WIDTH,
    LENGTH,
    MOVES_OFF_ROAD,
    NEXT_LANES,
    WIDTH,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.usual import (
    CLOSEST,
    NOSE_TO_TAIL,
    crosses,
    has_marking,
    pace_of,
    reach,
    row_length,
    speed_of,
    while_crossing,
)

OUT = 0.15
"""m beside a lane of one who is just out of it."""
FACES_EGO = {"oncoming_lane", "opposite_approach"}


def hidden(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    """Right behind what hides it, as ego sees it: at its front, or at the tail of what faces ego; one who crosses
    before what stands in a lane is just out of that lane, or beside the road where that is the next lane, or where it
    stands across. One who comes from a row stands between its last two (`stations.between`)."""
    by = spec.placement.hidden_by or "ego"
    what = _spec(structure, by)
    across = what.placement.facing == "across" and what.placement.position in MOVES_OFF_ROAD and what.count == 1
    if crosses(spec) and (across or what.placement.position in NEXT_LANES):
        return beside_road(structure, cid, spec, plan)
    hider = scope.reference(structure, by).replace("[0]", "[-1]")  # of a row the last
    left, front = spec.placement.side == "left", not faces_ego(structure, by)
    clear = RIGHT_BEHIND + stations.past_others(structure, cid)
    gap = scope.number(clear)
    where = f"{'ahead of' if front else 'behind'} {hider} by {member(spec, gap)}"
    if crosses(spec) and (off := _out_of_lane(structure, by, plan)):
        beyond = member(spec, f"{hider}.length / 2 + {scope.number(clear + LENGTH[spec.type] / 2)}")
        sideways = scope.number(-off if left == front else off)
        where = f"at {hider} offset by {sideways} @ {'' if front else '-'}({beyond})"
    elif stations.between(structure, spec):
        deep, short = _deep(structure, cid, by, plan), -stations.past_last(structure, spec)
        sideways = scope.number(deep if left == front else -deep)
        where = f"at {hider} offset by {sideways} @ {'-' if front else ''}{scope.number(short)}"
    elif deep := _deep(structure, cid, by, plan):  # near its face
        beyond = member(spec, f"{hider}.length / 2 + {scope.number(clear + LENGTH[spec.type] / 2)}")
        sideways = scope.number(deep if left == front else -deep)
        where = f"at {hider} offset by {sideways} @ {'' if front else '-'}({beyond})"
    angle = "-90 deg" if left == front else "90 deg"
    if spec.phases and spec.phases[0].action == "move_along":  # as the road goes
        angle = "180 deg" if front == (spec.placement.facing == "against") else "0 deg"
    specifiers = (where, f"facing {angle} relative to {hider}", "with regionContainedIn everywhere")
    return Spot((), specifiers, "straight_on(self)", off_road=True)


def _deep(structure: Structure, cid: str, by: str, plan: Plan) -> float:
    """How far (m) from the middle of what hides it, towards the road, one starts."""
    near = WIDTH[_spec(structure, by).type] / 2 - stations.inside(_spec(structure, by))
    return round(near - stations.set_back(structure, cid, plan), 2)


def _spec(structure: Structure, cid: str) -> ObjectSpec:
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    return spec


def faces_ego(structure: Structure, cid: str) -> bool:
    """Whether something looks towards ego, so that what it hides is at its tail."""
    spec = structure[cid].spec
    at = spec.placement if isinstance(spec, ObjectSpec) else None
    return at is not None and (at.position in FACES_EGO or at.facing == "against")


def aside(structure: Structure, cid: str, plan: Plan) -> float:
    """How far (m) to the left of the middle of its lane something starts: what hides somebody stands near the kerb."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    left = 1 if spec.placement.side == "left" or spec.placement.side is None and plan.lane_of[cid] else -1
    if spec.placement.lateral is not None:  # from the middle of the lane of whom it is placed by
        other = structure.ego.spec if spec.placement.of == "ego" else structure[spec.placement.of].spec
        between = (WIDTH[getattr(other, "type", "car")] + WIDTH[spec.type]) / 2 + middle(spec.placement.lateral)
        lanes = (plan.lane_of[cid] or 0) - (plan.lane_of.get(spec.placement.of) or 0)
        return round(left * between - LANE_WIDTH * lanes, 2)
    if spec.placement.position == "partly_in_lane":
        return EDGE if spec.placement.side == "left" else -EDGE
    if spec.placement.position != "ahead":
        return 0.0
    who = stations.hides(structure, cid)
    return to_kerb(structure, cid) if who is not None and who.placement.side == "left" else -to_kerb(structure, cid)


def to_kerb(structure: Structure, cid: str) -> float:
    """How far (m) from the middle of its lane, towards whom it hides at the kerb, something stands."""
    spec, who = _spec(structure, cid), stations.hides(structure, cid)
    there = ("ahead",) if who is None or who.placement.side != "left" else ("ahead", "oncoming_lane")
    if who is None or not is_static(spec) or spec.placement.position not in there:
        return 0.0
    return round(max(0.0, HALF_LANE + OUT - WIDTH[spec.type] / 2), 2)


def _out_of_lane(structure: Structure, cid: str, plan: Plan) -> float:
    """How far (m) beside something that stands in a lane one is who is just out of it; 0: it is not there."""
    spec = structure[cid].spec
    if not isinstance(spec, ObjectSpec) or spec.placement.position not in ("ahead", "partly_in_lane", "oncoming_lane"):
        return 0.0
    return round(HALF_LANE + OUT - abs(aside(structure, cid, plan) or to_kerb(structure, cid)), 2)


def standing(structure: Structure) -> Structure:
    """S with those standing from the first who come out from beside the road or hide somebody: these so far off that
    ego is there no sooner than whom they hide."""
    place, ego = structure.place.spec, structure.ego.spec
    assert isinstance(place, PlaceSpec) and isinstance(ego, EgoSpec)
    for component in structure.objects:
        spec, who = component.spec, stations.hides(structure, component.id)
        if isinstance(spec, ObjectSpec) and (rests := _from_rest(spec)) is not spec:
            structure = structure.with_spec(component.id, rests)
            spec = rests
        if isinstance(spec, ObjectSpec) and stations.hides_beside(structure, spec) is not None and _open(spec):
            structure = structure.with_spec(component.id, placement=_beyond(spec))
        if who is None or not isinstance(spec, ObjectSpec):
            continue
        if spec.phases and spec.phases[0].action == "stop":
            spec = spec.model_copy(update={"speed": 0.0, "phases": (Phase(action="stationary"), *spec.phases[1:])})
        speed = middle(speed_of(ego, place))
        seen = who.model_copy(update={"placement": who.placement.model_copy(update={"hidden_by": None})})
        pace = max(middle(pace_of(who)), 0.8)
        least = (
            while_crossing(seen, speed, place)
            + (stations.way_out(structure, who, place) - reach(who, place)) / pace * speed
        )
        if spec is not component.spec:
            structure = structure.with_spec(component.id, spec)
        first, beyond = _row_of(structure, component.id)
        if stations.between(structure, who):
            beyond += stations.past_last(structure, who) - LENGTH[spec.type] / 2
        marked = has_marking(place) and is_walker(who) and spec.placement.facing != "across"  # it stands before that
        off_road = spec.placement.position in MOVES_OFF_ROAD and not marked
        if off_road and first.spec.placement.gap is None:  # type: ignore[union-attr]
            gap = max(float(round(least - beyond)), NOSE_TO_TAIL)
            placed = first.spec.placement.model_copy(update={"gap": gap})  # type: ignore[union-attr]
            changed = first.spec.model_copy(update={"placement": placed})
            structure = structure.with_spec(first.id, changed)
    return structure


def _open(spec: ObjectSpec) -> bool:
    """Whether nobody says how far ahead of ego it starts."""
    return spec.placement.of == "ego" and spec.placement.gap is None and spec.placement.along in (None, "ahead")


def _beyond(spec: ObjectSpec) -> Placement:
    """Where a vehicle starts that something beside the road hides: next to that, and in a driveway if it backs out."""
    at = spec.placement
    backs = at.position != "parked" and any(p.action == "reverse" for p in spec.phases[:1])
    facing = "across" if backs and at.facing is None else at.facing
    return at.model_copy(update={"of": at.hidden_by, "along": "ahead", "gap": CLOSEST, "facing": facing})


def _from_rest(spec: ObjectSpec) -> ObjectSpec:
    """A vehicle that pulls out from beside the road or backs out of there stands until then."""
    first = spec.phases[0] if spec.phases else None
    comes = first is not None and first.action in ("enter_road", "reverse") and is_vehicle(spec.type)
    drives = spec.speed or spec.speed is None and first is not None and first.trigger is not None
    if first is None or not comes or not drives or crosses(spec) or spec.placement.position not in MOVES_OFF_ROAD:
        return spec
    moves = first.model_copy(update={"speed": first.speed if first.speed is not None else spec.speed})
    return spec.model_copy(update={"speed": 0.0, "phases": (moves, *spec.phases[1:])})


def _row_of(structure: Structure, cid: str) -> tuple[Component, float]:
    """The first of those that stand one by the other up to an object, and how far (m) it is from its rear to the front
    of that object."""
    component, reached = structure[cid], 0.0
    for _ in structure.objects:
        spec = component.spec
        assert isinstance(spec, ObjectSpec)
        reached += row_length(spec)
        if spec.placement.of == "ego":
            break
        reached += middle(spec.placement.gap) if spec.placement.gap is not None else NOSE_TO_TAIL
        component = structure[spec.placement.of]
    return component, reached

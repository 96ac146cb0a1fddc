"""Where an object starts beside the road, as Scenic: outwards from the edge of the lanes nearest to a point of one."""

from collections.abc import Sequence
from dataclasses import replace

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import scope, stations
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.spot import Spot, measured, member, position_constant
from c2s_engine.write.typed.tables import (
    AT_REST,
    LENGTH,
    MOVES_OFF_ROAD,
    NEXT_LANES,
    RAMP,
    WIDTH,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.usual import at_corner, has_marking, right_behind, row_step, uses_crosswalk, walks_first

SHORT_OF_CROSSWALK = 4.0
"""m from the middle of a crosswalk to what stands in a lane before it."""


def behind_junction(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    """Where ego leaves the junction: on that lane, those on foot and riders at its edge."""
    at = position_constant(structure, cid)
    line = f"{at} = {scope.quantity(stations.exit_gap(spec, plan))}  # m behind the junction"
    if stations.near_exit(spec):
        return _edge(spec, [line], member(spec, at), "place.exit_lane", plan)
    return Spot((line,), (f"at place.exit_lane.centerline.pointAlongBy({member(spec, at)})",), "route(place.exit_lane)")


def beside_road(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    """At the kerb, on the verge or on the sidewalk along ego's lane."""
    sign, of = stations.along(spec), spec.placement.of
    at = position_constant(structure, cid)
    if hides := before_crosswalk(structure, cid, plan):
        lines = [hides]
    elif (uses_crosswalk(spec) or right_behind(spec)) and (marked := crosswalk(plan)):
        beside = stations.next_to(structure, cid)
        off = f" {'+' if beside > 0 else '-'} {scope.number(abs(beside))}" if beside else ""
        lines = [f"{at} = {marked}{off}"]
    elif right_behind(spec):  # of what stands in the next lane, or across beside the road
        by = structure[spec.placement.hidden_by or "ego"].spec
        assert isinstance(by, ObjectSpec)
        long = (WIDTH if by.placement.facing == "across" else LENGTH)[by.type]
        beyond = round((long + LENGTH[spec.type]) / 2 + stations.RIGHT_BEHIND + stations.past_others(structure, cid), 2)
        lines = [f"{at} = {position_constant(structure, spec.placement.hidden_by or 'ego')} + {scope.number(beyond)}"]
    elif at_corner(spec, plan.place):
        return _corner(structure, spec, at, plan)
    elif sign == 0 and stations.stands_there(structure, of):  # just in front of what takes the spot itself
        clear = scope.number(stations.clear_of(structure, spec))
        lines = [f"{at} = {position_constant(structure, of)} + {clear}"]
    elif sign == 0:
        away = stations.from_hider(structure, of)
        off = f" + {scope.number(away)}" if away else ""
        lines = [f"{at} = {position_constant(structure, stations.base(structure, of, plan))}{off}"]
    else:
        lines = measured(structure, cid, spec, plan, sign)
    in_file = spec.count > 1 and uses_crosswalk(spec) and crosswalk(plan)
    along = at if in_file else member(spec, at, sign or 1)
    back = stations.set_back(structure, cid, plan)
    if stations.parked_in_way(structure, cid):
        back = WIDTH[spec.type] / 2 - stations.INTO_LANE - stations.outwards(spec)
        if spec.placement.side == "left" and spec.placement.facing is None:  # as those go who come by there
            spec = spec.model_copy(update={"placement": spec.placement.model_copy(update={"facing": "against"})})
    spot = _edge(spec, lines, along, "place.lane", plan, back, stations.IN_FILE if in_file else 0.0)
    if spec.placement.lateral is None or of != "ego":
        return spot
    left, room = spec.placement.side == "left", stations.from_lane(structure, spec)
    sideways = scope.number(-room if left else room)
    where = f"at beside(place.lane.centerline, place.lane, {along}, {sideways})"
    return replace(spot, specifiers=(where, *spot.specifiers[1:]))


def before_crosswalk(structure: Structure, cid: str, plan: Plan) -> str:
    """Where along the lane something stands, nobody says where, that hides somebody who crosses by a crosswalk: just
    before that; "": it is no such thing."""
    spec, who, marked = structure[cid].spec, stations.hides(structure, cid), crosswalk(plan)
    if not isinstance(spec, ObjectSpec) or who is None or not marked or not _rests(spec):
        return ""
    at = spec.placement
    off_road = at.position in MOVES_OFF_ROAD and is_walker(who) and at.facing != "across"
    there = at.of == "ego" and at.along != "abreast" and at.gap is None
    if not there or not off_road and at.position not in NEXT_LANES:
        return ""
    short = stations.RIGHT_BEHIND + LENGTH[who.type] / 2 if off_road else SHORT_OF_CROSSWALK
    back = short + LENGTH[spec.type] / 2 + (spec.count - 1) * row_step(spec)
    return f"{position_constant(structure, cid)} = {marked} - {scope.number(round(back, 2))}  # m along the lane"


def _rests(spec: ObjectSpec) -> bool:
    """Whether it stands at first."""
    stands = bool(spec.phases) and spec.phases[0].action in (*AT_REST, "yield")
    return is_static(spec) or spec.speed == 0 or stands


def crosswalk(plan: Plan) -> str:
    """Where along ego's lane the crosswalk lies; "": there is none."""
    if plan.place.kind == "crosswalk":
        return "EGO_AT + EGO_TO_CROSSWALK"
    return "crosswalk_of(place.lane)" if has_marking(plan.place) else ""


def _corner(structure: Structure, spec: ObjectSpec, at: str, plan: Plan) -> Spot:
    """At the corner of the junction, as long as it takes to hide who comes there from where ego starts."""
    length, ego, before = scope.number(LENGTH[spec.type]), structure.ego.spec, stations.CORNER
    assert isinstance(ego, EgoSpec)
    if any(p.action == "enter_road" for p in ego.phases[:1]):  # ego itself stands beside the road
        before += LENGTH[ego.type]
    lines = (
        f"{at[:-3]}_LENGTH = max({length}, EGO_TO_JUNCTION - {scope.number(before)})  # m",
        f"{at} = place.length - {scope.number(stations.CORNER)} - {at[:-3]}_LENGTH / 2  # m along the lane",
    )
    spot = _edge(spec, lines[:1], at, "place.lane", plan)
    return replace(spot, constants=lines, specifiers=(*spot.specifiers, f"with length {at[:-3]}_LENGTH"))


def by_door(structure: Structure, spec: ObjectSpec) -> Spot:
    """At the door of a vehicle beside the road, on the side of the traffic, looking that way."""
    car, left = scope.reference(structure, spec.placement.of), stations.from_door(structure, spec)
    facing = f"facing {'90' if left > 0 else '-90'} deg relative to {car}"
    clear = scope.number(stations.AT_DOOR + WIDTH[spec.type] / 2)
    where = f"at {car} offset by {'-' if left > 0 else ''}({car}.width / 2 + {clear}) @ 0"
    return Spot((), (where, facing, "with regionContainedIn everywhere"), "straight_on(self)", off_road=True)


def _edge(
    spec: ObjectSpec, constants: Sequence[str], along: str, lane: str, plan: Plan, back: float = 0.0, step: float = 0.0
) -> Spot:
    """Beside the road: outwards from the edge of the lanes, next to where one is so far `along` the lane, and
    so far `back` from there, each of several by a `step` further out."""
    left = spec.placement.side == "left"
    two_way = stations.two_way(plan)
    outermost = lane == "place.lane" and plan.place.ego_lane == "rightmost"
    right = f"{lane}.rightEdge" if outermost else f"{lane}.group.rightEdge"
    one_way = plan.place.kind in {"motorway", *RAMP}
    far = f"{lane}.group.opposite.rightEdge" if two_way else f"far_edge({lane})"
    edge = right if not left else f"{lane}.group.leftEdge" if one_way else far
    out = round(stations.outwards(spec) + back, 1)
    offset = scope.number(-out if left else out)
    offset += f" {'-' if left else '+'} {scope.number(step)} * i" if step else ""
    specifiers = (
        f"at beside({edge}, {lane}, {along}, {offset})",
        f"facing {_facing(spec, left)}heading_at({lane}, {along})",
        "with regionContainedIn everywhere",
    )
    return Spot(tuple(constants), specifiers, f"route({lane})", off_road=True)


def _facing(spec: ObjectSpec, left: bool) -> str:
    """Those that will cross look across; those that go against the road look back."""
    actions = {p.action for p in spec.phases}
    on_foot = is_walker(spec) or spec.type == "bicycle"
    crosses = bool(actions & {"cross_road", "enter_road", "collide"}) and on_foot and not walks_first(spec)
    if "reverse" in actions and is_vehicle(spec.type) and spec.placement.facing == "across":  # its back to the road
        return "90 deg relative to " if left else "-90 deg relative to "
    if spec.placement.facing == "across" or (crosses and spec.placement.facing is None):
        return "-90 deg relative to " if left else "90 deg relative to "
    if spec.placement.facing == "against":
        return "180 deg relative to "
    return ""

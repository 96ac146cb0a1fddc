"""Where an object starts, as Scenic: a point on a lane by its distance along it, or a spot beside the road."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.write.typed import ahead, meetings, pockets, scope, stations
from c2s_engine.write.typed.alongside import offset, pulls_out
from c2s_engine.write.typed.beside import before_crosswalk, behind_junction, beside_road, by_door
from c2s_engine.write.typed.hiding import aside, hidden, to_kerb
from c2s_engine.write.typed.place import approach_name
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.pockets import pocket_name
from c2s_engine.write.typed.spot import Spot, measured, member, position_constant
from c2s_engine.write.typed.tables import (
    APPROACH_ANGLE,
    APPROACH_NAME,
    LANE_NAME,
    LENGTH,
    WORKS,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.usual import right_behind, speed_of, turn_of


def place_object(structure: Structure, cid: str, plan: Plan) -> Spot:
    """The spot of an object."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    position = spec.placement.position
    if right_behind(spec):
        return hidden(structure, cid, spec, plan)
    if stations.at_door(structure, spec):
        return by_door(structure, spec)
    if stations.in_line(structure, spec, plan):
        return _in_line_with(structure, cid, spec, plan)
    if position in APPROACH_ANGLE:
        return _approaching(structure, cid, spec, plan)
    if position == "oncoming_lane":
        return _oncoming(structure, cid, spec, plan)
    if position == "on_ramp":
        return _on_ramp(structure, cid, spec, plan)
    if position == "intersection_exit":
        return behind_junction(structure, cid, spec, plan)
    if position in ("roadside", "sidewalk", "parked"):
        return beside_road(structure, cid, spec, plan)
    return _on_lane(structure, cid, spec, plan)


_TO_END = {**dict.fromkeys(APPROACH_ANGLE, "_TO_JUNCTION"), "on_ramp": "_TO_MERGE"}


def _in_line_with(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    """Ahead of or behind an object that is itself on no lane of ego's direction: on the same lane as that one."""
    parent, first = structure[spec.placement.of], structure[stations.first_in_line(structure, cid, plan)]
    assert isinstance(parent.spec, ObjectSpec) and isinstance(first.spec, ObjectSpec)
    place = first.spec.placement.position
    base = scope.constant(structure, parent.id)
    behind = stations.along(spec) < 0
    gap = scope.quantity(stations.gap(spec, plan))
    half = scope.number(stations.bodies(spec, parent.spec, behind))
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    if place in _TO_END:  # measured back from the lane's end
        name = f"{scope.constant(structure, cid)}{_TO_END[place]}"
        op = "+" if behind else "-"
        turn = turn_of(first.spec.phases)
        lane = "place.ramp" if place == "on_ramp" else _approach(plan, first.id, place, turn)
        own = turn_of(spec.phases, turn)
        way = f"route({lane})" if place == "on_ramp" else _way_over(plan, lane, own)
        line = f"{name} = {base}{_TO_END[place]} {op} {gap} {op} {half}  # m"
        at = f"-({member(spec, name)})" if behind else f"-({member(spec, f'max(1, {name})')})"
        return Spot(
            (line,),
            (*_there(structure, cid, plan, lane, at), *loose),
            way,
            approach=None if place == "on_ramp" else lane,
        )
    name = position_constant(structure, cid)
    if place in ("oncoming_lane", "intersection_exit"):
        forward = behind if place == "oncoming_lane" else not behind
        op = "+" if forward else "-"
        line = f"{name} = {base}_AT {op} {gap} {op} {half}  # m along the lane"
        lane, sign = ("place.oncoming_lane", "-") if place == "oncoming_lane" else ("place.exit_lane", "")
        at = f"{sign}({member(spec, name)})" if sign else f"max(1, {member(spec, name)})"
        return Spot((line,), (f"at {lane}.centerline.pointAlongBy({at})", *loose), f"route({lane})")
    where = "behind" if behind else "ahead of"
    if spec.type in WORKS:  # made around a point
        gap = f"{gap} + {scope.number(LENGTH[spec.type] / 2)}"
    next_to = scope.reference(structure, parent.id).replace("[0]", "[0]" if behind else "[-1]")
    return Spot(
        (),
        (f"{where} {next_to} by {member(spec, gap)}", "with regionContainedIn everywhere"),
        "route(place.lane)",
        off_road=True,
    )


def _on_lane(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    k = plan.lane_of[cid] or 0
    lane = LANE_NAME[k]
    sign = stations.along(spec)
    at = position_constant(structure, cid)
    if sign == 0:
        gap = spec.placement.gap
        lines = [f"{at} = {position_constant(structure, spec.placement.of)}" + (
            f" + {scope.quantity(gap)}" if gap else ""
        )]  # fmt: skip
    else:
        marked = before_crosswalk(structure, cid, plan)
        lines = [marked] if marked else measured(structure, cid, spec, plan, sign)
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    if way_beside := offset(spec, ego, plan.place):
        turn = f"route({lane}, {turn_of(spec.phases)})"
        lines = meetings.start(structure, cid, plan, lane, turn, at) or lines
    reached = member(spec, at, sign or 1)
    if plan.place.kind == "on_ramp" and k > 0:  # the lanes meet at their ends
        reached = f"min(-1, {reached} - place.lane.centerline.length)"
    specifiers: tuple[str, ...] = (f"at {lane}.centerline.pointAlongBy({reached})",)
    if side := (0.0 if pulls_out(spec) else way_beside) or aside(structure, cid, plan):
        specifiers = (
            f"at beside({lane}.centerline, {lane}, {reached}, {scope.number(-side)})",
            "with regionContainedIn everywhere",
            *([] if spec.placement.facing == "against" else [f"facing heading_at({lane}, {reached})"]),
        )
    if is_walker(spec):
        specifiers += ("with regionContainedIn everywhere",)
    way = f"route({lane}, place.turn)" if plan.junction and k == 0 and not turn_given(spec) else f"route({lane})"
    if turn_given(spec):
        round_it = plan.place.kind == "roundabout"
        way = _way_over(plan, lane, turn_of(spec.phases)) if round_it else f"route({lane}, {turn_of(spec.phases)})"
    if spec.placement.facing == "against":
        specifiers += ("facing 180 deg relative to roadDirection",)
        way = f"route({lane})[::-1]"
    return Spot(tuple(lines), specifiers, way, lane=k if spec.placement.facing != "against" else None)


def turn_given(spec: ObjectSpec) -> bool:
    return any(p.action in ("turn_left", "turn_right", "go_straight") for p in spec.phases)


def _approaching(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    turn = turn_of(spec.phases)
    lane = _approach(plan, cid, spec.placement.position, turn)
    name = f"{scope.constant(structure, cid)}_TO_JUNCTION"
    value = f"{scope.quantity(stations.to_junction(cid, spec, plan))}  # m"
    if spec.placement.gap is None and middle(speed_of(spec, plan.place)) <= 0:
        before = scope.number(1 + LENGTH[spec.type] / 2)
        value = f"{lane}.centerline.length - stop_line({lane}) + {before}  # m, at its line"
    at = f"-({member(spec, name)})" if spec.count > 1 else f"-{name}"
    line = _way_over(plan, lane, turn)
    constants = meetings.start(structure, cid, plan, lane, line) or [f"{name} = {value}"]
    if cid in plan.set_out:
        constants += meetings.sets_out(structure, cid, plan, lane, line)
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    there = _there(structure, cid, plan, lane, at)
    return Spot(tuple(constants), (*there, *loose), line, approach=lane)


def _approach(plan: Plan, cid: str, position: str, turn: str) -> str:
    """The lane by which an object reaches the junction, or on which it waits there while others go by."""
    return pocket_name(position) if cid in plan.pocketed else approach_name(plan, position, turn)


def _there(structure: Structure, cid: str, plan: Plan, lane: str, along: str) -> tuple[str, ...]:
    """So far along an approach, or beside it where some wait there and others drive past."""
    left = pockets.aside(structure, plan, cid)
    if not left:
        return (f"at {lane}.centerline.pointAlongBy({along})",)
    right = left[1:] if left.startswith("-") else f"-{left}"
    at = f"at beside({lane}.centerline, {lane}, {along}, {right})"
    return at, "with regionContainedIn everywhere", f"facing heading_at({lane}, {along})"


def _way_over(plan: Plan, lane: str, turn: str) -> str:
    """The way from an approach over the junction; into a roundabout one turns right, and leaves it by its bearing."""
    if plan.place.kind != "roundabout":
        return f"route({lane})" if turn == "STRAIGHT" else f"route({lane}, {turn})"
    if lane == APPROACH_NAME["circulating"]:  # past ego's entry and on in the ring, or out of it right before that
        return f"route({lane}, RIGHT_TURN)" if turn == "RIGHT_TURN" else f"route({lane}, LEFT_TURN, 90 deg)"
    bearing = {"LEFT_TURN": ", 90 deg", "RIGHT_TURN": ", -90 deg"}.get(turn, "")
    return f"route({lane}, RIGHT_TURN{bearing})"


def _oncoming(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    at = position_constant(structure, cid)
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    where: tuple[str, ...] = (f"at place.oncoming_lane.centerline.pointAlongBy(-({member(spec, at)}))",)
    if side := to_kerb(structure, cid):
        lane, along = "place.oncoming_lane", f"-({member(spec, at)})"
        at_kerb = f"at beside({lane}.centerline, {lane}, {along}, {scope.number(side)})"
        where = (at_kerb, f"facing heading_at({lane}, {along})")
        loose = ("with regionContainedIn everywhere",)
    return Spot(
        tuple(measured(structure, cid, spec, plan, 1)),
        (*where, *loose),
        "route(place.oncoming_lane)",
    )


def _on_ramp(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    name = f"{scope.constant(structure, cid)}_TO_MERGE"
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    at = f"-({member(spec, name)})" if spec.count > 1 else f"-{name}"
    start = f"{scope.number(stations.to_merge(spec, plan))}  # m"
    drives = not is_static(spec) and middle(speed_of(spec, plan.place)) > 0
    if spec.placement.gap is None and plan.place.kind != "on_ramp" and drives:
        metres, before_end = ahead.merging(structure, cid)
        own = f"{scope.constant(structure, cid)}_SPEED"
        end = f", before_end={scope.number(before_end)}" if before_end is not None else ""
        start = f"start_to_merge(place, {own}, EGO_SPEED, EGO_AT, ahead={scope.number(metres)}{end})"
    return Spot(
        (f"{name} = {start}",),
        (f"at place.ramp.centerline.pointAlongBy({at})", *loose),
        "route(place.ramp)",
    )

"""Where an object starts, as Scenic: a point on a lane by its distance along it, or a spot beside the road."""

import math
from dataclasses import dataclass

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.course import EDGE
from c2s_engine.write.typed.place import approach_name
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import APPROACH_ANGLE, LANE_NAME, LENGTH, MOVES_OFF_ROAD, is_vehicle, is_walker
from c2s_engine.write.typed.usual import default_gap, right_behind, speed_of, turn_of, uses_crosswalk, walks_first


@dataclass(frozen=True)
class Spot:
    """`constants`: lines before the object; `specifiers`: where (`i` counts members); `line`: its way's points."""

    constants: tuple[str, ...]
    specifiers: tuple[str, ...]
    line: str
    lane: int | None = None
    approach: str | None = None
    off_road: bool = False
    heading: str = ""  # the road's heading at the spot, where it stands beside it


def place_object(structure: Structure, cid: str, plan: Plan) -> Spot:
    """The spot of an object."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    position = spec.placement.position
    if right_behind(spec):
        return _hidden(structure, spec)
    of = spec.placement.of
    if of not in ("ego", "E") and plan.lane_of[of] is None and position not in _OWN_PLACE:
        return _in_line_with(structure, cid, spec, plan)
    if position in APPROACH_ANGLE:
        return _approaching(structure, cid, spec, plan)
    if position == "oncoming_lane":
        return _oncoming(structure, cid, spec, plan)
    if position == "on_ramp":
        return _on_ramp(structure, cid, spec, plan)
    if position == "intersection_exit":
        return _exit(structure, cid, spec, plan)
    if position in ("roadside", "sidewalk", "parked"):
        return _beside_road(structure, cid, spec, plan)
    return _on_lane(structure, cid, spec, plan)


_OWN_PLACE = {*APPROACH_ANGLE, "oncoming_lane", "on_ramp", "intersection_exit", "roadside", "sidewalk", "parked"}
_TO_END = {**dict.fromkeys(APPROACH_ANGLE, "_TO_JUNCTION"), "on_ramp": "_TO_MERGE"}


def _in_line_with(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    """Ahead of or behind an object that is itself on no lane of ego's direction: on the same lane as that one."""
    parent = structure[spec.placement.of]
    assert isinstance(parent.spec, ObjectSpec)
    place = parent.spec.placement.position
    base = scope.constant(structure, parent.id)
    behind = _along(spec) < 0
    gap = scope.quantity(_gap(structure, cid, spec, plan))
    half = scope.number((LENGTH[spec.type] + LENGTH[parent.spec.type]) / 2 + _row_beyond(parent.spec, not behind))
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    if place in _TO_END:  # measured back from the lane's end
        name = f"{scope.constant(structure, cid)}{_TO_END[place]}"
        op = "+" if behind else "-"
        turn = turn_of(parent.spec.phases)
        lane = "rampLane" if place == "on_ramp" else approach_name(plan, place, turn)
        own = turn_of(spec.phases, turn)
        way = f"way({lane})" if place == "on_ramp" else _way_over(plan, lane, own)
        line = f"{name} = {base}{_TO_END[place]} {op} {gap} {op} {half}  # m"
        at = f"-({_member(spec, name)})" if behind else f"-({_member(spec, f'max(1, {name})')})"
        return Spot(
            (line,),
            (f"at {lane}.centerline.pointAlongBy({at})", *loose),
            way,
            approach=None if place == "on_ramp" else lane,
        )
    name = position_constant(structure, cid)
    if place in ("oncoming_lane", "intersection_exit"):
        forward = behind if place == "oncoming_lane" else not behind
        op = "+" if forward else "-"
        line = f"{name} = {base}_AT {op} {gap} {op} {half}  # m along the lane"
        lane, sign = ("oncomingLane", "-") if place == "oncoming_lane" else ("exitLane", "")
        at = f"{sign}({_member(spec, name)})" if sign else f"max(1, {_member(spec, name)})"
        return Spot((line,), (f"at {lane}.centerline.pointAlongBy({at})", *loose), f"way({lane})")
    where = "behind" if behind else "ahead of"
    next_to = scope.reference(structure, parent.id).replace("[0]", "[0]" if behind else "[-1]")
    return Spot(
        (),
        (f"{where} {next_to} by {_member(spec, gap)}", "with regionContainedIn everywhere"),
        "way(egoLane)",
        off_road=True,
    )


def _row_beyond(parent: ObjectSpec, ahead: bool) -> float:
    """How far (m) a row goes on beyond its first member, on the side of those placed ahead of it or behind it."""
    placement = parent.placement
    if parent.type in ("construction_zone", "lane_closure"):  # always one
        return 0.0
    backwards = placement.position in (*_TO_END, "oncoming_lane") or _along(parent) < 0
    return (parent.count - 1) * _step(parent) if ahead != backwards else 0.0


def position_constant(structure: Structure, cid: str) -> str:
    """The constant that says how far along the lane something starts, m."""
    return "EGO_AT" if cid in ("ego", "E") else f"{scope.constant(structure, cid)}_AT"


def _gap(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> float | tuple[float, float]:
    return spec.placement.gap if spec.placement.gap is not None else default_gap(spec, plan.ego_speed, plan.place)


def _of_length(structure: Structure, of: str) -> float:
    spec = structure.ego.spec if of in ("ego", "E") else structure[of].spec
    return LENGTH.get(getattr(spec, "type", "car"), 4.8)


def _base(structure: Structure, of: str, plan: Plan) -> str:
    """The constant from which something is measured: that of `of`, where it has one along ego's lane."""
    parent = structure[of].spec if of not in ("ego", "E") else None
    if isinstance(parent, ObjectSpec) and right_behind(parent):
        return _base(structure, parent.placement.hidden_by or "ego", plan)
    elsewhere = isinstance(parent, ObjectSpec) and plan.lane_of[of] is None and not _stands_there(structure, of)
    return "EGO_AT" if elsewhere else position_constant(structure, of)


def _at(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, sign: int) -> str:
    """`X_AT = OTHER_AT + gap + half lengths`."""
    of = spec.placement.of
    half = (LENGTH[spec.type] + _of_length(structure, of)) / 2 + 0.2
    gap = _gap(structure, cid, spec, plan)
    base = _base(structure, of, plan)
    if _stands_there(structure, of):
        gap = 2.0 if spec.placement.gap is None else gap
    if base == position_constant(structure, of) != "EGO_AT":
        parent = structure[of].spec
        assert isinstance(parent, ObjectSpec)
        half += _row_beyond(parent, sign > 0)
    op = "+" if sign > 0 else "-"
    text = scope.quantity(gap) if isinstance(gap, tuple | list) else scope.number(gap)
    tail = f" {op} {text}" if text != "0" else ""
    return f"{position_constant(structure, cid)} = {base}{tail} {op} {scope.number(half)}  # m along the lane"


def _step(spec: ObjectSpec) -> float:
    return LENGTH[spec.type] + (middle(spec.spacing) if spec.spacing is not None else 3.0)


def _member(spec: ObjectSpec, base: str, sign: int = 1) -> str:
    if spec.count == 1:
        return base
    return f"{base} {'+' if sign > 0 else '-'} {scope.number(_step(spec))} * i"


def _along(spec: ObjectSpec) -> int:
    """+1 ahead, 0 abreast, -1 behind."""
    along, position = spec.placement.along, spec.placement.position
    if position == "partly_in_lane" and along == "abreast":
        return 1
    if along and position not in ("ahead", "behind"):
        return {"ahead": 1, "abreast": 0, "behind": -1}[along]
    return {"behind": -1, "beside": 0}.get(spec.placement.position, 1)


def _on_lane(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    k = plan.lane_of[cid] or 0
    if k not in plan.offsets:  # at a ramp the only neighbour is on the left
        k = 1
    lane = LANE_NAME[k]
    sign = _along(spec)
    at = position_constant(structure, cid)
    if sign == 0:
        gap = spec.placement.gap
        line = f"{at} = {position_constant(structure, spec.placement.of)}" + (
            f" + {scope.quantity(gap)}" if gap else ""
        )
    else:
        line = _at(structure, cid, spec, plan, sign)
    reached = _member(spec, at, sign or 1)
    if plan.place.kind == "on_ramp" and k > 0:  # the lanes meet at their ends
        reached = f"min(-1, {reached} - egoLane.centerline.length)"
    point = f"{lane}.centerline.pointAlongBy({reached})"
    specifiers: tuple[str, ...] = (f"at {point}",)
    if spec.placement.position == "partly_in_lane":
        side = -EDGE if spec.placement.side == "left" else EDGE
        specifiers = (
            f"at (new OrientedPoint at {point}, facing roadDirection) offset by {scope.number(side)} @ 0",
            "with regionContainedIn everywhere",
            *([] if spec.placement.facing == "against" else [f"facing (roadDirection at {point})"]),
        )
    if is_walker(spec.type):
        specifiers += ("with regionContainedIn everywhere",)
    way = f"way({lane}, egoTurn)" if plan.junction and k == 0 and not turn_given(spec) else f"way({lane})"
    if turn_given(spec):
        way = f"way({lane}, ManeuverType.{turn_of(spec.phases)})"
    if spec.placement.facing == "against":
        specifiers += ("facing 180 deg relative to roadDirection",)
        way = f"way({lane})[::-1]"
    return Spot((line,), specifiers, way, lane=k if spec.placement.facing != "against" else None)


def turn_given(spec: ObjectSpec) -> bool:
    return any(p.action in ("turn_left", "turn_right", "go_straight") for p in spec.phases)


def _approaching(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    turn = turn_of(spec.phases)
    lane = approach_name(plan, spec.placement.position, turn)
    name = f"{scope.constant(structure, cid)}_TO_JUNCTION"
    if spec.placement.gap is not None:
        value = scope.quantity(spec.placement.gap)
    else:  # so far off that it reaches the junction when ego does
        own = middle(speed_of(spec, plan.place))
        far = middle(plan.distance or 40)
        seconds = far / max(plan.ego_speed, 4) if plan.ego_speed > 0 else math.sqrt(far + 5)
        lead = 6 if spec.placement.position == "opposite_approach" else 3
        value = scope.number(max(8.0, min(own * seconds + lead, 130.0))) if own > 0 else "8"
    at = f"-({_member(spec, name)})" if spec.count > 1 else f"-{name}"
    constants = [f"{name} = {value}  # m"]
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    return Spot(
        tuple(constants),
        (f"at {lane}.centerline.pointAlongBy({at})", *loose),
        _way_over(plan, lane, turn),
        approach=lane,
    )


def _way_over(plan: Plan, lane: str, turn: str) -> str:
    """The way from an approach over the junction; into a roundabout one turns right, and leaves it by its bearing."""
    if plan.place.kind != "roundabout":
        return f"way({lane}, ManeuverType.{turn})"
    bearing = {"LEFT_TURN": ", 90 deg", "RIGHT_TURN": ", -90 deg"}.get(turn, "")
    return f"way({lane}, ManeuverType.RIGHT_TURN{bearing})"


def _oncoming(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    line = _at(structure, cid, spec, plan, 1)
    at = position_constant(structure, cid)
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    return Spot(
        (line,),
        (f"at oncomingLane.centerline.pointAlongBy(-({_member(spec, at)}))", *loose),
        "way(oncomingLane)",
    )


def _on_ramp(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    name = f"{scope.constant(structure, cid)}_TO_MERGE"
    own, ego = middle(speed_of(spec, plan.place)), max(plan.ego_speed, 4)
    lead = 0.0
    if any(p.action == "cut_in" for p in spec.phases):  # it comes out in front
        lead = 6 + (middle(spec.placement.gap) if spec.placement.gap is not None else 14)
    value = scope.number(max(10.0, min((own * (middle(plan.distance or 80) + 100) / ego) - 100 - lead, 250)))
    loose = () if is_vehicle(spec.type) else ("with regionContainedIn everywhere",)
    at = f"-({_member(spec, name)})" if spec.count > 1 else f"-{name}"
    return Spot(
        (f"{name} = {value}  # m",),
        (f"at rampLane.centerline.pointAlongBy({at})", *loose),
        "way(rampLane)",
    )


def _exit(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    at = position_constant(structure, cid)
    if is_walker(spec.type) or spec.type == "bicycle":
        gap = spec.placement.gap if spec.placement.gap is not None else 4.0
        point = f"exitLane.centerline.pointAlongBy({_member(spec, at)})"
        return _edge(spec, at, f"{at} = {scope.quantity(gap)}  # m behind the junction", point, "exitLane", plan)
    line = f"{at} = {scope.quantity(_gap(structure, cid, spec, plan))}  # m behind the junction"
    return Spot((line,), (f"at exitLane.centerline.pointAlongBy({_member(spec, at)})",), "way(exitLane)")


def _beside_road(structure: Structure, cid: str, spec: ObjectSpec, plan: Plan) -> Spot:
    sign, of = _along(spec), spec.placement.of
    if plan.place.kind == "crosswalk" and uses_crosswalk(spec):
        line = f"{position_constant(structure, cid)} = EGO_AT + EGO_TO_CROSSWALK"
    elif sign == 0 and _stands_there(structure, of):  # just in front of what takes the spot itself
        clear = scope.number((LENGTH[spec.type] + _of_length(structure, of)) / 2 + 0.8)
        line = f"{position_constant(structure, cid)} = {position_constant(structure, of)} + {clear}"
    elif sign == 0:
        line = f"{position_constant(structure, cid)} = {_base(structure, of, plan)}"
    else:
        line = _at(structure, cid, spec, plan, sign)
    at = position_constant(structure, cid)
    point = f"egoLane.centerline.pointAlongBy({_member(spec, at, sign or 1)})"
    return _edge(spec, at, line, point, "egoLane", plan)


def _stands_there(structure: Structure, of: str) -> bool:
    """Whether the one that an object is placed by is itself beside the road."""
    other = structure[of].spec if of in structure and of not in ("ego", "E") else None
    return isinstance(other, ObjectSpec) and other.placement.position in MOVES_OFF_ROAD


def _edge(spec: ObjectSpec, at: str, constant: str, point: str, lane: str, plan: Plan) -> Spot:
    """Beside the road: outwards from the edge of the lanes nearest to a point of the lane."""
    left = spec.placement.side == "left"
    two_way = plan.oncoming or plan.place.kind in ("intersection", "crosswalk") or plan.place.oncoming
    outermost = lane == "egoLane" and plan.place.ego_lane == "rightmost"
    right = f"{lane}.rightEdge" if outermost else f"{lane}.group.rightEdge"
    edge = right if not left else f"{lane}.group.opposite.rightEdge" if two_way else f"{lane}.group.leftEdge"
    out = {"parked": 1.4, "roadside": 1.5, "sidewalk": 3.0, "intersection_exit": 1.5}.get(spec.placement.position, 1.5)
    if is_vehicle(spec.type) and spec.placement.position == "roadside":
        out = 1.8
    elif not is_vehicle(spec.type) and not is_walker(spec.type):  # signs and props may be wide
        out = max(out, 2.4)
    offset = scope.number(-out if left else out)
    base = f"(new OrientedPoint at {edge}.project({point}), facing roadDirection at {point})"
    heading = f"roadDirection at {point}"
    facing = _facing(spec, left)
    specifiers = (
        f"at {base} offset by {offset} @ 0",
        f"facing {facing}({heading})",
        "with regionContainedIn everywhere",
    )
    return Spot(
        (constant,), specifiers, "way(egoLane)" if lane == "egoLane" else f"way({lane})", off_road=True, heading=heading
    )


def _facing(spec: ObjectSpec, left: bool) -> str:
    """Those that will cross look across; those that go against the road look back."""
    actions = {p.action for p in spec.phases}
    on_foot = is_walker(spec.type) or spec.type == "bicycle"
    crosses = bool(actions & {"cross_road", "enter_road", "collide"}) and on_foot and not walks_first(spec)
    if "reverse" in actions and is_vehicle(spec.type) and spec.placement.facing == "across":  # its back to the road
        return "90 deg relative to " if left else "-90 deg relative to "
    if spec.placement.facing == "across" or (crosses and spec.placement.facing is None):
        return "-90 deg relative to " if left else "90 deg relative to "
    if spec.placement.facing == "against":
        return "180 deg relative to "
    return ""


def _hidden(structure: Structure, spec: ObjectSpec) -> Spot:
    """Right behind what hides it, as ego sees it: close ahead of the hiding object."""
    hider = scope.reference(structure, spec.placement.hidden_by or "ego").replace("[0]", "[-1]")  # of a row the last
    left = spec.placement.side == "left"
    angle = "-90 deg" if left else "90 deg"
    return Spot(
        (),
        (
            f"ahead of {hider} by {_member(spec, '0.6')}",
            f"facing {angle} relative to {hider}",
            "with regionContainedIn everywhere",
        ),
        "straight_on(self)",
        off_road=True,
    )

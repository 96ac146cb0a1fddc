"""R: the place, its lanes and approaches, and the parts of the driving kernel that the program uses."""

from c2s_engine.maps.expressions import PlaceCode
from c2s_engine.write.typed import kernel
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.pockets import pocket_name
from c2s_engine.write.typed.scope import number, quantity
from c2s_engine.write.typed.tables import APPROACH_ANGLE, APPROACH_NAME, LANE_NAME

EGO_VARIES = 20.0
"""m of its lane within which ego starts, where nothing ahead says where."""
NEXT_ARM = 100
"""m between two arms of a roundabout at most, so that drivers who reach them together meet soon."""
_OF_FEW = ("ego_lane", "shoulder", "sidewalk", "crosswalk", "speed_limit")
"""What few roundabouts have, as are several lanes: where it is asked for, those with far arms are taken too."""
Pairs = frozenset[tuple[int, int]]
"""(junction, road into it)"""


def write_place(plan: Plan, code: PlaceCode, parts: frozenset[str], signs: Pairs = frozenset()) -> str:
    """The fragment of R: kernel, choice of the place, lanes by name, ego's start."""
    if plan.approaches:
        parts = parts | {"ring_approach" if plan.place.kind == "roundabout" else "approach"}
    if plan.pockets:
        parts = parts | {"pocket"}
    if code.yields == "spots":
        parts = parts | {"along"}
    if plan.place.kind == "curve":
        parts = parts | {"bend_start"}
    lines = ["import math", "", *kernel.text(parts).splitlines(), ""] if parts else []
    if code.comment:
        lines.append(f"# {code.comment}")
    if plan.place.speed_limit is not None:
        lines.append(f"param speed_limit = {number(round(plan.place.speed_limit * 3.6))}  # km/h, as posted")
    lines += _choice(plan, code, signs)
    lines += _lanes(plan)
    lines += _start(plan, code)
    return "\n".join(lines)


def candidates(plan: Plan, code: PlaceCode, signs: Pairs = frozenset()) -> str:
    """The list of places from which one is drawn: what counts how many there are (with the kernel's `approach`).

    `signs`: the junctions and the roads into them that have stop signs.
    """
    if code.yields == "spots":
        return code.expression
    if code.yields == "lanes":
        bend = ", bend_start(lane)" if plan.place.kind == "curve" else ""
        if plan.oncoming:
            innermost = "for o in lane.group.opposite.lanes if o.sections[0]._fasterLane is None"
            return f"[(lane{bend}, o) for lane in {code.expression} {innermost}]"
        return f"[(lane{bend}) for lane in {code.expression}]" if bend else code.expression
    if plan.ramp or plan.place.kind == "on_ramp":
        merging = "o.endLane is m.endLane.sections[0]._fasterLane.lane"
        least = plan.lengths.get("rampLane", 0.0)
        long = f" and m.startLane.centerline.length > {number(least)}" if least else ""
        return f"[(m, o) for m in {code.expression} for o in m.intersection.maneuvers if {merging}{long}]"
    innermost = " for o in m.startLane.group.opposite.lanes if o.sections[0]._fasterLane is None"
    if not plan.approaches:
        return f"[(m, o) for m in {code.expression}{innermost}]" if plan.oncoming else code.expression
    ring = plan.place.kind == "roundabout"
    roles = ", ".join(_role(plan, p, t) for p, t in plan.approaches)
    roles += "".join(f", pocket({_role(plan, p, t)})" for p, t in plan.pockets)
    listed = f"{{{', '.join(map(str, sorted(signs)))}}}"
    fit = "".join(
        f" and (j[0].intersection.id, j[{i}].road.id) in {listed}"
        for i, (position, _) in enumerate(plan.approaches, start=1)
        if position in plan.stops
    )
    if set(plan.stops) - {"opposite_approach"} and plan.place.control is None:  # ego's road has priority there
        fit += f" and (j[0].intersection.id, j[0].startLane.road.id) not in {listed}"
    fit += "".join(
        f" and j[{i}].centerline.length > {number(plan.lengths[name])}"
        for i, (position, turn) in enumerate(plan.approaches, start=1)
        if (name := approach_name(plan, position, turn)) in plan.lengths
    )
    if ring and plan.place.lanes in (None, 1) and all(getattr(plan.place, field) is None for field in _OF_FEW):
        ends = "j[0].startLane.centerline[-1]"
        fit += "".join(
            f" and j[{i}].centerline[-1].distanceTo({ends}) < {NEXT_ARM}"
            for i, _ in enumerate(plan.approaches, start=1)
        )
    if plan.oncoming:
        return f"[j for j in [(m, {roles}, o) for m in {code.expression}{innermost}] if all(j){fit}]"
    return f"[j for j in [(m, {roles}) for m in {code.expression}] if all(j){fit}]"


def _role(plan: Plan, position: str, turn: str) -> str:
    """The lane of an approach: where others are passed on it, one with a lane to its left if there is one."""
    if plan.place.kind == "roundabout":
        return f"ring_approach(m, {APPROACH_ANGLE[position]})"
    outer = ", True" if (position, turn) in plan.pockets else ""
    return f"approach(m, {APPROACH_ANGLE[position]}, ManeuverType.{turn}{outer})"


def _choice(plan: Plan, code: PlaceCode, signs: Pairs) -> list[str]:
    places = _wrapped(candidates(plan, code, signs))
    if code.yields == "lanes":
        if not plan.oncoming and plan.place.kind != "curve":
            return [f"egoLane = Uniform(*{places})"]
        lines = [f"stretch = Uniform(*{places})", "egoLane = stretch[0]"]
        return lines + (["oncomingLane = stretch[-1]"] if plan.oncoming else [])
    if code.yields == "spots":
        if not plan.oncoming:
            drawn = "[(network.laneAt(s), along(network.laneAt(s), s)) for s in spots]"
            return [f"spots = {places}", f"crossing = Uniform(*{drawn})", "egoLane = crossing[0]"]
        innermost = "for o in network.laneAt(s).group.opposite.lanes if o.sections[0]._fasterLane is None"
        return [
            f"spots = {places}",
            f"crossing = Uniform(*[(network.laneAt(s), along(network.laneAt(s), s), o) for s in spots {innermost}])",
            "egoLane = crossing[0]",
            "oncomingLane = crossing[2]",
        ]
    if plan.ramp:
        return [
            f"merge = Uniform(*{places})  # the ramp's way and that of the lane beside it",
            "egoTurn = merge[1]",
            "egoLane = egoTurn.startLane",
            "rampLane = merge[0].startLane",
            "accelerationLane = merge[0].endLane",
        ]
    if plan.place.kind == "on_ramp":
        return [
            f"merge = Uniform(*{places})  # the ramp's way and that of the lane beside it",
            "egoTurn = merge[0]",
            "egoLane = egoTurn.startLane",
            "accelerationLane = egoTurn.endLane",
            "leftLane = merge[1].startLane",
        ]
    if plan.place.kind == "off_ramp" and -1 in plan.offsets:
        return [
            f"egoTurn = Uniform(*{places})",
            "rightLane = egoTurn.startLane",
            "egoLane = rightLane.sections[0]._fasterLane.lane",
        ]
    if not plan.approaches and not plan.oncoming:
        return [f"egoTurn = Uniform(*{places})", "egoLane = egoTurn.startLane"]
    lines = [f"junction = Uniform(*{places})", "egoTurn = junction[0]", "egoLane = egoTurn.startLane"]
    for i, (position, turn) in enumerate(plan.approaches, start=1):
        lines.append(f"{approach_name(plan, position, turn)} = junction[{i}]")
    for i, (position, _) in enumerate(plan.pockets, start=len(plan.approaches) + 1):
        lines.append(f"{pocket_name(position)} = junction[{i}]  # a lane, and m to the left on it")
    return lines + (["oncomingLane = junction[-1]"] if plan.oncoming else [])


def approach_name(plan: Plan, position: str, turn: str) -> str:
    """The variable of the approach by which an object reaches the junction."""
    same = [t for p, t in plan.approaches if p == position]
    base = APPROACH_NAME[position]
    return base if len(same) == 1 else f"{base}{''.join(w.capitalize() for w in turn.split('_'))}"


def _wrapped(expression: str) -> str:
    return (
        expression
        if len(expression) < 90
        else expression.replace(" for ", "\n    for ", 1).replace(" if ", "\n    if ", 1)
    )


def _lanes(plan: Plan) -> list[str]:
    lines = []
    done = {0, 1} if plan.place.kind == "on_ramp" else {0, -1} if plan.place.kind == "off_ramp" else {0}
    for k in sorted(plan.offsets - done):
        section = "egoLane.sections[-1]" if plan.junction else "egoLane.sections[0]"
        step = "._fasterLane" if k > 0 else "._slowerLane"
        lines.append(f"{LANE_NAME[k]} = {section}{step * abs(k)}.lane")
    if plan.exit_room:
        lines.append("exitLane = egoTurn.endLane")
    return lines


def _start(plan: Plan, code: PlaceCode) -> list[str]:
    lines = []
    if plan.place.kind == "curve":
        lines += [
            "EGO_TO_BEND = 40  # m",
            f"EGO_AT = max({number(plan.before)}, stretch[1] - EGO_TO_BEND)  # m along its lane",
        ]
    elif plan.distance is None:
        lines.append(f"EGO_AT = Range({number(plan.before)}, {number(plan.before + EGO_VARIES)})  # m along its lane")
    elif code.yields == "spots":
        lines += [f"EGO_TO_CROSSWALK = {quantity(plan.distance)}  # m", "EGO_AT = crossing[1] - EGO_TO_CROSSWALK"]
    else:
        lines += [
            f"EGO_TO_JUNCTION = {quantity(plan.distance)}  # m",
            "EGO_AT = egoLane.centerline.length - EGO_TO_JUNCTION",
        ]
    return lines

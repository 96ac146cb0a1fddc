"""R: the place, as a call of the driving library, and ego's start in it."""

import math

from c2s_engine.maps.expressions import STRETCHES, Call, place_call
from c2s_engine.structure.quantity import high
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.room import AT_THE_EDGE
from c2s_engine.write.typed.scope import number, quantity
from c2s_engine.write.typed.tables import APPROACH_NAME, BEARING, JUNCTION, LENGTH, RAMP, SIDE

EGO_VARIES = 20.0
"""m of its lane within which ego starts, where nothing ahead says where."""
SLOW = 13.0
"""m/s up to which any road will do, however it bends."""
STEP = 2.5
"""m/s in steps of which a road is asked for: not every change of a speed is one of the place."""
EGO_TO_BEND = 40
"""m from ego's start to the beginning of a bend."""
_OF_FEW = ("ego_lane", "shoulder", "sidewalk", "crosswalk", "speed_limit")
"""What few roundabouts have, as are several lanes: where it is asked for, those with far arms are taken too."""


def write_place(plan: Plan) -> str:
    """The fragment of R: the place and where ego starts in it."""
    lines = []
    if plan.place.speed_limit is not None:
        lines.append(f"param speed_limit = {number(round(plan.place.speed_limit * 3.6))}  # km/h, as posted")
    if plan.ordinary:
        lines += call(plan).lines("place = Uniform(*ordinary(", f"{_suits(plan)}))")
    else:
        lines += call(plan).lines("place = Uniform(*", ")")
    lines += _start(plan)
    return "\n".join(lines)


def call(plan: Plan, share: float = 0.0, across: bool = False) -> Call:
    """The call that lists the places from which one is drawn: how many there are on a map can be counted by it.

    `share`: only stretches with so much of the room that is wanted, up to the next junction or (`across`) straight over
    junctions.
    """
    spec = plan.place.model_copy(update={"kind": "on_ramp"}) if plan.ramp else plan.place
    short = spec.kind != "roundabout" and plan.exit_room < 25  # every junction has that much behind it
    more: dict[str, str] = {}
    if plan.ramp:
        more = {"ego_on": "'beside'", "ramp_length": _metres(plan.lengths.get("place.ramp", 0.0))}
    elif spec.kind == "off_ramp" and -1 in plan.offsets:
        more = {"ego_on": "'beside'"}
    elif spec.kind == "on_ramp" and 2 in plan.offsets:
        more = {"two_beside": "True"}
    if spec.kind == "roundabout" and not _near(plan):
        more["arms_within"] = "math.inf"
    if spec.kind == "roundabout" and plan.exit_room and spec.manoeuvre in BEARING:
        more["leaving"] = BEARING[spec.manoeuvre]
    if plan.parked and spec.kind in ("road", "straight", "curve") and spec.shoulder is None:
        more["shoulder"] = "'preferred'"
    if plan.also and spec.kind == "intersection":
        more["also"] = f"[{', '.join(plan.also)}]"
    if plan.single:
        more["lanes"] = "1"
    if spec.kind in STRETCHES:
        more |= {"speed": number(math.ceil(plan.fastest / STEP) * STEP)} if plan.fastest > SLOW else {}
        more |= {"share": str(share)} if share else {}
    if across or plan.across and spec.kind in JUNCTION | RAMP:
        more["across"] = "True"
    return place_call(
        spec,
        length=plan.before + plan.after,
        min_length=plan.before + EGO_VARIES + plan.reach if plan.reach > 0 else 0.0,
        approach=high(plan.distance) + plan.before if plan.distance is not None else 0.0,
        exit_room=0 if short else plan.exit_room,
        others=sources(plan),
        more=more,
    )


def sources(plan: Plan) -> tuple[str, ...]:
    """The ways by which others reach ego's junction, as the library takes them."""
    return tuple(_from(plan, position, turn) for position, turn in plan.ways_of_others)


def _suits(plan: Plan) -> str:
    """The speed that a road's limit is to suit, as an argument, where no limit is said."""
    return f", speed={number(plan.ego_speed)}" if plan.ego_speed > 0 and plan.place.speed_limit is None else ""


def _near(plan: Plan) -> bool:
    """Whether drivers who reach a roundabout together are to meet soon: its arms are near one another."""
    return plan.place.lanes in (None, 1) and all(getattr(plan.place, field) is None for field in _OF_FEW)


def _from(plan: Plan, position: str, turn: str) -> str:
    """How others reach the junction by one of the ways that the plan knows."""
    arguments = [f"'{SIDE[position]}'"]
    if plan.place.kind != "roundabout" and turn != "STRAIGHT":
        arguments.append(turn)
    if position in plan.stops:
        arguments.append("sign='stop'")
    elif position in plan.priority:
        arguments.append("priority=True")
    if length := plan.lengths.get(approach_name(plan, position, turn), 0.0):
        arguments.append(f"length={_metres(length)}")
    if (position, turn) in plan.pockets:
        arguments.append("passed=True")
    return f"From({', '.join(arguments)})"


def _metres(length: float) -> str:
    return f"{length:.0f}" if length else ""


def approach_name(plan: Plan, position: str, turn: str) -> str:
    """The lane by which an object reaches the junction, in the program."""
    ways = plan.ways_of_others
    first = next((t for p, t in ways if p == position), turn)
    return APPROACH_NAME[position] if first == turn else f"place.others[{ways.index((position, turn))}]"


def _start(plan: Plan) -> list[str]:
    if plan.place.kind == "curve":
        start = f"EGO_AT = max({number(plan.before)}, place.mark - EGO_TO_BEND)  # m along its lane"
        return [f"EGO_TO_BEND = {EGO_TO_BEND}  # m", start]
    if plan.distance is None:
        return [f"EGO_AT = Range({number(plan.before)}, {number(plan.before + EGO_VARIES)})  # m along its lane"]
    if plan.place.kind == "crosswalk":
        return [f"EGO_TO_CROSSWALK = {quantity(plan.distance)}  # m", "EGO_AT = place.mark - EGO_TO_CROSSWALK"]
    if plan.ego_speed <= 0 and plan.distance == AT_THE_EDGE:
        return [f"EGO_AT = stop_line(place.lane) - {number(1 + LENGTH['car'] / 2)}  # m along its lane, at its line"]
    return [f"EGO_TO_JUNCTION = {quantity(plan.distance)}  # m", "EGO_AT = place.length - EGO_TO_JUNCTION"]

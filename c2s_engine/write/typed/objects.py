"""O1..N: road users, obstacles and things at the road."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase
from c2s_engine.write.typed import behaviour, reactions, scope
from c2s_engine.write.typed.collisions import meeting_spot
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.hiding import behind_what_ego_stops_for
from c2s_engine.write.typed.placement import Spot, place_object
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import (
    APPROACH_ANGLE,
    BLUEPRINTS,
    CLASS,
    LENGTH,
    OBSTRUCTING,
    ROLE,
    WORKS,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.threats import is_hit
from c2s_engine.write.typed.usual import from_lane, reach, speed_of, turn_of, walks_first

SETS_OUT = 8.0
"""m/s at which ego drives on that stands at first."""


def write_object(structure: Structure, cid: str, plan: Plan) -> str:
    """The fragment of one object."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    if spec.type in WORKS:
        spec = spec.model_copy(update={"count": 1})
        structure = structure.with_component(structure[cid].model_copy(update={"spec": spec}))
    spot = place_object(structure, cid, plan)
    name = scope.variables(structure)[cid]
    if spec.type in WORKS:
        return _works(spec, spot, name)
    lines: list[str] = []
    moving = not is_static(spec)
    speed = speed_of(spec, plan.place)
    prefix = scope.constant(structure, cid)
    if moving and high(speed) > 0:
        lines.append(f"{prefix}_SPEED = {scope.quantity(speed)}  # m/s")
    lines += spot.constants
    if moving:
        lines += ["", f"behavior {scope.camel(name)}Behavior():"]
        statements = (
            _walker(structure, cid, spec, plan, spot, prefix, speed)
            if is_walker(spec.type)
            else _driver(structure, cid, spec, plan, spot, prefix, speed)
        )
        lines += [f"    {s}" for s in statements] + [""]
    lines += _statement(spec, spot, name, moving)
    return "\n".join(lines)


def _statement(spec: ObjectSpec, spot: Spot, name: str, moving: bool) -> list[str]:
    extras = [f"with blueprint {_blueprint(spec)}"]
    role = spec.type if spec.model and spec.model == OBSTRUCTING.get(spec.type) else ROLE.get(spec.type)
    if spec.type == "speed_sign":
        role = f"speed_sign:{round((spec.limit or 13.9) * 3.6)}"
    if role:
        extras.append(f"with rolename '{role}'")
    if not (is_vehicle(spec.type) or is_walker(spec.type)) and not any(
        "regionContainedIn" in s for s in spot.specifiers
    ):
        extras.append("with regionContainedIn everywhere")
    if not is_vehicle(spec.type) and not any(s.startswith(("facing", "ahead of", "behind")) for s in spot.specifiers):
        extras.append("facing roadDirection")
    if spec.type == "bus":  # wider than most lanes
        extras.append("with regionContainedIn everywhere")
    if moving:
        extras.append(f"with behavior {scope.camel(name)}Behavior()")
    specifiers = list(dict.fromkeys([*spot.specifiers, *extras]))
    head = f"new {CLASS[spec.type]} {specifiers[0]}"
    if spec.count > 1:
        rest = ", ".join(specifiers[1:])
        return [f"{name} = [{head}, {rest}", f"    for i in range({spec.count})]"]
    return [f"{name} = {head},", *(f"    {s}," for s in specifiers[1:-1]), f"    {specifiers[-1]}"]


def _blueprint(spec: ObjectSpec) -> str:
    if spec.model:
        return f"'{spec.model}'"
    choices = BLUEPRINTS[spec.type]
    return f"'{choices[0]}'" if len(choices) == 1 else f"Uniform({', '.join(repr(c) for c in choices)})"


def _works(spec: ObjectSpec, spot: Spot, name: str) -> str:
    """Cones across and along the lane, a barrier and a sign: what makes a work zone or closes a lane."""
    where, origin = spot.specifiers[0], f"{name}_spot"
    made = where.startswith("at (new OrientedPoint")
    oriented = where.removeprefix("at ") if made else f"(new OrientedPoint {where}, facing roadDirection)"
    lines = [*spot.constants, f"{origin} = {oriented}"]
    looks = f"with blueprint {_blueprint(spec)}, with regionContainedIn everywhere"
    cone = f"new Cone at {origin} offset by {{x}} @ {{y}}, {looks}"
    rows = "((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))"
    lines.append(f"{name} = [{cone.format(x='x', y='y')}")
    lines.append(f"    for x, y in {rows}]")
    lines.append(
        f"{name}_barrier = new Barrier at {origin} offset by 0 @ 5, facing {origin}.heading + 90 deg,"
        " with blueprint 'static.prop.streetbarrier', with regionContainedIn everywhere"
    )
    if spec.type == "construction_zone":
        lines.append(
            f"{name}_sign = new TrafficWarning at {origin} offset by 0.4 @ -9, facing {origin}.heading,"
            " with blueprint 'static.prop.trafficwarning', with rolename 'warning_sign',"
            " with regionContainedIn everywhere"
        )
    return "\n".join(lines)


def _driver(
    structure: Structure,
    cid: str,
    spec: ObjectSpec,
    plan: Plan,
    spot: Spot,
    prefix: str,
    speed: float | tuple[float, float],
) -> list[str]:
    """The behaviour of a vehicle."""
    crossing = (
        spec.type == "bicycle" and any(p.action in ("cross_road", "enter_road") for p in spec.phases) and spot.off_road
    )
    if crossing:
        return _rider_across(structure, cid, spec, plan, prefix, speed)
    standing = high(speed) == 0
    actor = Actor(
        cid=cid,
        spec=spec,
        structure=structure,
        plan=plan,
        line=spot.line,
        lane=spot.lane,
        speed="0" if standing else f"{prefix}_SPEED",
        value=middle(speed),
        approach=spot.approach,
    )
    statements = behaviour.body(actor)
    struck = isinstance(structure.ego.spec, EgoSpec) and is_hit(structure.ego.spec, cid)
    own = {"collide", "yield", "stop", "wait", *(() if struck else ("run_stop",))} & {p.action for p in spec.phases}
    statements = reactions.heeding(actor, statements)
    timed = spot.approach and spec.placement.position in APPROACH_ANGLE
    if timed and plan.junction and not own and not standing:
        sooner = None if struck else _sooner(structure, spec, plan)
        bends = turn_of(spec.phases) != "STRAIGHT"
        first = scope.reference(structure, cid) if spec.count > 1 else "self"  # the others keep its pace
        statements = [_synchronised(s, prefix, sooner, bends, first) for s in statements]
        met = meeting_spot(plan) if struck else ["spot = meeting(line, way(egoLane, egoTurn))"]
        statements[1:1] = met
    if any(p.action == "run_red" for p in spec.phases):
        statements.insert(1, "take SetTrafficLightAction('red', distance=150)")
    return statements


def _synchronised(statement: str, prefix: str, sooner: float | None, bends: bool, first: str) -> str:
    """On a crossing way it (of a row its `first`) arrives when ego does, or a little sooner (s); None: ego hits it."""
    early = f", {scope.number(sooner)}" if sooner else ""
    timed = (
        f"strike(self, line, ego, others, spot, {prefix}_SPEED{', 0.9' if bends else ''})"
        if sooner is None
        else f"meet({first}, ego, spot, {prefix}_SPEED{early})"
    )
    for then in (")", ", offset="):  # a rate is stated for what it does of its own accord
        statement = statement.replace(f"do Drive(line, {prefix}_SPEED{then}", f"do Drive(line, lambda: {timed}{then}")
    return statement


def _sooner(structure: Structure, spec: ObjectSpec, plan: Plan) -> float:
    """How long (s) before ego the other passes: a near miss where ego does not give way; only `collide` is contact.

    Opposite ways run side by side for long, so that one who turns across needs a moment more.
    """
    ego = structure.ego.spec
    assert isinstance(ego, EgoSpec)
    turning = plan.place.manoeuvre != "straight" or turn_of(spec.phases) != "STRAIGHT"
    if ego.reaction in ("brake", "yield") or {"yield", "brake", "stop"} & {p.action for p in ego.phases}:
        if turn_of(spec.phases) != "STRAIGHT":
            return 2.0  # the bend slows it
        return 1.2 if turning and spec.placement.position == "opposite_approach" else 0
    if plan.place.manoeuvre != "straight":
        longer = max(LENGTH[spec.type] - 4.8, 0) / 6
        return -longer - max(2.2, 1 + 10 / max(plan.ego_speed or SETS_OUT, 1))  # ego is clear of it by then
    return 3.0 if turning else 1.8


def _to_lane(spec: ObjectSpec) -> str:
    """How far somebody is from the middle of the lane that ego then drives in, m."""
    lane = "exitLane" if spec.placement.position == "intersection_exit" else "egoLane"
    return f"{lane}.centerline.distanceTo(self.position)"


def _start_condition(structure: Structure, spec: ObjectSpec, phase: Phase, plan: Plan, walk: float) -> str:
    """When somebody sets out across the road: the stated trigger, or so that ego meets it on its lane."""
    t = phase.trigger
    other = scope.reference(structure, t.of) if t and t.of else "ego"
    if t and t.kind == "time":
        return f"simulation().currentTime * simulation().timestep >= {scope.number(middle(t.value or 2))}"
    if t and t.kind == "ttc" and t.value is not None:
        return f"(distance from self to {other}) < {scope.number(middle(t.value))} * max({other}.speed, 3) + 2.5"
    if t and t.value is not None and t.kind == "distance":
        return f"(distance from self to {other}) < {scope.number(middle(t.value))}"
    if t and t.kind == "action":
        return f"{other}.speed < 0.5" if t.action in ("stop", "stationary") else f"(distance from self to {other}) < 25"
    seconds = scope.number(reach(spec, plan.place) / max(walk, 0.3))
    if from_lane(spec, plan.place):
        seconds = f"{_to_lane(spec)} / {scope.number(max(walk, 0.3))}"
    speed = "max(ego.speed, EGO_SPEED)" if spec.count > 1 else "ego.speed"  # it may already brake for the first of them
    near = scope.number(4 + behind_what_ego_stops_for(structure, spec))
    return f"(distance from self to ego) < {seconds} * {speed} + {near}"


def _is_struck(structure: Structure, cid: str, spec: ObjectSpec) -> bool:
    """Whether ego is to hit it (or it ego): then it is still in the lane when ego comes."""
    ego = structure.ego.spec
    return isinstance(ego, EgoSpec) and is_hit(ego, cid) or any(p.action == "collide" for p in spec.phases)


def _walker(
    structure: Structure,
    cid: str,
    spec: ObjectSpec,
    plan: Plan,
    spot: Spot,
    prefix: str,
    speed: float | tuple[float, float],
) -> list[str]:
    """The behaviour of somebody on foot."""
    lines: list[str] = []
    pace = f"{prefix}_SPEED" if high(speed) > 0 else scope.number(2.2 if spec.type == "child" else 1.4)
    value = middle(speed) or 1.4
    phases = spec.phases or (Phase(action="move_along"),)
    struck = _is_struck(structure, cid, spec)
    heading = "self.heading"
    for i, phase in enumerate(phases):
        last = i == len(phases) - 1
        own = scope.quantity(phase.speed) if phase.speed is not None and i > 0 else pace
        if phase.action in ("cross_road", "enter_road", "collide"):
            if i == 0 and low(speed) == 0 or phase.trigger or i == 0:
                lines += [f"while not ({_start_condition(structure, spec, phase, plan, value)}):", "    wait"]
            if walks_first(spec):
                heading = f"self.heading {'-' if spec.placement.side == 'left' else '+'} 90 deg"
            step = f"do Walk({heading}, {own})"
        elif phase.action in ("stop", "stationary", "wait", "yield"):
            step = "do Walk(self.heading, 0)"
        else:
            step = f"do Walk({heading}, {own})"
        ending = f" for {scope.quantity(phase.duration)} seconds" if phase.duration is not None else ""
        if last and struck and phase.action in ("cross_road", "enter_road", "collide"):
            there = f"for {scope.number(reach(spec, plan.place) / max(value, 0.3))} seconds"
            there = f"until {_to_lane(spec)} < 0.4" if from_lane(spec, plan.place) else there
            lines += [f"{step} {there}", "do Walk(self.heading, 0)"]
            break
        if phase.action == "yield" and not ending:
            ending = f" until passed({scope.reference(structure, phase.target) if phase.target else 'ego'}, self, 0)"
        if not ending and not last:
            following = phases[i + 1]
            if following.trigger and following.trigger.kind == "distance" and following.trigger.value is not None:
                ending = f" until (distance from self to ego) < {scope.number(middle(following.trigger.value))}"
            elif walks_first(spec) and following.action == "cross_road" and following.trigger is None:
                ending = f" until {_start_condition(structure, spec, following, plan, value)}"
            else:
                crossing = phase.action in ("cross_road", "enter_road")
                ending = f" for {scope.number(4.5 / max(value, 0.3) if crossing else 2)} seconds"
        lines.append(step + ending)
    return lines


def _rider_across(
    structure: Structure, cid: str, spec: ObjectSpec, plan: Plan, prefix: str, speed: float | tuple[float, float]
) -> list[str]:
    """A cyclist that crosses the road from beside it."""
    value = middle(speed) or 4.0
    phase = next(p for p in spec.phases if p.action in ("cross_road", "enter_road"))
    own = f"{prefix}_SPEED" if high(speed) > 0 else scope.number(value)
    lines = [
        f"while not ({_start_condition(structure, spec, phase, plan, value)}):",
        "    wait",
        "line = straight_on(self)",
        f"take SetSpeedAction({own})",
        f"do Drive(line, {own})",
    ]
    ego = structure.ego.spec
    if isinstance(ego, EgoSpec) and is_hit(ego, cid):  # it is still there when ego comes
        lines[-1:] = [f"do Drive(line, {own}) until {_to_lane(spec)} < 1", "do Drive(line, 0, rate=8)"]
    return lines

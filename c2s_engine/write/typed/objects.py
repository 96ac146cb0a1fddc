"""O1..N: road users, obstacles and things at the road."""

import re

from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import high, middle
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import behaviour, heeding, people, scope, walkers
from c2s_engine.write.typed.course import Actor
from c2s_engine.write.typed.placement import Spot, place_object
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import (
    BLUEPRINTS,
    CLASS,
    HEIGHT,
    LENGTH,
    NAMED_BLUEPRINTS,
    OBSTRUCTING,
    ROLE,
    ROLLING,
    USUAL_HEIGHT,
    WIDTH,
    WORKS,
    is_rolling,
    is_static,
    is_vehicle,
    is_walker,
)
from c2s_engine.write.typed.usual import crosses, speed_of


def write_object(structure: Structure, cid: str, plan: Plan) -> str:
    """The fragment of one object."""
    spec = structure[cid].spec
    assert isinstance(spec, ObjectSpec)
    if spec.type in WORKS:
        spec = spec.model_copy(update={"count": 1})
        structure = structure.with_spec(cid, spec)
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
    lines += [*spot.constants, *people.constants(structure, cid, plan)]
    behavior = ""
    if moving:
        statements = (
            walkers.walker(structure, cid, plan)
            if is_walker(spec)
            else _driver(structure, cid, spec, plan, spot, prefix, speed)
        )
        behavior = _cruises(statements) or f"{scope.camel(name)}Behavior()"
        if not _cruises(statements):
            lines += ["", f"behavior {behavior}:", *(f"    {s}" for s in statements), ""]
    lines += _statement(spec, spot, name, behavior)
    return "\n".join(lines)


def _cruises(statements: list[str]) -> str:
    """The library's behaviour for who drives its way at its speed and no more; "": it does more than that."""
    drives = r"line = (.+)\ntake SetSpeedAction\((\w+)\)\ndo Drive\(line, \2(?:, rate=[\d.]+)?\)"
    found = re.fullmatch(drives, "\n".join(statements))
    return f"Cruise({found[1]}, {found[2]})" if found else ""


def _statement(spec: ObjectSpec, spot: Spot, name: str, behavior: str) -> list[str]:
    extras, rolls = [f"with blueprint {_blueprint(spec)}"], is_rolling(spec)
    role = spec.type if spec.model and spec.model == OBSTRUCTING.get(spec.type) else ROLE.get(spec.type)
    role = ROLLING["role"] if rolls else role
    if spec.type == "speed_sign":
        role = f"speed_sign:{round((spec.limit or 13.9) * 3.6)}"
    if role:
        extras.append(f"with rolename '{role}'")
    if not (is_vehicle(spec.type) or is_walker(spec)) and not any(
        "regionContainedIn" in s for s in spot.specifiers
    ):
        extras.append("with regionContainedIn everywhere")
    if not is_vehicle(spec.type) and not any(s.startswith(("facing", "ahead of", "behind")) for s in spot.specifiers):
        extras.append("facing roadDirection")
    if spec.type == "bus":  # wider than most lanes
        extras.append("with regionContainedIn everywhere")
    if spec.type in HEIGHT or rolls:
        height = HEIGHT.get(spec.type, USUAL_HEIGHT)
        size = {"length": LENGTH[spec.type], "width": WIDTH[spec.type], "height": height}
        said = " ".join(spot.specifiers)
        extras += [f"with {k} {scope.number(m)}" for k, m in size.items() if f"with {k} " not in said]
    if any(p.action == "run_red" for p in spec.phases):
        extras.append("with light 'red'")
    if behavior:
        extras.append(f"with behavior {behavior}")
    specifiers = list(dict.fromkeys([*spot.specifiers, *extras]))
    head = f"new {ROLLING['class'] if rolls else CLASS[spec.type]} {specifiers[0]}"
    if spec.count > 1:
        rest = [f"    {s}," for s in specifiers[1:-1]]
        return [f"{name} = [{head},", *rest, f"    {specifiers[-1]} for i in range({spec.count})]"]
    return [f"{name} = {head},", *(f"    {s}," for s in specifiers[1:-1]), f"    {specifiers[-1]}"]


def _blueprint(spec: ObjectSpec) -> str:
    if is_rolling(spec):
        return f"'{ROLLING['blueprint']}'"
    if spec.model:
        return f"'{spec.model}'"
    named = NAMED_BLUEPRINTS.get(spec.type)
    return f"Uniform(*{named})" if named else f"'{BLUEPRINTS[spec.type][0]}'"


def _works(spec: ObjectSpec, spot: Spot, name: str) -> str:
    """Cones across and along the lane, a barrier and a sign: what makes a work zone or closes a lane."""
    where, origin = spot.specifiers[0], f"{name}_spot"
    facing = next((s for s in spot.specifiers if s.startswith("facing")), "facing roadDirection")
    lines = [*spot.constants, f"{origin} = new OrientedPoint {where}, {facing}"]
    looks = f"with blueprint {_blueprint(spec)}, with regionContainedIn everywhere"
    rows = "((-1.4, -6), (-0.5, -4), (0.5, -2), (1.4, 0), (1.4, 4), (1.4, 8))"
    lines += [f"{name} = [new Cone at {origin} offset by x @ y, {looks}", f"    for x, y in {rows}]"]
    lines += [
        f"{name}_barrier = new Barrier at {origin} offset by 0 @ 5, facing {origin}.heading + 90 deg,",
        "    with blueprint 'static.prop.streetbarrier', with regionContainedIn everywhere",
    ]
    if spec.type == "construction_zone":
        lines += [
            f"{name}_sign = new TrafficWarning at {origin} offset by 0.4 @ -9, facing {origin}.heading,",
            "    with blueprint 'static.prop.trafficwarning', with rolename 'warning_sign',",
            "    with regionContainedIn everywhere",
        ]
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
    if spot.off_road and crosses(spec):
        return walkers.rider(structure, cid, plan)
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
    return heeding.heeding(actor, statements)

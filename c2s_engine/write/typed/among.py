"""A fragment among code of somebody else's: what it needs and that program does not define comes before it.

A program that c2s wrote imports the driving library, draws a `place` and starts ego there. One by hand does none of it:
there the place is read from where its ego stands.
"""

import re
from functools import cache
from itertools import takewhile

from c2s_engine import driving
from c2s_engine.maps.expressions import MANOEUVRE_TYPE
from c2s_engine.structure import layout, names
from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.typed import scope
from c2s_engine.write.typed.place import sources
from c2s_engine.write.typed.plan import Plan
from c2s_engine.write.typed.tables import CLASS, JUNCTION, LENGTH, WIDTH, is_vehicle
from c2s_engine.write.typed.usual import speed_of

PREFIX = "c2s_"
"""Begins the names that a fragment goes by where the program's own mean something else."""
_OF_CARLA = re.compile(r"^model scenic\.simulators\.carla\.model\b", re.MULTILINE)
IN_DOMAIN = {"Car", "Pedestrian"}
"""The classes of S's types that every model of the driving domain has."""


def among(structure: Structure, cid: str, body: str, plan: Plan) -> str:
    """An object's fragment, with the names that it needs of the library, of the place and of others before it."""
    own = _own(structure)
    place = structure.place
    ours_too = place.origin not in layout.OWN and "place" in names.defines(place.code)  # ego's code alone is by hand
    if structure.ego.origin not in layout.OWN or ours_too or driving.used_by(own):
        return body
    before = takewhile(lambda c: c.id != cid, structure.objects)
    earlier = "\n".join(c.code for c in before if c.origin not in layout.OWN)
    theirs, ours = names.defines(own), names.defines(earlier).keys() | set(driving.imported(earlier).values())
    values = _values(structure, plan) | ({} if _OF_CARLA.search(own) else _classes())
    called = {n: PREFIX + n for n in theirs if n in driving.names() or n in ("place", "EGO_AT")}
    lines: list[str] = []
    library: set[str] = set()
    done = {*ours, *(n for n in theirs if n not in called), *names.defines(body)}

    def need(code: str) -> None:
        """Put what a piece of code rests on before it."""
        for name in sorted(names.uses(code)):
            if called.get(name, name) in done:
                continue
            if name in values:
                done.add(called.get(name, name))
                need(values[name])
                lines.append(values[name] if "\n" in values[name] else f"{name} = {values[name]}")
            elif name in driving.names():
                library.add(name)

    body = body.replace("place.lane.rightEdge", "place.lane.group.rightEdge")  # on whatever lane ego is
    need(body)
    shown = [f"{n} as {called[n]}" if n in called else n for n in sorted(library)]
    head = [f"from {driving.MODULE} import {', '.join(shown)}"] if shown else []
    return "\n".join([*head, *(names.renamed(line, called) for line in [*lines, body])])


def _own(structure: Structure) -> str:
    """The code of a program that is somebody else's, and the lines of nobody."""
    kept = [text for owner, text in structure.arrangement if owner == layout.FREE]
    return "\n".join([*kept, *(c.code for c in structure.components if c.origin in layout.OWN)])


def _values(structure: Structure, plan: Plan) -> dict[str, str]:
    """What fragments of a program of ours may rest on, read from where the actors of another stand."""
    turn = f", {MANOEUVRE_TYPE[plan.place.manoeuvre or 'straight']}" if plan.place.kind in JUNCTION else ""
    others = f", [{', '.join(sources(plan))}]" if turn and plan.ways_of_others else ""
    found = {"place": f"place_of(ego{turn}{others})", "EGO_AT": "metres_along(place.lane, ego)"}
    found["EGO_SPEED"] = f"{scope.number(plan.ego_speed)}  # m/s"
    for component in structure.objects:
        if isinstance(component.spec, ObjectSpec):
            prefix = scope.constant(structure, component.id)
            found[f"{prefix}_AT"] = f"metres_along(place.lane, {scope.reference(structure, component.id)})"
            found[f"{prefix}_SPEED"] = f"{scope.number(middle(speed_of(component.spec, plan.place)))}  # m/s"
    return found


@cache
def _classes() -> dict[str, str]:
    """The classes of CARLA's model that the driving domain lacks, as large as the first type that is one."""
    found: dict[str, str] = {}
    for kind, name in CLASS.items():
        if name not in IN_DOMAIN:
            base = "Vehicle" if is_vehicle(kind) else "DrivingObject"
            size = f"    width: {scope.number(WIDTH[kind])}\n    length: {scope.number(LENGTH[kind])}\n"
            found.setdefault(name, f"class {name}({base}):\n{size}")
    return found

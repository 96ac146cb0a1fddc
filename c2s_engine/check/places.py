"""How many places of a map an expression matches, and where they are."""

import socket
from types import CodeType
from typing import Any

from c2s_engine.check import confine, wire

SHOWN = 50


def answer(conn: socket.socket, job: dict[str, Any], prepared: dict[str, Any]) -> None:
    """Evaluate the expressions in the names that a program with this map has."""
    confine.confine(job)
    namespace = dict(prepared["namespace"])
    prepared["veneer"].deactivate()
    counts: dict[str, int] = {}
    errors: dict[str, str] = {}
    at: dict[str, list[tuple[float, float]]] = {}
    for name, expression in job["expressions"].items():
        try:
            found = list(eval(_compiled(expression), namespace))
            counts[name] = len(found)
            at[name] = [p for p in map(position, found[:SHOWN]) if p is not None]
            if found and job.get("first"):
                break
        except Exception as error:
            counts[name] = 0
            errors[name] = f"{type(error).__name__}: {error}"
    wire.send(conn, {"places": {"counts": counts, "errors": errors, "at": at}})
    wire.send(conn, {"end": True})


def _compiled(expression: str) -> CodeType:
    """An expression of Scenic's (`-90 deg` is none of Python's), compiled."""
    from scenic.syntax.compiler import compileScenicAST
    from scenic.syntax.parser import parse_string

    return compile(compileScenicAST(parse_string(expression, "eval"))[0], "<place>", "eval")


def position(thing: Any) -> tuple[float, float] | None:
    """A point (m) on a road element, the start of a manoeuvre, or the first member of a tuple."""
    if isinstance(thing, tuple | list) and thing:
        return position(thing[0])
    if hasattr(thing, "startLane"):
        thing = thing.startLane
    line = getattr(thing, "centerline", None)
    if line is not None and getattr(line, "lineString", None) is not None:
        point = line.lineString.interpolate(0.5, normalized=True)
    elif getattr(thing, "polygons", None) is not None:
        point = thing.polygons.representative_point()
    elif hasattr(thing, "x") and hasattr(thing, "y"):
        return float(thing.x), float(thing.y)
    else:
        return None
    return float(point.x), float(point.y)

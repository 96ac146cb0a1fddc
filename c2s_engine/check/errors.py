"""What an exception means to the author of a program: cause, code, fix, edit."""

import dataclasses
import re
import sys
import traceback
from dataclasses import dataclass

from c2s_engine.check import catalogue, fixes
from c2s_engine.check.likeness import near
from c2s_engine.structure.diagnostics import StageName, TextEdit


@dataclass(frozen=True)
class Explained:
    message: str
    code: str = ""
    fix: str = ""
    edit: TextEdit | None = None
    line: int | None = None  # where it is another line than that of the exception


def explain(error: BaseException, stage: StageName, lines: list[str], number: int | None) -> Explained:
    """The explanation of an exception that was raised on a line (1-based) of the program."""
    text = _text(error)
    line = lines[number - 1].rstrip("\r\n") if number is not None and 1 <= number <= len(lines) else ""
    kinds = [k.__name__ for k in type(error).__mro__]
    found = catalogue.find(kinds, text, line, _raised_in(error))
    if found is None:
        return Explained(message=f"{type(error).__name__}: {text}", code=type(error).__name__)
    entry, values = found
    if entry.code == "no_attribute":
        values |= _members(values["of"], values["name"])
    edit = fixes.propose(entry, values, lines, number)
    if entry.code == "missing_comma" and edit is None and number is not None:
        head = fixes.head_of(lines, number)
        if head != number:
            return dataclasses.replace(explain(error, stage, lines, head), line=head)
    return Explained(
        message=catalogue.fill(entry.message, values),
        code=entry.code,
        fix=catalogue.fill(entry.fix, values),
        edit=edit,
    )


def _members(kind: str, name: str) -> dict[str, str]:
    """What an element of the road network offers instead of an attribute that it lacks, and the nearest of that."""
    known = getattr(sys.modules.get("scenic.domains.driving.roads"), kind, None)
    if not isinstance(known, type):
        return {"near": "", "members": ""}
    offered = {n for k in known.__mro__ for n in (*getattr(k, "__annotations__", ()), *_properties(k)) if n[0] != "_"}
    return {"near": near(name, offered), "members": ", ".join(sorted(offered - _INNER))}


def _properties(kind: type) -> list[str]:
    return [name for name, value in vars(kind).items() if isinstance(value, property)]


_INNER = {
    "uid", "id", "tags", "network", "pickledExt", "tolerance", "elements", "polygon", "polygons", "vehicleTypes",
    "name", "AABB", "area", "boundary", "dimensionality", "footprint", "inradius", "points", "size",
}  # fmt: skip
"""Attributes of road elements that programs do not need."""


def _raised_in(error: BaseException) -> str:
    """The name of the function that raised it; empty where it was not raised."""
    frames = traceback.extract_tb(error.__traceback__, limit=-1)
    return frames[0].name if frames else ""


def _text(error: BaseException) -> str:
    text = str(error) or type(error).__name__
    return re.sub(r" object at 0x[0-9a-f]+", "", text)[:500]

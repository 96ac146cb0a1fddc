"""Scenic 2 to Scenic 3, where that is certain: `new` before objects, monitors with parentheses, units of durations."""

import ast
import difflib
import re
from typing import Any

from c2s_engine.check import diagnose, fixes, pieces

CERTAIN = frozenset({"old_monitor", "duration_unit", "forgot_new", "missing_comma"})
ROUNDS = 200
_SPECIFIER = (
    r"at|on|in|with|ahead|behind|left|right|following|facing|offset|beyond|visible|not|apparently|using|contained"
)


def upgraded(text: str, filename: str) -> str:
    """The program in Scenic 3; raises what the parser raises where that needs more than certain edits."""
    first: Exception | None = None
    try:
        if not _objects_without_new(pieces.parse(text, filename)):
            return text
    except Exception as old:
        first = old
    error: Exception | None = first
    newer = _insert_new(text)
    for _ in range(ROUNDS):
        error = _error(newer, filename)
        if error is None:
            return newer
        program = diagnose.Program(newer, filename)
        found = diagnose.diagnose(error, "parse", program)
        if found.code not in CERTAIN or found.edit is None:
            break
        newer = fixes.apply_fixes(newer, [found])
    raise first or error or ValueError("the program cannot be upgraded")


def _error(text: str, filename: str) -> Exception | None:
    try:
        pieces.parse(text, filename)
    except Exception as error:
        return error
    return None


def _objects_without_new(tree: Any) -> bool:
    """Whether a class is used where only an object makes sense: `Car at x` parses, but as an operator."""
    from scenic.syntax import ast as s

    from c2s_engine.check.importer import table

    known = set(table()["types"]) | set(table()["points"])
    operators = tuple(k for k in (getattr(s, n, None) for n in ("FieldAtOp", "AtOp", "OffsetAlongOp")) if k)
    for node in ast.walk(tree):
        if isinstance(node, operators):
            left: Any = getattr(node, "left", None) or getattr(node, "base", None)
            if isinstance(left, ast.Name) and left.id in known:
                return True
        if isinstance(node, s.TrackedAssign) and isinstance(node.value, ast.Name) and node.value.id in known:
            return True
    return False


def _insert_new(text: str) -> str:
    """`new` before every class that begins an object: the table's classes, and those that the program derives."""
    from c2s_engine.check.importer import table

    own = re.findall(r"^class\s+(\w+)", text, re.M)
    names = "|".join(sorted({*table()["types"], *table()["points"], *own, "Object"}, key=len, reverse=True))
    pattern = re.compile(
        rf"(?P<before>^[ \t]*|=[ \t]*|[(\[,][ \t]*|\breturn[ \t]+|\b(?:at|from|to|of|on|by)[ \t]+)(?P<name>{names})\b"
        rf"(?=[ \t]+(?:{_SPECIFIER})\b|[ \t]*(?:#.*)?$|[ \t]*,[ \t]*(?:#.*)?$)",
        re.M,
    )
    return pattern.sub(lambda m: f"{m['before']}new {m['name']}", text)


def difference(old: str, new: str, filename: str) -> str:
    """The change as a unified diff; empty where there is none."""
    if old == new:
        return ""
    return "".join(
        difflib.unified_diff(
            old.splitlines(keepends=True), new.splitlines(keepends=True), filename, f"{filename} (Scenic 3)"
        )
    )

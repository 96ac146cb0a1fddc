"""Scenic 2 to Scenic 3, where that is certain.

`new` before objects, monitors with parentheses, units of durations, `following ... for`, numbers that were given in
quotes, ranges in requirements. Words in comments and strings stay as they are.
"""

import ast
import difflib
import io
import re
import tokenize
from typing import Any

from c2s_engine.check import diagnose, fixes, pieces
from c2s_engine.check.describe import table
from c2s_engine.structure.diagnostics import Diagnostic

CERTAIN = frozenset({"old_monitor", "duration_unit", "forgot_new", "missing_comma", "following_by"})
ROUNDS = 200
_SPECIFIER = (
    r"at|on|in|with|ahead|behind|left|right|following|facing|offset|beyond|visible|not|apparently|using|contained"
)


class NotUpgraded(Exception):
    """What is left to be said of a program that certain edits do not make Scenic 3; located in the program as given."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


def upgraded(text: str, filename: str) -> str:
    """The program in Scenic 3; raises NotUpgraded where that needs more than certain edits."""
    first: Exception | None = None
    try:
        if not _objects_without_new(pieces.parse(text, filename)):
            return text
    except Exception as old:
        first = old
    newer = _quoted_numbers(_insert_new(text))
    good: set[str] = set()
    for _ in range(ROUNDS):
        error = _error(newer, filename, good)
        if error is None:
            return _ranges_in_requirements(newer, filename, good)
        found = diagnose.diagnose(error, "parse", diagnose.Program(newer, filename))
        if found.code not in CERTAIN or found.edit is None:
            break
        newer = fixes.apply_fixes(newer, [found])
    if newer == text and first is not None:
        raise first
    raise NotUpgraded(_in_the_original(found, text, newer, filename))


def _in_the_original(found: Diagnostic, text: str, newer: str, filename: str) -> Diagnostic:
    """A diagnostic of the upgraded text, at the line of the text as given; its edit would not fit there."""
    if found.line is None:
        return found
    old, new = text.split("\n"), newer.split("\n")
    for _, i1, i2, j1, j2 in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if j1 <= found.line - 1 < j2:
            line = min(i1 + found.line - 1 - j1, max(i1, i2 - 1)) + 1
            moved = found.model_copy(update={"line": line, "column": None, "text": "", "edit": None})
            return diagnose.Program(text, filename).locate(moved)
    return found


def _error(text: str, filename: str, good: set[str]) -> Exception | None:
    """What the parser raises, statement by statement; those in `good` are known to pass."""
    try:
        parts = pieces.cut(text)
    except pieces.Cut:
        parts = [pieces.Piece(1, text.count("\n") + 1, text)]
    for part in parts:
        if part.text in good:
            continue
        try:
            pieces.parse(part.text, filename, part.first - 1)
        except Exception as error:
            return error
        good.add(part.text)
    return None


def _objects_without_new(tree: Any) -> bool:
    """Whether a class is used where only an object makes sense: `Car at x` parses, but as an operator."""
    from scenic.syntax import ast as s

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
    own = re.findall(r"^class\s+(\w+)", text, re.M)
    names = "|".join(sorted({*table()["types"], *table()["points"], *own, "Object"}, key=len, reverse=True))
    before = r"^[ \t]*|=[ \t]*|[(\[,][ \t]*|\breturn[ \t]+|\b(?:at|from|to|of|on|by|else)[ \t]+"
    after = rf"[ \t]+(?:{_SPECIFIER})\b|[ \t]*(?:#.*)?$|[ \t]*\\$|(?P<more>[ \t]*,[ \t]*(?:#.*)?$)"
    words = _no_code(text)

    def made(match: re.Match[str]) -> str:
        begins = match["before"].strip() in ("", "=") and not _in_a_list(text[: match.start()])
        if match.start("name") in words or (match["more"] and not begins):
            return match[0]
        return f"{match['before']}new {match['name']}"

    return re.sub(rf"(?P<before>{before})(?P<name>{names})\b(?={after})", made, text, flags=re.M)


def _in_a_list(before: str) -> bool:
    """Whether the line before the end of a text goes on as a list does."""
    return before.rstrip().endswith((",", "(", "["))


def _no_code(text: str) -> set[int]:
    """The offsets of what stands in comments and strings."""
    starts = [0]
    for line in io.StringIO(text, newline="\n"):
        starts.append(starts[-1] + len(line))
    found: set[int] = set()
    try:
        for token in tokenize.generate_tokens(io.StringIO(text, newline="\n").readline):
            if token.type in (tokenize.COMMENT, tokenize.STRING):
                (row, column), (last, end) = token.start, token.end
                found.update(range(starts[row - 1] + column, starts[last - 1] + end))
    except (tokenize.TokenError, IndentationError, SyntaxError):
        pass
    return found


def _quoted_numbers(text: str) -> str:
    """`param render = '0'`: Scenic 2 took a text where Scenic 3 wants the number."""
    return re.sub(r"^(param[ \t]+render[ \t]*=[ \t]*)(['\"])([01])\2", r"\1\3", text, flags=re.M)


def _ranges_in_requirements(text: str, filename: str, good: set[str]) -> str:
    """`require X in Range(a, b)` with numbers: nothing may be drawn in a requirement, which compares instead."""
    number = r"-?\d+(?:\.\d+)?"
    ends = rf"Range\([ \t]*({number})[ \t]*,[ \t]*({number})[ \t]*\)(?=[ \t]*(?:#.*)?$)"
    newer = re.sub(rf"^(require[ \t]+)([^#\n]+?)[ \t]+in[ \t]+{ends}", r"\1\3 <= \2 <= \4", text, flags=re.M)
    return newer if newer == text or _error(newer, filename, good) is None else text


def difference(old: str, new: str, filename: str) -> str:
    """The change as a unified diff; empty where there is none."""
    if old == new:
        return ""
    lines = difflib.unified_diff(
        old.splitlines(keepends=True), new.splitlines(keepends=True), filename, f"{filename} (Scenic 3)"
    )
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)

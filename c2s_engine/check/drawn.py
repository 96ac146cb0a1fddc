"""Remedies where a program treats a value that is drawn at random as if it were there already, as edits of its line."""

import re

from c2s_engine.structure.diagnostics import TextEdit

_ELEMENTS = (
    "lanes|laneGroups|sections|maneuvers|incomingLanes|outgoingLanes|roads|adjacentLanes|crossings|sidewalks|signals|"
    "conflictingManeuvers|reverseManeuvers|forwardLanes|backwardLanes"
)
_OF_ELEMENT = re.compile(rf"\b(\w+(?:\.\w+)*\.(?:{_ELEMENTS}))\[(-?\d+)\]")
_INDEXED = re.compile(r"\b(\w+(?:\.\w+)*)\[(-?\d+)\]")
_COMPREHENSION = re.compile(r"\[\s*(?P<v>\w+)\s+for\s+(?P=v)\s+in\s+(?P<of>[\w.]+)\s+if\s+(?P<that>[^\[\]]+?)\s*\]")
_UNPACKED = re.compile(r"^(?P<names>\w+(?:\s*,\s*\w+)+)\s*=\s*(?P<value>\w+)\s*(?P<rest>#.*)?$")
_CERTAIN = {"ManeuverType", "is", "not", "and", "or", "in", "None", "True", "False", "len", "abs"}
"""Names that a condition may use beside its variable and still be certain before anything is drawn."""


def index(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """`g.lanes[1]` becomes `Uniform(*g.lanes[1:2])`, the same lane: Scenic types a slice rightly, an index not.

    Without the name of a list of the road network, only a line with a single candidate is changed."""
    line = lines[number - 1].rstrip("\r\n")
    pattern = _OF_ELEMENT if _missed(_OF_ELEMENT, line) else _INDEXED
    if pattern is _INDEXED and len(_missed(pattern, line)) != 1:
        return None
    return _edit(line, pattern.sub(_sliced, line), number, reason)


def _missed(pattern: re.Pattern[str], line: str) -> list[str]:
    return [m[0] for m in pattern.finditer(line) if m[2] not in ("0", "-1")]


def _sliced(match: re.Match[str]) -> str:
    at = int(match[2])
    return match[0] if at in (0, -1) else f"Uniform(*{match[1]}[{at}:{at + 1}])"


def comprehension(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """`[v for v in X if C]` becomes `filter(lambda v: C, X)`, where C is certain of every v."""
    line = lines[number - 1].rstrip("\r\n")
    found = _COMPREHENSION.search(line)
    if not found or set(re.findall(r"(?<![\w.'\"])[A-Za-z_]\w*", found["that"])) - _CERTAIN - {found["v"]}:
        return None
    kept = f"filter(lambda {found['v']}: {found['that']}, {found['of']})"
    return _edit(line, line[: found.start()] + kept + line[found.end() :], number, reason)


def unpacking(lines: list[str], number: int, reason: str) -> TextEdit | None:
    """`a, b = pair` becomes `a, b = pair[0], pair[1]`."""
    line = lines[number - 1].rstrip("\r\n")
    found = _UNPACKED.match(line)
    if not found:
        return None
    members = ", ".join(f"{found['value']}[{i}]" for i in range(len(found["names"].split(","))))
    return _edit(line, f"{found['names']} = {members}  {found['rest'] or ''}".rstrip(), number, reason)


def _edit(line: str, changed: str, number: int, reason: str) -> TextEdit | None:
    return TextEdit(first=number, last=number, text=changed, reason=reason) if changed != line else None

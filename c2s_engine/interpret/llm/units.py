"""Quantities of a text with their SI values beside them: small models fill fields well and convert units badly."""

import re
from functools import partial

_NUMBER = r"(?<![\w.])(\d+(?:[.,]\d+)?)(?:\s*(?:-|–|to|and)\s*(\d+(?:[.,]\d+)?))?\s*"
_UNITS = (
    (r"(?:km/h|kmh|kph|km per hour|kilomet(?:re|er)s per hour)", 1 / 3.6, "m/s"),
    (r"(?:mph|mi/h|miles per hour)", 0.44704, "m/s"),
    (r"(?:feet|foot|ft)\b", 0.3048, "m"),
    (r"(?:yards?|yd)\b", 0.9144, "m"),
    (r"g(?=[\s.,;)]|$)", 9.81, "m/s2"),
)


_NOTE = re.compile(r"\s*\[= [^\]]*\]")


def plain(text: str) -> str:
    """The text without such notes."""
    return _NOTE.sub("", text)


def annotate(text: str) -> str:
    """The text, with `[= 13.9 m/s]` after each quantity that is not in SI units; a text that has its notes stays."""
    text = plain(text)
    for unit, factor, name in _UNITS:
        text = re.sub(_NUMBER + unit, partial(_with_value, factor, name), text, flags=re.I)
    return text


def _with_value(factor: float, name: str, match: re.Match[str]) -> str:
    return f"{match[0]} [= {_value(match, factor)} {name}]"


def _value(match: re.Match[str], factor: float) -> str:
    values = [float(g.replace(",", ".")) * factor for g in match.groups() if g]
    return " to ".join(f"{v:.1f}" for v in values)


_SI = ((r"m(?:et(?:re|er)s?)?(?![\w/])", 1.0), (r"s(?:ec(?:ond)?s?)?\b(?!\w)", 1.0), (r"m/s2?(?!\w)", 1.0))


def quantities(text: str) -> list[tuple[str, float]]:
    """Each number with a unit as it stands in a text, with its SI value (both ends of a range)."""
    found: list[tuple[int, str, float]] = []
    for unit, factor in (*((u, f) for u, f, _ in _UNITS), *_SI):
        for match in re.finditer(_NUMBER + unit, plain(text), flags=re.I):
            ends = [float(g.replace(",", ".")) * factor for g in match.groups() if g]
            found += [(match.start(), match[0].strip(), value) for value in ends]
    return [(words, value) for _, words, value in sorted(found)]

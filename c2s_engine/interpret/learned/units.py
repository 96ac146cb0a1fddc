"""S back into plain data with the quantities of its text, as the scenes have them."""

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.learned.quantities import DIMENSIONS, UNITS, si
from c2s_engine.structure.components import Structure

OF_FIELD = {
    **dict.fromkeys(("speed", "limit", "speed_limit", "lateral_speed"), "m/s"), "rate": "m/s2",
    **dict.fromkeys(("duration", "delay", "arrives", "later"), "s"),
}  # fmt: skip
"""The SI unit of a field; else m."""
OF_TRIGGER = {"ttc": "s", "time": "s", "speed": "m/s"}
OF_LIMIT = {"speed": "m/s", "acceleration": "m/s2", "deceleration": "m/s2", "lateral_acceleration": "m/s2",
            "jerk": "m/s3", "ttc": "s", "time": "s"}  # fmt: skip
WORDS = {
    **dict.fromkeys(("kph", "kmh", "kilometres per hour", "kilometers per hour", "kilometres an hour"), "km/h"),
    **dict.fromkeys(("miles per hour", "miles an hour"), "mph"), "metres per second": "m/s", "meters per second": "m/s",
    **dict.fromkeys(("metres", "meters", "metre", "meter"), "m"), **dict.fromkeys(("feet", "foot"), "ft"),
    **dict.fromkeys(("yards", "yard"), "yd"), **dict.fromkeys(("seconds", "second", "secs", "sec"), "s"),
    "m/s²": "m/s2",
}  # fmt: skip
NOT_MEASURED = ("arms", "lanes", "lanes_over", "count")
LEFT_OUT = ("component", "later", "model", "preset", "parameters", "map")
ONES = {word: number for number, word in enumerate([
    "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve",
    "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"])}  # fmt: skip
TENS = {word: 10 * number for number, word in enumerate(
    ["twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety", "hundred"], 2)}  # fmt: skip
_SPELT = rf"(?:(?:{'|'.join(TENS)})[\s-](?:{'|'.join(ONES)})|one hundred|{'|'.join((*TENS, *ONES))})"
_UNIT = "|".join(map(re.escape, sorted((*UNITS, *WORDS), key=len, reverse=True)))
_TOLD = re.compile(rf"\b(?:(\d+(?:\.\d+)?)[\s-]*|({_SPELT})[\s-])({_UNIT})(?![\w/])", re.IGNORECASE)


def quantities(text: str) -> list[tuple[tuple[int, int], float, str]]:
    """The quantities of a text: where each stands, its SI value and unit."""
    found = []
    for span, number, unit in _written(text):
        in_si = next(name for name, units in DIMENSIONS.items() if unit in units)
        found.append((span, float(si(f"{number}{unit}")), in_si))
    return found


def unit_of_field(path: str) -> str:
    """The SI unit of the number at a path; "" where that depends on what is beside it."""
    name = path.rsplit(".", 1)[-1]
    return "" if name in ("value", "minimum", "maximum", *NOT_MEASURED) or name.isdigit() else OF_FIELD.get(name, "m")


def _told(text: str) -> list[str]:
    """The quantities of a text, as "30 mph"."""
    return [f"{number} {unit}" for _, number, unit in _written(text)]


def _written(text: str) -> Iterator[tuple[tuple[int, int], str, str]]:
    """Where each quantity of a text stands, its number in digits and its unit; of a speed without one km/h."""
    found = []
    for match in _TOLD.finditer(text):
        unit = match[3].lower()
        found.append((match.span(), match[1] or str(_number(match[2].lower())), WORDS.get(unit, unit)))
    starts = {start for (start, _), _, _ in found}
    found += [(m.span(1), m[1], "km/h") for m in _bare_speed().finditer(text) if m.start(1) not in starts]
    yield from sorted(found)


@cache
def _bare_speed() -> re.Pattern[str]:
    """A number after a word for a speed, with nothing behind it that says what it counts."""
    words, about = language.alternatives(language.table("trade")["speeds"]), "(?:(?:about|around|roughly|like|some) )"
    ends = r"(?=\s*(?:[,.;!?)]\s|[,.;!?)]?$|and\b|but\b))"
    return re.compile(rf"\b(?:(?:{words}) {about}?|at {about})(\d+(?:\.\d+)?){ends}", re.IGNORECASE)


def _number(spelt: str) -> int:
    """The number that is spelt ("twenty-five")."""
    return 100 if "hundred" in spelt else sum(ONES.get(word) or TENS.get(word, 0) for word in re.split(r"[\s-]", spelt))


def rooms_in_seconds(answer: str, text: str) -> str:
    """A model's answer with its rooms ("gap=1.5m") in seconds where the text has that number of seconds and never of
    metres."""
    told = _told(text)

    def room(match: re.Match[str]) -> str:
        in_seconds = f"{match[1]} s" in told and f"{match[1]} m" not in told
        return f"={match[1]}{'s' if in_seconds else 'm'}"

    return re.sub(r"=(\d+(?:\.\d+)?)m\b", room, answer)


def with_units(structure: Structure, text: str) -> dict[str, dict[str, Any]]:
    """The components that say something, each quantity as the text has it ("30 mph") where it is found there."""
    told = _told(text)
    found = {}
    for c in structure.components:
        said = _said(c.spec.model_dump(mode="json", exclude_defaults=True, exclude_none=True), told, "", {})
        if said or c.id not in ("G", "T"):
            found[c.id] = said
    return found


def _said(value: Any, told: list[str], name: str, around: dict[str, Any]) -> Any:
    if isinstance(value, dict):
        return {k: _said(v, told, k, value) for k, v in value.items() if k not in LEFT_OUT}
    pair = isinstance(value, list) and len(value) == 2 and all(isinstance(v, int | float) for v in value)
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if isinstance(value, list) and not pair:
        return [_said(v, told, name, around) for v in value]
    if not (pair or number) or name in NOT_MEASURED or value == 0:
        return value
    kind = str(around.get("kind"))
    unit = OF_TRIGGER.get(kind, "m") if name == "value" else OF_FIELD.get(name, "m")
    unit = OF_LIMIT.get(kind, "m") if name in ("minimum", "maximum") else unit
    if pair:
        low, high = value
        return f"{low:g}-{high:g} {unit}"
    assert isinstance(value, int | float)
    same = (t for t in told if t.split()[1] in DIMENSIONS[unit] and abs(si(t) - value) <= max(0.006 * value, 0.006))
    in_kmh = unit == "m/s" and name != "lateral_speed"
    return next(same, f"{round(value * 3.6, 1):g} km/h" if in_kmh else f"{value:g} {unit}")

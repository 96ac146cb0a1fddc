"""Numbers with the units of a text ("50km/h", "30-40mph", "80ft") as SI values."""

import re
from typing import Any

UNITS = {
    "m": 1.0, "cm": 0.01, "km": 1000.0, "ft": 0.3048, "yd": 0.9144, "mi": 1609.344,
    "s": 1.0, "ms": 0.001, "min": 60.0,
    "km/h": 1 / 3.6, "kph": 1 / 3.6, "mph": 0.44704, "m/s": 1.0, "ft/s": 0.3048, "knots": 0.514444,
    "m/s2": 1.0, "g": 9.81, "m/s3": 1.0,
}  # fmt: skip
"""m, s, m/s, m/s2, m/s3 in one of each."""
_NUMBER = r"-?\d+(?:\.\d+)?"
_ONE = re.compile(rf"({_NUMBER})\s*([a-z/]+[23]?)")
_RANGE = re.compile(rf"({_NUMBER})\s*-\s*({_NUMBER})\s*([a-z/]+[23]?)")


DIMENSIONS = {
    "m": ("m", "cm", "km", "ft", "yd", "mi"), "s": ("s", "ms", "min"),
    "m/s": ("km/h", "kph", "mph", "m/s", "ft/s", "knots"), "m/s2": ("m/s2", "g"), "m/s3": ("m/s3",),
}  # fmt: skip
"""By SI unit, the units that measure the same."""


def unit_of(value: Any) -> str:
    """The SI unit of a quantity as written; empty for all else."""
    found = (_ONE.fullmatch(value.strip()) or _RANGE.fullmatch(value.strip())) if isinstance(value, str) else None
    unit = found[found.lastindex or 0] if found else ""
    return next((name for name, units in DIMENSIONS.items() if unit in units), "")


def si(value: Any) -> Any:
    """The SI value of a quantity, [low, high] of a range; lists and maps item by item; all else as it is."""
    if isinstance(value, dict):
        return {key: si(item) for key, item in value.items()}
    if isinstance(value, list):
        return [si(item) for item in value]
    if not isinstance(value, str):
        return value
    if (found := _RANGE.fullmatch(value.strip())) and found[3] in UNITS:
        return [round(float(found[k]) * UNITS[found[3]], 3) for k in (1, 2)]
    if (found := _ONE.fullmatch(value.strip())) and found[2] in UNITS:
        return round(float(found[1]) * UNITS[found[2]], 3)
    return value

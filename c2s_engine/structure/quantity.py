"""Numbers that a text leaves open: a fixed value, or a range that stays a range down to the program."""

from typing import Annotated, Any

from pydantic import AfterValidator

Range = tuple[float, float]


def _ordered(value: float | Range) -> float | Range:
    if isinstance(value, tuple):
        low, high = value
        if low > high:
            raise ValueError(f"the range's lower end {low} is above its upper end {high}")
    return value


FASTEST = 100.0
"""m/s: 360 km/h, more than anything on a road."""


def _possible(value: float | Range) -> float | Range:
    if low(value) < 0:
        raise ValueError("a speed is not below 0; who drives backwards has the action reverse")
    if high(value) > FASTEST:
        raise ValueError(f"a speed is at most {FASTEST * 3.6:g} km/h")
    return value


Quantity = Annotated[float | Range, AfterValidator(_ordered)]
"""A number, or [low, high] to draw uniformly from. SI units: m, s, m/s, m/s2."""
Velocity = Annotated[Quantity, AfterValidator(_possible)]
"""A speed that there is on roads, m/s."""


def low(value: float | Range) -> float:
    """The smallest value that a quantity can take."""
    return float(value[0] if isinstance(value, tuple | list) else value)


def high(value: float | Range) -> float:
    """The largest value that a quantity can take."""
    return float(value[1] if isinstance(value, tuple | list) else value)


def ends(value: Any) -> tuple[float, float] | None:
    """The ends of a number or range as plain data; None of anything else."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value), float(value)
    if isinstance(value, list | tuple) and len(value) == 2 and all(isinstance(v, int | float) for v in value):
        return float(value[0]), float(value[1])
    return None


_UNITS = {"gap": "m", "spacing": "m", "distance": "m", "lateral": "m", "duration": "s", "delay": "s", "rate": "m/s2",
          "trigger": "s after the start", "arrives": "s after ego"}  # fmt: skip
_SPEEDS = ("speed", "limit", "speed_limit")


def in_words(path: str, value: float | Range) -> str:
    """The value of a field of a spec in the user's units: "50 km/h", "10 to 12 m"."""
    name = path.rsplit(".", 1)[-1]
    scale, digits, unit = (3.6, 3, "km/h") if name in _SPEEDS else (1.0, 4, _UNITS.get(name, ""))
    least, most = f"{low(value) * scale:.{digits}g}", f"{high(value) * scale:.{digits}g}"
    return f"{least if least == most else f'{least} to {most}'} {unit}".strip()


def middle(value: float | Range) -> float:
    """The mean of a quantity's two ends."""
    return (low(value) + high(value)) / 2

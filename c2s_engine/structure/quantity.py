"""Numbers that a text leaves open: a fixed value, or a range that stays a range down to the program."""

from typing import Annotated

from pydantic import AfterValidator

Range = tuple[float, float]


def _ordered(value: float | Range) -> float | Range:
    if isinstance(value, tuple):
        low, high = value
        if low > high:
            raise ValueError(f"the range's lower end {low} is above its upper end {high}")
    return value


Quantity = Annotated[float | Range, AfterValidator(_ordered)]
"""A number, or [low, high] to draw uniformly from. SI units: m, s, m/s, m/s2."""


def low(value: float | Range) -> float:
    """The smallest value that a quantity can take."""
    return float(value[0] if isinstance(value, tuple | list) else value)


def high(value: float | Range) -> float:
    """The largest value that a quantity can take."""
    return float(value[1] if isinstance(value, tuple | list) else value)


def middle(value: float | Range) -> float:
    """The mean of a quantity's two ends."""
    return (low(value) + high(value)) / 2

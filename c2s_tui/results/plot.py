"""Curves over time in braille dots (or ASCII), with axes: pure, so that tests need no screen."""

from collections.abc import Sequence
from dataclasses import dataclass

from textual.content import Content

from c2s_tui.look.kinds import ascii_only

DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""The bits of a braille letter by row and column of its dots."""
MARGIN = 6
"""Columns for the numbers at the left."""


@dataclass(frozen=True)
class Curve:
    """Values at even steps from 0 on."""

    values: Sequence[float]
    style: str


def plot(curves: Sequence[Curve], seconds: float, columns: int, rows: int, unit: str, top: float = 0.0) -> Content:
    """The curves over `seconds`, from 0 to their greatest value (at least `top`); later ones lie above earlier ones."""
    width = columns - MARGIN
    if width < 8 or rows < 2 or not any(len(c.values) for c in curves):
        return Content("")
    most = max([top, *(max(c.values) for c in curves if len(c.values))]) or 1.0
    across, up = (1, 1) if ascii_only() else (2, 4)
    cells: list[list[tuple[int, str]]] = [[(0, "")] * width for _ in range(rows)]
    for curve in curves:
        for x, y in _dots(curve.values, width * across, rows * up, most):
            row, column = rows - 1 - y // up, x // across
            bit = 1 if ascii_only() else DOTS[up - 1 - y % up][x % across]
            cells[row][column] = (cells[row][column][0] | bit, curve.style)
    lines = []
    for i, drawn in enumerate(cells):
        label = f"{most:.0f}" if i == 0 else "0" if i == rows - 1 else ""
        lines.append(Content.assemble((f"{label:>{MARGIN - 1}} ", "$muted"), *map(_cell, drawn)))
    end = f"{seconds:.1f} s"
    foot = f"{unit:>{MARGIN - 1}} 0{end:>{width - 1}}"
    return Content("\n").join([*lines, Content.styled(foot, "$muted")])


def _cell(cell: tuple[int, str]) -> tuple[str, str]:
    bits, style = cell
    if not bits:
        return " ", ""
    return ("*" if ascii_only() else chr(0x2800 + bits)), style


def _dots(values: Sequence[float], across: int, up: int, most: float) -> list[tuple[int, int]]:
    """The dots of a curve, joined from column to column."""
    if len(values) < 2:
        return []
    found, before = [], None
    for x in range(across):
        value = values[round(x * (len(values) - 1) / (across - 1))]
        y = min(up - 1, max(0, round(value / most * (up - 1))))
        low, high = sorted((y, y if before is None else before))
        found += [(x, at) for at in range(low, high + 1)] if high - low > 1 else [(x, y)]
        before = y
    return found

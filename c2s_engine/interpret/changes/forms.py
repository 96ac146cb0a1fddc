"""What all forms of change share: a clause and S give edits with words for them, or None where they do not fit."""

import re
from collections.abc import Callable
from typing import Any

from c2s_engine.interpret.changes.refer import spec_of
from c2s_engine.interpret.reading import amounts
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit
from c2s_engine.structure.quantity import middle

Found = tuple[list[Edit], str]


Form = Callable[[str, Structure], Found | None]


ALREADY = "that is so already"
"""What is said of a change that leaves S as it was, with what it would have done behind it."""


def name_of(component: Component) -> str:
    return "ego" if component.id == "E" else f"{component.id} ({spec_of(component).name.replace('_', ' ')})"


def quantity_of(clause: str, dimension: str) -> dict[str, Any] | None:
    return next(
        (
            s.data | {"at": s.start, "end": s.end}
            for s in amounts.quantities(clause)
            if s.data["dimension"] == dimension
        ),
        None,
    )


def value_of(quantity: dict[str, Any]) -> Any:
    low, high = round(quantity["low"], 2), round(quantity["high"], 2)
    return low if low == high else [low, high]


def base_of(component: Component, path: str, usual: float) -> tuple[float, bool]:
    """From what a relative change of a field counts, and whether that is what is there: S's own number, the one that
    the writer chose or the run showed; else the usual one."""
    now = component.amount(path)
    return (middle(now), True) if now is not None else (usual, False)


def from_to(field: str, base: tuple[float, bool], value: float, unit: str, scale: float = 1.0) -> str:
    """A relative change in words, with what it counts from."""
    old, known = base
    said = f"{old * scale:.3g} {unit}" if known else f"{old * scale:.3g} {unit} (usual; none is said or was run)"
    return f"{field} {said} -> {value * scale:.3g} {unit}"


def without_unit(clause: str, patterns: list[str], factor: float) -> dict[str, Any] | None:
    """A number that by its pattern can only be a speed in km/h or a distance in m: "ego speed 70", "distance 45"."""
    match = next((m for p in patterns if (m := re.search(p, clause))), None)
    if match is None:
        return None
    low, high = int(match["low"]) * factor, int(match["low"]) * factor
    return {"low": low, "high": high}

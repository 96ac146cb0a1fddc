"""Changes of speed that are told by how much: "slows by 30 percent", "drops to half its speed", "brakes by 20 km/h"."""

from __future__ import annotations

from dataclasses import dataclass

from c2s_engine.interpret.speed.ratios import SPEED

OWN = rf"(?:(?:its|his|her|their|the|that|my|our) (?:(?!of\b)\w+ ){{0,3}}?{SPEED}\b|{SPEED}\b)"


@dataclass(frozen=True)
class Change:
    """The speed after a change is so many times the one before, and so many m/s more."""

    times: float
    more: float
    span: tuple[int, int]

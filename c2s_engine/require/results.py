"""Making results: a margin becomes holds, robustness and words."""

import math

from c2s_engine.structure.requirements import Requirement, Result

MOST = 3.0
"""Robustness is cut off there: more margin is no better."""


def scored(requirement: Requirement, margin: float, said: str, seen: str, time: float | None = None,
           why: str = "", measured: tuple[float, float, float] | None = None,
           due: float | None = None) -> Result:  # fmt: skip
    """It holds where the margin is not negative. `margin`: 1 is comfortable; `measured`: the number that was, and
    between which it must lie; `due`: s by which the actor should be later (below 0: earlier) for it to hold."""
    if math.isnan(margin):
        return unknown(requirement, said, "not judged: nothing was recorded of it")
    margin = max(-MOST, min(MOST, margin))
    return Result(
        requirement=requirement.id, holds=margin >= 0, robustness=round(margin, 3), said=said, seen=seen, why=why,
        time=None if time is None else round(time, 2), value=round(measured[0], 3) if measured else None,
        bounds=measured[1:] if measured else None, due=due if margin < 0 else None,
    )  # fmt: skip


def span(requirement: Requirement) -> tuple[float, float]:
    """Between which values a requirement asks for something: its `least` and `most`."""
    return float(requirement.values["least"]), float(requirement.values["most"])  # type: ignore[arg-type]


def words(requirement: Requirement, unit: str) -> str:
    """These as people read them."""
    least, most = span(requirement)
    return f"{least:g} {unit}" if least == most else f"{least:g} to {most:g} {unit}"


def between(requirement: Requirement, value: float, room: float, said: str, seen: str, time: float | None = None,
            due: float | None = None) -> Result:  # fmt: skip
    """It holds where a value misses its span by no more than `room`; a comfortable 1 within it."""
    least, most = span(requirement)
    off = max(least - value, value - most, 0.0)
    return scored(requirement, 1.0 - off / room, said, seen, time, measured=(value, least - room, most + room), due=due)


def decided(requirement: Requirement, holds: bool, said: str, seen: str, time: float | None = None,
            why: str = "", due: float | None = None) -> Result:  # fmt: skip
    """It holds or it does not, by nothing between but the s by which it is `due`."""
    fails = -1.0 if not due else -min(1.0, abs(due))
    return scored(requirement, 1.0 if holds else fails, said, seen, time, why, due=due)


def unknown(requirement: Requirement, said: str, why: str) -> Result:
    """Not reached, or not to be judged."""
    return Result(requirement=requirement.id, holds=None, robustness=None, said=said, why=why)

"""Triggers that come true at their value: by how much further apart two have to start, as the run says."""

from collections.abc import Sequence

from c2s_engine.solve.unknowns import Unknown
from c2s_engine.structure.components import ComponentId, Structure
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec

Setting = tuple[Unknown, float]
MEASURED = ("at_distance", "gap_then")
"""Checks of how far from one another two are at a moment."""


def further(structure: Structure, requirement: Requirement, result: Result,
            open_: Sequence[Unknown]) -> tuple[Setting, ...]:  # fmt: skip
    """The open gap by which one of the two is placed by the other, larger (smaller) by as much as they were too near
    (too far) at the moment: both drive as before until then. Nothing where none is open."""
    if requirement.check not in MEASURED or result.value is None or result.bounds is None:
        return ()
    pair = _component(requirement.actor), _component(requirement.other or EGO)
    for one, two in (pair, pair[::-1]):
        unknown = next((u for u in open_ if u.component == one and u.path == "placement.gap"), None)
        spec = structure[one].spec
        if unknown is None or not isinstance(spec, ObjectSpec) or _component(spec.placement.of) != two:
            continue
        low, high = unknown.limits
        value = round(min(max(unknown.value + sum(result.bounds) / 2 - result.value, low), high), 1)
        if value != round(unknown.value, 1):
            return ((unknown, value),)
    return ()


def _component(who: str) -> ComponentId:
    return "E" if who == EGO else who

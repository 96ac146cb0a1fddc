"""Triggers that come true at their value: by how much further apart two have to start, as the run says."""

from collections.abc import Sequence

from c2s_engine.solve.unknowns import Move, Unknown, find
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec

MEASURED = ("at_distance", "gap_then")
"""Checks of how far from one another two are at a moment."""


def further(structure: Structure, requirement: Requirement, result: Result,
            open_: Sequence[Unknown]) -> Move:  # fmt: skip
    """The open gap by which one of the two is placed by the other, larger (smaller) by as much as they were too near
    (too far) at the moment: both drive as before until then. Nothing where none is open."""
    if requirement.check not in MEASURED or result.value is None or result.bounds is None:
        return ()
    pair = component_of(requirement.actor), component_of(requirement.other or EGO)
    for one, two in (pair, pair[::-1]):
        unknown, spec = find(open_, one, "placement.gap"), structure[one].spec
        if unknown is None or not isinstance(spec, ObjectSpec) or component_of(spec.placement.of) != two:
            continue
        if move := unknown.set_to(unknown.value + sum(result.bounds) / 2 - result.value):
            return move
    return ()

"""S to requirements: the parts in the order in which they are told."""

from c2s_engine.require import (
    actors,
    arriving,
    causes,
    conflict,
    crossing,
    giving_way,
    limits,
    manoeuvres,
    natural,
    outcome,
    pace,
    phases,
    road,
    rules,
    starts,
    watched,
)
from c2s_engine.require.scene import Scene
from c2s_engine.structure.components import Structure
from c2s_engine.structure.requirements import Requirement

PARTS = (
    road, actors, starts, phases, manoeuvres, watched, causes, crossing,
    outcome, arriving, conflict, giving_way, natural, rules, limits, pace,
)  # fmt: skip
"""Phases come before what reads their moments."""


def require(structure: Structure) -> tuple[Requirement, ...]:
    """What a run of S must show. Derived from S alone; each id is there once.

    Of components that were imported or written by hand only what was recognised is required (`unrecognised`), and of
    those that a text told of besides what rests on the run alone: contacts, and what bodies can do.
    """
    scene = Scene(structure)
    found = {r.id: r for part in PARTS for r in part.required(scene)}
    return tuple(found.values())

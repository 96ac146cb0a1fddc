"""Whose vehicle or part "their" and "its" tell of, and behind whom "it" has one halt."""

from __future__ import annotations

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.who.persons import Persons


class Possessives(Persons):
    """The part of Cast that knows whose a vehicle or part is, by who did something right before."""

    ego: Entity
    subjects: list[tuple[int, Entity]]

"""Whom a person's name means: the road user that he or she drives, rides or is."""

from __future__ import annotations

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.wheel import Occupants


class Named(Occupants):
    """The part of Cast that knows people by their names."""

    def _by_name(self, word: Word) -> Entity | None:
        """Who is called so: known by the name, or by what is said of him or her; nobody on the road, otherwise."""
        assert word.span is not None
        names, sex = set(word.span.data["names"]), word.span.data["sex"]
        known = [e for e in (self.ego, *self.entities) if e.names & names and not (e.sex and sex and e.sex != sex)]
        if known:
            found: Entity | None = known[0]
        else:
            found = self._at_wheel(word)
            found = found or None
        if found is not None:
            found.names |= names
            found.manned, found.sex = True, found.sex or sex
        return found

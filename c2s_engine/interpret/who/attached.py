"""Whom a noun belongs to by the words around it: the rider of a motorcycle, a state told right behind it."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.riders import Riders


class Attached(Riders):
    """The part of Cast that reads what rides on a road user, or tells its state right behind it."""

    def _mount(self, word: Word) -> Entity | None:
        """What a rider rides: "V2's rider", "the rider" where ego is a motorcycle."""
        the = any(self.words[c].norm == "the" for c in word.children)
        others = [e for e in self.entities if fits(e, "rider")]
        return self.ego if the and not others and self.ego.type == "motorcycle" and self.ego.typed else None

    def _called(self, word: Word) -> Entity | None:
        """Whose label stands right before a noun with nothing but adjectives between: "Unit 1 gray pickup"."""
        for other in reversed(self.words[max(0, word.i - 3) : word.i]):
            if other.sentence != word.sentence:
                return None
            if other.span is not None:
                return self.of.get(other.i) if other.span.kind == "label" else None
            if not other.tag.startswith(("JJ", "NN", "CD")) or other.norm in language.table("actors")["never"]:
                return None
        return None

"""Whom a pronoun cannot mean: what its own verb is done to, or by whom it is placed."""

from __future__ import annotations

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.place_words import PlaceWords


class Excluded(PlaceWords):
    """The part of Cast that knows whom the subject of a verb is not."""

    ego: Entity

    def _objects(self, verb: Word) -> list[Word]:
        """The objects of a verb and of those that go on with its subject; who does it to that one."""
        joined = [self.words[c] for c in verb.children if self.words[c].dep == "conj" and self.words[c].verb]
        alike = [v for v in joined if not any(self.words[c].dep.startswith("nsubj") for c in v.children)]
        below = [self.words[c] for v in (verb, *alike) for c in v.children if c > v.i]
        by = [self.words[c] for w in below if w.dep == "agent" for c in w.children]
        return [w for w in below if w.dep == "dobj"] + by

"""Who rides what: a rider and the two-wheeler are one road user, whichever is named first."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.trailers import Trailers

MOTORED = language.words("done_with_a_motor")
RIDERS = frozenset(form for noun in language.table("actors")["riders"] for form in (noun, *language.plurals(noun)))
"""Nouns for who rides something that is named beside them."""


class Riders(Trailers):
    """The part of Cast that takes a rider and what is ridden for one."""

    entities: list[Entity]

    def _rider_of(self, word: Word) -> bool:
        """Whether a rider is told by what he or she rides: "the rider of the scooter" is the scooter."""
        assert word.span is not None
        of = next((self.words[c] for c in word.children if self.words[c].norm == "of"), None)
        if of is None or word.norm not in RIDERS:
            return False
        spans = (self.words[c].span for c in of.children)
        return any(s is not None and (s.kind != "actor" or s.data["type"] in VEHICLES | {"animal"}) for s in spans)

    def _settle_riders(self) -> None:
        """Riders of whom it is never told what they ride: a motorcycle by what is done with it, else a bicycle."""
        for entity in self.entities:
            if entity.type == "rider":
                subjects = (w for w in (self.words[m.word] for m in entity.mentions) if w.dep == "nsubj")
                heads = [self.words[w.head] for w in subjects]
                joined = [self.words[c] for h in heads for c in h.children if self.words[c].dep == "conj"]
                verbs = {w.lemma for w in (*heads, *joined)}
                entity.type = "motorcycle" if verbs & MOTORED else "bicycle"

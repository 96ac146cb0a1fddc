"""Who rides what: a rider and the two-wheeler are one road user, whichever is named first."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.who.trailers import Trailers

MOTORED = language.words("done_with_a_motor")


class Riders(Trailers):
    """The part of Cast that takes a rider and what is ridden for one."""

    entities: list[Entity]

    def _settle_riders(self) -> None:
        """Riders of whom it is never told what they ride: a motorcycle by what is done with it, else a bicycle."""
        for entity in self.entities:
            if entity.type == "rider":
                subjects = (w for w in (self.words[m.word] for m in entity.mentions) if w.dep == "nsubj")
                heads = [self.words[w.head] for w in subjects]
                joined = [self.words[c] for h in heads for c in h.children if self.words[c].dep == "conj"]
                verbs = {w.lemma for w in (*heads, *joined)}
                entity.type = "motorcycle" if verbs & MOTORED else "bicycle"

"""Whom a noun belongs to by the words around it: the rider of a motorcycle, the trailer of a truck."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.writers import Writers

STANDS = language.words("stands")
TOWS = language.words("tows")


class Attached(Writers):
    """The part of Cast that reads what rides on a road user, is pulled by it, or tells its state right behind it."""

    def _mount(self, word: Word) -> Entity | None:
        """What a rider rides: "V2's rider", "the rider" where ego is a motorcycle."""
        poss = (c for c in word.children if self.words[c].dep == "poss" and self.words[c].tag != "PRP$")
        whose = next((self.of[c] for c in poss if c in self.of), None)
        if whose is not None:
            return whose if whose.type in ("bicycle", "motorcycle", "vehicle") or whose.ego else None
        the = any(self.words[c].norm == "the" for c in word.children)
        others = [e for e in self.entities if fits(e, "rider")]
        return self.ego if the and not others and self.ego.type == "motorcycle" and self.ego.typed else None

    def _puller(self, word: Word) -> int | None:
        """The noun whose trailer it is: "a tractor with a trailer", "a car towing a caravan"; the verb where nobody is
        named that pulls."""
        above = self.words[word.head]
        if above.norm == "with" and word.dep == "pobj":
            return above.head if self.words[above.head].span is not None else None
        if above.lemma not in TOWS or word.dep != "dobj":
            return None
        subject = next((c for c in above.children if self.words[c].dep == "nsubj"), above.i)
        return above.head if above.dep == "acl" else subject

    def _behind(self, word: Word) -> list[str]:
        """The adjective right behind a noun that tells its state: "a van double-parked in ego's lane"."""
        after = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        told = after is not None and after.head == word.i and after.dep == "amod" and after.norm in STANDS
        return [after.norm] if after is not None and told else []

"""Who rides what: a rider and the two-wheeler are one road user, whichever is named first."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import PERSONS, VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.trailers import Trailers

RIDDEN = frozenset(("bicycle", "motorcycle"))
ASTRIDE = frozenset(("on", "aboard", "astride"))
PLACES = frozenset(("between", "behind", "past", "from", "beside"))
"""Before who only tells where a rider comes from."""
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

    def _rides_along(self, word: Word) -> Entity | None:
        """A person of whom it is told only behind the verb what is ridden: "a girl crosses on her bike", "a lad pops
        out between two cars on a BMX"."""
        for other in self.words[word.i + 1 : word.i + 16]:
            if other.sentence != word.sentence or other.norm in (";", ":", ",", "and", "but", "while", "when"):
                return None
            if other.span is None:
                continue
            data = other.span.data
            if (
                other.span.kind == "actor"
                and data["type"] in RIDDEN
                and not data.get("person")
                and self._astride(other)
            ):
                found = self._new(Entity("", "vehicle", manned=True, names={word.norm.split(" ")[-1]}))
                self.wheels[other.i] = found
                return found
            if other.span.kind != "quantity" and self._between_them(other):
                return None
        return None

    def _astride(self, word: Word) -> bool:
        """Whether a new two-wheeler, or one's own, is told of behind "on": "on an old bicycle"."""
        near = [w.norm for w in self.words[max(0, word.i - 4) : word.i]]
        at = next((n for n, w in enumerate(near) if w in ASTRIDE), None)
        return at is not None and len(near) > at + 1 and near[at + 1] in ("a", "an", "his", "her", "their")

    def _between_them(self, word: Word) -> bool:
        """Whether somebody else is told of who may be the rider."""
        assert word.span is not None
        if word.span.kind != "actor":
            near = {w.norm for w in self.words[max(0, word.i - 2) : word.i + 2]}
            return not near & {"of", "'s", *PLACES}
        near = {w.norm for w in self.words[max(0, word.i - 4) : word.i]}
        return word.span.data["type"] in PERSONS | VEHICLES and not near & PLACES

    def _settle_riders(self) -> None:
        """Riders of whom it is never told what they ride: a motorcycle by what is done with it, else a bicycle."""
        for entity in self.entities:
            if entity.type == "rider":
                subjects = (w for w in (self.words[m.word] for m in entity.mentions) if w.dep == "nsubj")
                heads = [self.words[w.head] for w in subjects]
                joined = [self.words[c] for h in heads for c in h.children if self.words[c].dep == "conj"]
                verbs = {w.lemma for w in (*heads, *joined)}
                entity.type = "motorcycle" if verbs & MOTORED else "bicycle"

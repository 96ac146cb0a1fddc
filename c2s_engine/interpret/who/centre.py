"""Whom the sentence before tells of: "a bus is ahead of ego. The vehicle stops"."""

from __future__ import annotations

from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.nearing import ANSWERS
from c2s_engine.interpret.who.persons import RIDDEN
from c2s_engine.interpret.who.pronouns import Pronouns


class Centre(Pronouns):
    """The part of Cast that knows whom it is about."""

    def _centre(self, word: Word, noun: str) -> Entity | None:
        """Whom "the vehicle" means as its sentence or the one before tells of that one and not of ego, where ego was
        never called so: "a bus is ahead of ego. The vehicle stops"."""
        called = any(self.words[m.word].norm.split(" ")[-1].split("-")[-1] == noun for m in self.ego.mentions)
        if called or noun not in ("vehicle", "car") or word.dep not in ("nsubj", "nsubjpass"):
            return None
        told = [e for i, e in self.subjects if self.words[i].sentence == word.sentence - 1]
        centre = told[-1] if told and len({*map(id, told)}) == 1 else None
        if centre is None or centre.ego or centre.type not in VEHICLES or centre.count > 1:
            return None
        here = [w for w in self.words if w.sentence == word.sentence]
        before = any(w.i < word.i and self.of.get(w.i) is self.ego for w in here)
        again = any(
            w.i > word.i and (w.norm == "it" or w.span and w.span.data.get("noun") == centre.noun) for w in here
        )
        answers = self._governor(word).lemma in ANSWERS and self._rests(centre)
        return None if again or answers and not before else centre

    def _struck_by(self, word: Word, those: list[Entity], verbs: frozenset[str]) -> Entity | None:
        """The one vehicle beside who strikes it: "a motorcyclist hit the vehicle", after a car was told of."""
        verb = self._governor(word)
        doer = self._subject_of(verb) if word.dep in ("dobj", "pobj") and verb.lemma in verbs else None
        rest = [e for e in those if e is not doer and e.type in VEHICLES - RIDDEN]
        return rest[0] if doer in those and len(rest) == 1 else None

"""Whose vehicle or part "their" and "its" tell of, and behind whom "it" has one halt."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.persons import Persons

STRIKES = language.words("strikes")
TOGETHER = frozenset(("couple", "family", "friends", "group", "pair", "crew"))
TOYS = language.words("toys")


class Theirs(Persons):
    """The part of Cast that knows whose a vehicle or part is, by who did something right before."""

    ego: Entity
    subjects: list[tuple[int, Entity]]

    def _theirs(self, word: Word) -> Entity | None:
        """Who drives what is called "their" vehicle: "the couple drove home ... their Skoda slid"."""
        span = self.words[word.head].span
        own = word.dep == "poss" and span is not None and span.kind == "actor" and span.data["type"] in MOTOR
        told = [e for e in (self.ego, *self.entities) if e.manned and e.names & TOGETHER and not e.person]
        return told[-1] if own and told else None

    def _after_a_toy(self, word: Word) -> bool:
        """Whether "it" is a ball or the like that somebody runs after: no road user."""
        before = [w for w in self.words[: word.i] if w.sentence >= word.sentence - 1]
        chases = before and (before[-1].norm == "after" or before[-1].lemma == "chase")
        toys = [w for w in before if w.noun and w.norm.split(" ")[-1] in TOYS]
        return bool(chases and toys) and toys[-1].i not in self.of

    def _of_the_other(self, word: Word) -> Entity | None:
        """Whose part is struck, of those who did something right before: "the van pulled out in front of the bus and
        the motorcycle hit its wing"."""
        verb = self._governor(word)
        if word.dep != "poss" or self.words[word.head].dep != "dobj" or verb.lemma not in STRIKES:
            return None
        own = [c for c in verb.children if self.words[c].dep == "nsubj" and c in self.of]
        did = [e for i, e in self.subjects if self.words[i].sentence == word.sentence and i < verb.i]
        others = [e for e in did if own and e is not self.of[own[0]]]
        return others[-1] if verb.dep == "conj" and others else None

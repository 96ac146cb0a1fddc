"""Whether a definite noun means ego: by how ego was called, by what it does, by what is told of it."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.centre import Centre

COLOURS = language.words("colours")
OF_EGO = language.words("of_ego")
SYSTEMS, RUN_BY = language.words("systems"), language.words("run_by_systems")
RUNS_AWAY = language.words("gets_out_of_hand")
FIRST = frozenset(("i", "we", "me", "us", "my", "our", "mine"))


class EgoByNoun(Centre):
    """The part of Cast that knows whether a noun means ego."""

    strong_ego: bool

    @property
    def driven_by_me(self) -> bool:
        raise NotImplementedError

    def _ego_moving(self, roles: set[str], kind: str, definite: bool) -> bool:
        """Whether ego is meant by what it does: "the turning truck", of a test vehicle that is a truck."""
        doing = bool(roles) and roles <= {"turning", "slow", "fast"} and definite
        return doing and self.ego.typed and kind == self.ego.type and not any(e.type == kind for e in self.entities)

    def _told_by_a_part(self, word: Word, noun: str) -> bool:
        """Whether words before "vehicle" tell it from ego that has a name: "the ego ... the intruding vehicle"."""
        names = [w for w in self.words if w.span is not None and w.span.kind == "ego"]
        before = [self.words[c] for c in word.children if c < word.i and self.words[c].dep in ("amod", "compound")]
        by = [w for w in before if w.i not in self.of and w.norm not in OF_EGO and w.norm not in COLOURS]
        return noun in ("vehicle", "car") and self.strong_ego and bool(names) and bool(by)

    def _run_by_its_own(self, word: Word) -> bool:
        """Whether it is the object of what its own system or driver does: "the function shall hold the vehicle"."""
        verb = self.words[word.head]
        subjects = [self.words[c] for c in verb.children if self.words[c].dep == "nsubj"]
        own = any(w.lemma in SYSTEMS or w.norm in ("i", "we") and self.of.get(w.i) is self.ego for w in subjects)
        return word.dep == "dobj" and own and verb.lemma in RUN_BY

    def _out_of_my_hand(self, word: Word) -> bool:
        """Whether it is what the first person was driving and then could not hold: "I braked but the car slid on"."""
        verb = self.words[word.head]
        goes = word.dep == "nsubj" and irregular().get(verb.norm, verb.lemma) in RUNS_AWAY
        if not goes or verb.tag == "VBG" or not self.driven_by_me or self.words[word.i - 1].norm != "the":
            return False
        before = [w for w in self.words[: word.i] if w.sentence >= word.sentence - 1 and w.norm in FIRST]
        after = [w for w in self.words[word.i : verb.i + 8] if w.sentence == word.sentence]
        return bool(before) and not any(w.norm in FIRST for w in after)

    def _my_car(self, word: Word) -> bool:
        """Whether it is the vehicle of who tells the story: "I braked and the car just carried on"."""
        told = any(self.words[m.word].norm in ("i", "my") for m in self.ego.mentions if m.word < word.i)
        rest = {w.norm for w in self.words[word.i :] if w.sentence == word.sentence}
        the = self.words[word.i - 1].norm == "the" and word.dep == "nsubj"
        return told and the and not self._distinguished(word) and not rest & {"me", "us", "my", "our"}

    def _distinguished(self, word: Word) -> bool:
        raise NotImplementedError

    def _ego_by(self, noun: str) -> bool:
        """Whether ego was called by that noun ("the DCAS vehicle" makes "the vehicle" ego)."""
        return any(
            noun and noun in (self.words[m.word].norm, self.words[m.word].norm.split(" ")[-1].split("-")[-1])
            for m in self.ego.mentions
        ) or (noun == "vehicle" and self.strong_ego and not any(e.type == "vehicle" for e in self.entities))

    def _ego_besides(self, noun: str) -> bool:
        """Whether ego was only called that beside a name of its own ("Ego, a car, drives")."""
        called = [self.words[m.word] for m in self.ego.mentions]
        return all(w.dep == "appos" for w in called if w.norm.split(" ")[-1] == noun)

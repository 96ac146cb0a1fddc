"""Whether a definite noun means ego: by how ego was called, by what it does, by what is told of it."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.pronouns import Pronouns

RUNS_AWAY = language.words("gets_out_of_hand")
FIRST = frozenset(("i", "we", "me", "us", "my", "our", "mine"))


class EgoByNoun(Pronouns):
    """The part of Cast that knows whether a noun means ego."""

    strong_ego: bool

    @property
    def driven_by_me(self) -> bool:
        raise NotImplementedError

    def _out_of_my_hand(self, word: Word) -> bool:
        """Whether it is what the first person was driving and then could not hold: "I braked but the car slid on"."""
        verb = self.words[word.head]
        goes = word.dep == "nsubj" and irregular().get(verb.norm, verb.lemma) in RUNS_AWAY
        if not goes or verb.tag == "VBG" or not self.driven_by_me or self.words[word.i - 1].norm != "the":
            return False
        before = [w for w in self.words[: word.i] if w.sentence >= word.sentence - 1 and w.norm in FIRST]
        after = [w for w in self.words[word.i : verb.i + 8] if w.sentence == word.sentence]
        return bool(before) and not any(w.norm in FIRST for w in after)

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

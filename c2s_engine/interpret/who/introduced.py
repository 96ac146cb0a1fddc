"""Whom a noun means of those who were introduced before it: the other of two parties, a label that a colon explains."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.attached import Attached

NOT_NAMED = language.words("systems") | {"i", "we", "my", "our", "me", "us"}
"""Words for ego that may only mean who asks for the scene, or what is tested."""


class Introduced(Attached):
    """The part of Cast that knows who was introduced together."""

    def _parties(self, word: Word, before: list[str], data: dict, roles: set[str]) -> Entity | None:
        """The other of the two parties that "the vehicles" means ("both vehicles", "the two cars"), once two single
        ones were spoken of and no group was."""
        if not data.get("plural") or data.get("noun") not in ("vehicles", "cars") or roles or self._distinguished(word):
            return None
        if not {"the", "both", "these"} & set(before) or {"other", "three", "four"} & set(before):
            return None
        if self.words[word.head].norm in ("between", "of", "behind", "among") or word.dep not in ("nsubj", "nsubjpass"):
            return None
        told = [e for e in self.entities if e.type in VEHICLES and e.mentions]
        alone = len(told) == 1 and self.ego.mentions or len(told) == 2 and not self.ego.mentions
        if not alone:
            return None
        if {"both", "two"} & set(before):
            self.both[word.i] = told[:-1] or [self.ego]
        return told[-1]

    def _revealed(self, word: Word, kind: str) -> Entity | None:
        """The bare label that a colon explains: "V3 came into view: a disabled car"."""
        sentence = [w for w in self.words[: word.i] if w.sentence == word.sentence]
        if not any(w.norm == ":" for w in sentence[-4:]):
            return None
        labels = [
            self.of[w.i]
            for w in sentence
            if w.i in self.of and self.of[w.i].label and self.of[w.i].type == "vehicle" and not self.of[w.i].ego
        ]
        return labels[-1] if labels and kind in MOTOR else None

    def _ego_and_another(self, word: Word, kind: str) -> Entity | None:
        """The two of whom ego and another are told then: "There are two cars. Ego drives north, another car ..."."""
        pairs = [e for e in self.entities if e.count > 1 and e.type in MOTOR]
        if len(pairs) != 1 or pairs[0].count != 2 or pairs[0].roles or len(pairs[0].mentions) != 1:
            return None
        first = self.words[pairs[0].mentions[0].word]
        since = [m for m in self.ego.mentions if first.i < m.word < word.i]
        before = [m for m in self.ego.mentions if m.word < first.i and self.words[m.word].norm not in NOT_NAMED]
        bare = first.dep == "attr" or first.dep == "nsubj" and first.i + 2 >= self.words[first.head].i
        return pairs[0] if since and not before and bare else None

"""Whose vehicle a noun with an owner means: "his car", "the defendant's van", "my Honda"."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.ego_by_noun import EgoByNoun

MOVES = language.word_list("motion") | language.words("strikes") | language.words("manoeuvres")
MISHAPS = language.words("mishaps")


class Owned(EgoByNoun):
    """The part of Cast that resolves vehicles by who owns or drives them."""

    def _type_of_definite(self, word: Word, kind: str) -> Entity | None:
        for child in word.children:
            if (
                self.words[child].tag == "PRP$"
                and child in self.of
                and self.of[child].ego
                and kind in VEHICLES
                and word.span is not None
            ):
                return self.ego
        owner = next((self.of[c] for c in word.children if self.words[c].dep == "poss" and c in self.of), None)
        if owner is not None and self._own_vehicle(word, owner, kind):
            return owner
        return None

    def _own_vehicle(self, word: Word, owner: Entity, kind: str) -> bool:
        """Whether it is what somebody at the wheel drives: "his car", after "Mr Hansen was driving"."""
        assert word.span is not None
        if kind not in VEHICLES:
            return False
        if owner.person and self._moves(word):
            owner.names.add(owner.noun.split(" ")[-1])  # "a man was hurt when his pickup left the road ... the man"
            owner.type, owner.noun, owner.typed, owner.manned, owner.count = kind, word.norm, True, True, 1
            return True
        if not owner.manned or owner.person:
            return False
        return kind in ("vehicle", owner.type) or owner.type == "vehicle"

    def _moves(self, word: Word) -> bool:
        """Whether a noun is who moves or is hit."""
        verb = self._governor(word)
        return word.dep in ("nsubj", "nsubjpass") and verb.lemma in MOVES | MISHAPS

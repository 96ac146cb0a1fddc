"""By which words a place is told: whom "behind it" and "on its left" may mean."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.members import Members

HAS = language.words("has_before_one") | language.words("notices") | {"see", "find", "detect", "carry"}
PLACES = ("ahead", "front", "behind", "beside", "alongside", "in", "at", "to", "on", "next")
BESIDE = re.compile(r"(to|on|in|at) (left|right|front|rear)\b")
PLACED_BY = re.compile(r"\b(?:in front|ahead) of(?: the)?$")


class PlaceWords(Members):
    """The part of Cast that reads the words of place around a pronoun."""

    def _unplacing(self, word: Word, who: Entity | None, near: list[int]) -> list[int]:
        """Those whom "behind it" may mean, without ego where it only says where another is: "a van is in front of ego
        and two men walk behind it"."""
        if who is None or who.type in MOTOR or self.words[word.head].norm != "behind":
            return near
        places = (" ".join(w.norm for w in self.words[max(0, i - 4) : i]) for i in near)
        kept = [
            i for i, text in zip(near, places, strict=True) if self.of[i] is not self.ego or not PLACED_BY.search(text)
        ]
        return kept or near

    def _object_of(self, verb: Word, before: int) -> Entity | None:
        """Whom a verb has for its object before a word."""
        found = [c for c in verb.children if self.words[c].dep == "dobj" and c < before]
        return self.of.get(found[-1]) if found else None

    def _held_before(self, verb: Word, place: Word) -> Entity | None:
        """Whom somebody has or sees beside itself: the van of "ego has a van ahead of it"."""
        if not verb.verb or irregular().get(verb.norm, verb.lemma) not in HAS or place.norm not in PLACES:
            return None
        held = [c for c in verb.children if self.words[c].dep == "dobj" and verb.i < c < place.i]
        return self.of.get(held[-1]) if held else None

    def _parallel(self, word: Word) -> Entity | None:
        """Whom "its" meant just before in the same place: "a bus is on its right, a car on its left"."""
        if not BESIDE.match(self._around(word.i)):
            return None
        for earlier in reversed(self.words[: word.i]):
            if earlier.sentence != word.sentence:
                return None
            if earlier.norm == word.norm and BESIDE.match(self._around(earlier.i)):
                return self.of.get(earlier.i)
        return None

    def _around(self, i: int) -> str:
        """The words before and after a word."""
        return " ".join(w.norm for w in self.words[max(0, i - 1) : i + 2 : 2])

"""By which words a place is told: whom "behind it" and "on its left" may mean."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.members import Members

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

    def _around(self, i: int) -> str:
        """The words before and after a word."""
        return " ".join(w.norm for w in self.words[max(0, i - 1) : i + 2 : 2])

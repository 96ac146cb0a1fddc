"""The vehicle of who writes a report, which is named without an article: "Hwy 17, tanker, 3/4 full. Me at 85 km/h"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.titles import Titles

OWN = language.table("ego")["own_vehicle"]
BEFORE, HEADED, AFTER, ROUTE, ABOARD = (re.compile(OWN[k]) for k in ("before", "headed", "after", "route", "aboard"))
STRUCK = re.compile(r"\b(?:following|behind) (?:me|us)\b.*\b(?:into|hit|struck) (?:the (?:back|rear|side) of )?the$")
"""Before the vehicle that somebody behind the first person runs into."""
AWAITS = frozenset(("sit", "stand", "park", "wait", "queue", "idle"))
STEERS = language.words("steers")
FIRST = frozenset(("i", "me", "my", "we", "our", "us"))


class Writers(Titles):
    """The part of Cast that knows the vehicle of the first person by the words of a report's heading."""

    ego: Entity
    asking: frozenset[int]
    me: Entity

    def _writers_own(self, word: Word, kind: str) -> bool:
        """Whether a vehicle without an article is the one that the first person drives."""
        assert word.span is not None
        if kind not in MOTOR - {"vehicle"} or word.span.data.get("plural") or word.span.data.get("words"):
            return False
        if self.ego.typed or not self._tells_first() or any(e.type == kind for e in self.entities):
            return False
        if self._steered(word, kind):
            return True
        before, after = self._beside(word)
        if self._heading(word.sentence):
            told = " ".join(w.norm for w in self.words if w.sentence <= word.sentence)
            here = BEFORE.search(before) is not None and AFTER.match(after) is not None
            return HEADED.search(self._headings(word)) is not None or here and ROUTE.search(told) is not None
        bare = kind in ("bus", "truck") and word.dep in ("nsubj", "nsubjpass") and not word.children
        bare = bare and not self._now(word) and not self._told_beside(word)
        the = [self.words[c].norm for c in word.children] == ["the"]
        passengers = ABOARD.search(" ".join(w.norm for w in self.words)) is not None
        return bare or the and (kind == "bus" and passengers or STRUCK.search(before) is not None)

    def _ridden_by_me(self) -> bool:
        raise NotImplementedError

    def _now(self, word: Word) -> bool:
        """Whether a subject's verb tells what somebody watches: "Bus is at the stop. We brake", no report."""
        verb = self.words[word.head]
        return any(w.tag == "VBZ" for w in (verb, *(self.words[c] for c in verb.children)))

    def _told_beside(self, word: Word) -> bool:
        """Whether a subject is told of beside the first person: "Bus was sitting there", "Truck was behind me"."""
        below = [self.words[c].norm for c in self.words[word.head].children]
        mine = any(w.norm in ("me", "us") for w in self.words[word.i :] if w.sentence == word.sentence)
        waits = self.words[word.head].lemma in AWAITS and not {"when", "while"} & set(below)
        drove = any(e is self.ego and self.words[i].sentence < word.sentence for i, e in self.subjects)
        return mine or waits and drove

    def _steered(self, word: Word, kind: str) -> bool:
        """Whether it is driven by the first person, or by nobody who is named: "Driving an artic when a van hit me"."""
        above = self.words[word.head]
        astride = above.norm == "on" and kind in ("motorcycle", "bicycle")  # "I was out on my Ducati"
        verb = self.words[above.head] if astride else above
        told = [self.words[c].norm for c in verb.children if self.words[c].dep in ("nsubj", "nsubjpass")]
        own = verb.dep == "ROOT" or self.words[verb.i - 1].sentence != verb.sentence or verb.i == 0
        mine = told in (["i"], ["we"]) and not any(self.words[c].norm == "the" for c in word.children)
        if astride:
            return mine and {self.words[c].norm for c in word.children} & {"my", "our"} != set()
        return word.dep == "dobj" and verb.norm in STEERS and (mine or not told and own)

    def _headings(self, word: Word) -> str:
        """The few words before a word, back to the beginning of a note of two words or less."""
        return " ".join(w.norm for w in self.words[max(0, word.i - 5) : word.i] if w.sentence >= word.sentence - 1)

    @property
    def driven_by_me(self) -> bool:
        """Whether the first person is at the wheel of ego."""
        return self.me is self.ego and self._tells_first()

    def _tells_first(self) -> bool:
        """Whether the text is told by somebody who drives."""
        mine = (w for w in self.words if w.norm in FIRST and w.i not in self.asking)
        return self.me is self.ego and any(not w.text.isupper() or len(w.text) == 1 for w in mine)

    def _beside(self, word: Word) -> tuple[str, str]:
        """The words of its sentence before and after a word."""
        own = [w for w in self.words if w.sentence == word.sentence]
        return " ".join(w.norm for w in own if w.i < word.i), " ".join(w.norm for w in own if w.i > word.i)

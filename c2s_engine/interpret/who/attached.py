"""Whom a noun belongs to by the words around it: the rider of a motorcycle, a state told right behind it."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.riders import Riders

STANDS = language.words("stands")


class Attached(Riders):
    """The part of Cast that reads what rides on a road user, or tells its state right behind it."""

    def _mount(self, word: Word) -> Entity | None:
        """What a rider rides: "V2's rider", "the rider" where ego is a motorcycle."""
        poss = (c for c in word.children if self.words[c].dep == "poss" and self.words[c].tag != "PRP$")
        whose = next((self.of[c] for c in poss if c in self.of), None)
        if whose is not None:
            return whose if whose.type in ("bicycle", "motorcycle", "vehicle") or whose.ego else None
        the = any(self.words[c].norm == "the" for c in word.children)
        others = [e for e in self.entities if fits(e, "rider")]
        return self.ego if the and not others and self.ego.type == "motorcycle" and self.ego.typed else None

    def _owner_told(self, word: Word, noun: str) -> Entity | None:
        """Somebody spoken of before, whose vehicle is named now: "a woman was hurt ... the woman's Polo"; who is
        told of right before: "the second, a man in a Rover"."""
        same = self.of.get(word.head) if word.dep == "appos" else None
        if same is not None and same.type == "vehicle" and not same.typed and self.words[word.head].span is None:
            return same
        the = any(self.words[c].norm == "the" for c in word.children)
        vehicle = self.words[word.head] if word.dep == "poss" else None
        told = next((e for e in self.entities if e.person and e.noun == noun and e.count == 1), None)
        if not the or told is None or vehicle is None:
            return None
        told.type, told.typed, told.manned = "vehicle", False, True
        return told

    def _behind(self, word: Word) -> list[str]:
        """The adjective right behind a noun that tells its state: "a van double-parked in ego's lane"."""
        after = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        told = after is not None and after.head == word.i and after.dep == "amod" and after.norm in STANDS
        return [after.norm] if after is not None and told else []

    def _alternative(self, word: Word) -> Entity | None:
        """The first of two nouns of which either may be meant: "a tractor or a coach"."""
        back = [w for w in self.words[max(0, word.i - 5) : word.i] if w.sentence == word.sentence]
        text = " ".join("@" if w.i in self.of and w.span is not None else w.norm for w in back)
        if not re.search(r"@ (?:or|/) (?:(?:an?|maybe|perhaps|some|even) ){0,2}(?:[\w-]+ )?$", text + " "):
            return None
        return next((self.of[w.i] for w in reversed(back) if w.i in self.of and w.span is not None), None)

    def _called(self, word: Word) -> Entity | None:
        """Whose label stands right before a noun with nothing but adjectives between: "Unit 1 gray pickup"."""
        for other in reversed(self.words[max(0, word.i - 3) : word.i]):
            if other.sentence != word.sentence:
                return None
            if other.span is not None:
                return self.of.get(other.i) if other.span.kind == "label" else None
            if not other.tag.startswith(("JJ", "NN", "CD")) or other.norm in language.table("actors")["never"]:
                return None
        return None

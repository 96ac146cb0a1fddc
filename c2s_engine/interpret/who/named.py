"""Whom a person's name means: the road user that he or she drives, rides or is."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.wheel import AtWheel

WALKS, CYCLES, DRIVES = (frozenset(language.table("people")[key]) for key in ("walks", "cycles", "drives"))
DRIVEN_BY = re.compile(
    r"@ ?,? (?:(?:which|that) )?(?:(?:was|is|being) )*(?:driven|operated|ridden|steered) by"
    r" (?:(?:an?|the|his|her) )?(?:[\w-]+ ){0,4}$"
)
IS_A = re.compile(r"(?:, |\( )?(?:(?:aged )?\d+ ,? ?|who )?(?:(?:was|is) )?(?:an?|the) (?:[\w-]+ ){0,3}$")
YEARS = re.compile(r"^\d+[- ]year[- ]old$")
AFOOT = re.compile(r"\b(?:on foot|walk(?:s|ed|ing)?|pedestrian)\b")


class Named(AtWheel):
    """The part of Cast that knows people by their names."""

    def _by_name(self, word: Word) -> Entity | None:
        """Who is called so: known by the name, or by what is said of him or her; nobody on the road, otherwise."""
        assert word.span is not None
        names, sex = set(word.span.data["names"]), word.span.data["sex"]
        known = [e for e in (self.ego, *self.entities) if e.names & names and not (e.sex and sex and e.sex != sex)]
        if known:
            found: Entity | None = known[0]
            if not known[0].typed:
                self._at_wheel(word, known[0])
        else:
            found = self._driver_of(word) or self._owner_of(word) or self._at_wheel(word)
            found = found or self._was_driving(word) or self._by_deed(word)
            if found is None and YEARS.search(word.norm) and self.words[word.i - 1].norm == "the":
                found = self._salient(word, lambda e: e.type != "animal" and (e.person or e.manned))
        if found is not None:
            found.names |= names
            found.manned, found.sex = True, found.sex or sex
        return found

    def _aboard_before(self, word: Word) -> Entity | None:
        """The vehicle in or on which a person was: "a girl on a bicycle ... the girl"."""
        noun = word.norm.split(" ")[-1]
        if self.words[word.i - 1].norm not in ("the", "this", "that"):
            return None
        return next((e for e in reversed(self.entities) if noun in e.names and not e.person), None)

    def _driver_of(self, word: Word) -> Entity | None:
        """The vehicle of "a white sedan driven by Mr Tan", "a van driven by a 25-year-old woman"."""
        back = [w for w in self.words[max(0, word.i - 11) : word.i] if w.sentence == word.sentence]
        text = " ".join("@" if w.i in self.of and w.span is not None else w.norm for w in back) + " "
        if DRIVEN_BY.search(text) is None:
            return None
        return next(self.of[w.i] for w in reversed(back) if w.i in self.of and w.span is not None)

    def _owner_of(self, word: Word) -> Entity | None:
        """The vehicle of "Peter's van"."""
        after = self.words[word.i + 1 : word.i + 6]
        if not after or after[0].norm not in ("'s", "'"):
            return None
        for other in after[1:]:
            if other.span is not None and other.span.kind == "actor" and other.span.data["type"] in VEHICLES:
                self.wheels[other.i] = self._new(Entity("", "vehicle"))
                return self.wheels[other.i]
        return None

    def _by_deed(self, word: Word) -> Entity | None:
        """A new one, by what a person of that name does or is said to be ("Ann walked", "Bo, a cyclist,")."""
        verb = self._governor(word)
        clause = " ".join(w.norm for w in self.words[word.i + 1 :] if w.sentence == word.sentence)
        if self._told_what(word):
            return self._new(Entity("", "vehicle"))
        if word.dep in ("nsubj", "nsubjpass"):
            if verb.lemma in WALKS or verb.lemma in ("leave", "set", "go", "return", "head") and AFOOT.search(clause):
                return self._new(Entity("", "pedestrian", typed=True))
            moves = verb.lemma in language.word_list("motion") and verb.lemma not in ("stand", "sit", "lie", "appear")
            return self._new(Entity("", "vehicle")) if moves or verb.lemma in DRIVES else None
        placed = self.words[word.i - 1].norm in ("behind", "of", "past") if word.i else False
        return self._new(Entity("", "vehicle")) if verb.lemma in DRIVES and (word.dep == "dobj" or placed) else None

    def _told_what(self, word: Word) -> bool:
        """Whether the noun that follows says what somebody is on the road: "Ms Lopez, a pedestrian, ..."."""
        text = ""
        for other in self.words[word.i + 1 : word.i + 10]:
            if other.span is not None and other.span.kind == "actor":
                return other.sentence == word.sentence and IS_A.fullmatch(text) is not None
            text += f"{other.norm} "
        return False

"""Whom "he" and "she" mean: somebody on foot, on two wheels, or at the wheel of a vehicle."""

from __future__ import annotations

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.salience import Salience

RIDDEN = frozenset(("bicycle", "motorcycle"))
DRIVERS = frozenset(language.table("people")["drivers"])
STEERS = language.words("steers")
PARTIES = language.words("owners")
AGE = re.compile(r"\b(\d+) ?-? ?year ?-? ?old (?:[\w-]+ ){0,2}$")
OF_A_CLAIM = re.compile(
    r"(?:(?:my|our) client|claimant|plaintiff|complainant|insured|policy ?holder)(?: driver|'s \w+)?$"
)
AT_THE_WHEEL = frozenset(("driver", "d", "operator", "op", "opr"))
"""Labels of who drives a vehicle of that number ("D2")."""


@cache
def _nouns() -> dict[str, str]:
    """Noun for a person -> sex."""
    return {noun: sex for sex, nouns in language.table("people")["nouns"].items() for noun in nouns}


class Persons(Salience):
    """The part of Cast that resolves pronouns of persons."""

    asking: frozenset[int]

    def _sex(self, word: Word) -> str:
        """Whether a noun means a man or a woman, "" where it does not tell."""
        told = (_nouns().get(part, "") for part in re.split(r"[ -]", word.norm))
        return next((sex for sex in told if sex), "")

    def _man(self, word: Word, entity: Entity) -> None:
        """Note that the person in or on a road user is spoken of by this word."""
        if word.span is not None and (word.span.data.get("person") or entity.person or self._sex(word)):
            entity.manned, entity.sex = True, entity.sex or self._sex(word)
        before = " ".join(w.norm for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence)
        if entity.manned and (aged := AGE.search(before + " ")):
            entity.names.add(f"{aged[1]}-year-old")
        head = self.words[word.head]
        above = self.words[head.head] if word.dep == "pobj" and head.norm == "of" else head
        part = word.dep in ("pobj", "poss", "compound", "nmod") and above.lemma in DRIVERS
        label = word.span is not None and word.span.kind == "label" and word.span.data["word"] in AT_THE_WHEEL
        party = entity.ego and OF_A_CLAIM.match(word.norm) is not None and self.words[word.i - 1].norm != "your"
        entity.manned = entity.manned or part or label or party or entity.noun in PARTIES
        if part and above.dep in ("nsubj", "nsubjpass"):
            self.subjects.append((above.i, entity))  # "the driver of the van saw me"
        steers = self.words[head.i] if head.norm in STEERS and word.dep == "dobj" else None
        subjects = [self.words[c] for c in steers.children if self.words[c].dep == "nsubj"] if steers else []
        entity.manned = entity.manned or any(w.tag.startswith("NN") and w.i not in self.of for w in subjects)

    def _he(self, word: Word) -> Entity | None:
        """Whom "he" or "she" means."""
        wanted = (
            "m"
            if word.norm in ("he", "him", "his", "himself")
            else "f"
            if word.norm[:1] == "s" or word.norm[:3] == "her"
            else ""
        )
        mine = self._first_person()  # who says "I" is never "he"
        alive = lambda e: e is not None and e.type != "animal" and (e.person or e.manned or e.type in RIDDEN)  # noqa: E731
        me = lambda e: mine and e.ego and not e.manned or e.sex == "i"  # noqa: E731
        fits = lambda e: alive(e) and not (wanted and e.sex and e.sex != wanted) and not me(e)  # noqa: E731
        told = lambda e: fits(e) and bool(wanted) and e.sex == wanted  # noqa: E731
        sexed = self._salient(word, told) if any(e.person and told(e) for e in self.entities) else None
        owner = None
        found = owner or sexed or self._salient(word, fits)
        if found is None and mine:
            found = self._salient(word, lambda e: e.mover and not e.ego and e.sex != "i")
        if found is None:
            found = self._salient(word, lambda e: e.type in RIDDEN and e.sex != "i") or found
        if found is not None and found.manned:
            found.sex = found.sex or wanted
        return found or self._salient(word, lambda e: e.mover and e.sex != "i" and e.count == 1)

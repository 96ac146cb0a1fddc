"""Whom "he" and "she" mean: somebody on foot, on two wheels, or at the wheel of a vehicle."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, PERSONS, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.parts import DRIVING
from c2s_engine.interpret.who.salience import Salience

RIDDEN = frozenset(("bicycle", "motorcycle"))
RESTS = language.words("rests")
DRIVERS = frozenset(language.table("people")["drivers"])
STEERS = language.words("steers")
STRIKES = language.words("strikes") | {"catch", "knock", "contact"}
CONTACT = STRIKES | language.words("contact") | {"smash", "slam", "plough", "plow", "shunt", "bump"}
BODY = language.words("body") | language.words("flanks") | {"boot", "trunk"}
SAYS = language.words("says")
PARTIES = language.words("owners")
REACTS = language.words("reacts")
AGE = re.compile(r"\b(\d+) ?-? ?year ?-? ?old (?:[\w-]+ ){0,2}$")
OF_A_CLAIM = re.compile(
    r"(?:(?:my|our) client|claimant|plaintiff|complainant|insured|policy ?holder)(?: driver|'s \w+)?$"
)
OBLIQUE = {"he": "him", "she": "her"}
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
        if (who := self._aboard(word)) is not None:
            entity.manned, entity.sex = True, entity.sex or self._sex(who)
            entity.names.add(who.norm.split(" ")[-1])  # "a girl on a bicycle ... the girl"
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

    def _aboard(self, word: Word) -> Word | None:
        """The noun of the person in or on a vehicle: "a woman in a Corolla"."""
        by = self.words[word.head]
        above = self.words[by.head]
        person = above.span is not None and above.span.kind == "actor" and above.span.data["type"] in PERSONS
        return above if person and (by.norm in ("in", "on") or by.norm in DRIVING) and above.i < word.i else None

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
        striker = self._striker_of(word)
        alive = lambda e: e is not striker and e.type != "animal" and (e.person or e.manned or e.type in RIDDEN)  # noqa: E731
        me = lambda e: mine and e.ego and not e.manned or e.sex == "i"  # noqa: E731
        fits = lambda e: alive(e) and not (wanted and e.sex and e.sex != wanted) and not me(e)  # noqa: E731
        told = lambda e: fits(e) and bool(wanted) and e.sex == wanted  # noqa: E731
        sexed = self._salient(word, told) if any(e.person and told(e) for e in self.entities) else None
        at_wheel = lambda e: fits(e) and not e.person and (e.manned or e.ego)  # noqa: E731
        owner = self._salient(word, at_wheel) if self._of_a_struck_one(word) else None
        found = self._telling(word, fits) or self._reacting(word, fits) or owner or sexed or self._salient(word, fits)
        if found is None and mine:
            found = self._salient(word, lambda e: e.mover and not e.ego and e.sex != "i")
        if found is None or not found.manned and found.type not in RIDDEN and self._rests(found):
            found = self._salient(word, lambda e: e.type in RIDDEN and e.sex != "i") or found
        if found is not None and found.manned:
            found.sex = found.sex or wanted
        spoken = any(w.lemma in DRIVERS and w.span is None for w in self.words[: word.i])
        if found is None and spoken and not mine and not any(e.mover and e.type != "animal" for e in self.entities):
            return self.ego  # "according to the driver, a dog ran in front of his car"
        return found or self._salient(word, lambda e: e.mover and e.sex != "i" and e.count == 1)

    def _of_a_struck_one(self, word: Word) -> bool:
        """Whether it is whose vehicle is hit: of one who drives, not of one on foot ("let a woman cross, when a van hit
        the rear of her car")."""
        span = self.words[word.head].span
        vehicle = span is not None and span.kind == "actor" and span.data["type"] in MOTOR
        return vehicle and word.dep == "poss" and self._governor(word).lemma in CONTACT

    def _striker_of(self, word: Word) -> Entity | None:
        """Who strikes a part of him or her, whom that word therefore does not mean: "the front of the bus caught her
        wheel"."""
        verb, part = self._governor(word), self.words[word.head]
        into = (
            part.dep == "pobj" and self.words[part.head].norm == "into" and part.lemma in BODY
        )  # "rode into his door"
        if word.dep != "poss" or not into and (part.dep != "dobj" or verb.lemma not in STRIKES):
            return None
        subject = next((c for c in verb.children if self.words[c].dep == "nsubj"), None)
        return self.referent(subject) if subject is not None else None

    def _telling(self, word: Word, accept: Callable[[Entity], bool]) -> Entity | None:
        """Who tells of himself at the wheel: "the driver of the van told police he was doing 40"."""
        verb = self._governor(word)
        above = self.words[verb.head]
        says = above if above.verb else self.words[above.head]  # hung on "police"
        if word.dep != "nsubj" or verb.dep not in ("ccomp", "relcl") or says.lemma not in SAYS or says.i > word.i:
            return None
        who = next((self.words[c] for c in says.children if self.words[c].dep == "nsubj" and c < says.i), None)
        if who is None:
            return None
        owners = [i for c in who.children if self.words[c].norm in ("of", "'s") for i in self.words[c].children]
        found = next((self.of[i] for i in (who.i, *owners, *who.children) if i in self.of), None)
        if found is None and who.lemma in DRIVERS:
            found = self._salient(word, lambda e: e.mover and not e.person and e.sex != "i" and not self._rests(e))
        return found if found is not None and (accept(found) or who.lemma in DRIVERS) else None

    def _reacting(self, word: Word, accept: Callable[[Entity], bool]) -> Entity | None:
        """Whom the sentence before left in trouble, where somebody reacts then: "... in front of him. He braked"."""
        if word.dep != "nsubj" or word.norm not in OBLIQUE or self._governor(word).lemma not in REACTS:
            return None
        before = [w for w in self.words[: word.i] if w.sentence >= word.sentence - 1 and w.i in self.of]
        if not before or any(w.sentence == word.sentence for w in before):
            return None
        meant = [w for w in before if w.norm == OBLIQUE[word.norm] and w.dep in ("dobj", "pobj", "poss")]
        found = self.of[meant[-1].i] if meant else None
        return found if found is not None and accept(found) else None

    def _rests(self, entity: Entity) -> bool:
        """Whether a vehicle was told of as standing: nobody in it is "he"."""
        verbs = (self._governor(self.words[m.word]) for m in entity.mentions[:2])
        return any(v.lemma in RESTS for v in verbs)

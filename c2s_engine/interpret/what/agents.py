"""Who does it: agents by the grammatical relations, with passives, relatives and inversions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.subjectless import Subjectless
from c2s_engine.interpret.who.mentions import Cast, Entity

if TYPE_CHECKING:
    from c2s_engine.interpret.what.event import Event
PACE = frozenset(("speed", "velocity", "pace"))
BELIEVED = language.words("believed")
ALONG = frozenset(("past", "across", "along", "through", "around", "round"))


class Agents(Subjectless):
    """The part of Clauses that finds the parties of a verb or noun."""

    words: list[Word]
    cast: Cast
    events: list[Event]
    by_word: dict[int, Event]

    def _whose_speed(self, word: Word) -> Entity | None:
        """Whose speed it is that rises or falls: "its speed drops", "the speed of the car increases"."""
        if word.norm not in PACE:
            return None
        owners = [self.words[c] for c in word.children if self.words[c].dep == "poss"]
        of = [self.words[c] for c in word.children if self.words[c].norm == "of"]
        owners += [self.words[c] for prep in of for c in prep.children if self.words[c].dep == "pobj"]
        return next((found for owner in owners if (found := self.cast.referent(owner.i)) is not None), None)

    def _subject(self, word: Word, depth: int = 0) -> tuple[Entity | None, int | None, bool]:
        """(agent, its word, whether the verb is passive)."""
        passive = any(self.words[c].dep in ("auxpass",) for c in word.children) or any(
            self.words[c].dep == "nsubjpass" for c in word.children
        )
        passive = passive or word.tag == "VBN" and any(self.words[c].dep == "agent" for c in word.children)
        subjects = [c for c in word.children if self.words[c].dep in ("nsubj", "nsubjpass", "csubj")]
        subjects = [c for c in subjects if not self.words[c].norm.endswith("self")] or subjects  # "its driver himself"
        helping = [h for h in word.children if self.words[h].dep == "aux"]  # "when a van came flying through"
        subjects = subjects or [c for h in helping for c in self.words[h].children if self.words[c].dep == "nsubj"]
        subjects.sort(key=lambda c: (c > word.i, -c))
        if passive:
            late = None
            for child in word.children:
                if (
                    self.words[child].dep == "agent"
                    or self.words[child].norm == "by"
                    and self.words[child].dep == "prep"
                ):
                    for target in self.words[child].children:
                        found = self.cast.referent(target)
                        if found:
                            return found, target, True
            by = self._late_by(word)
            if by is not None:
                return self.cast.of[by], by, True
            whom = next((self.cast.referent(c) or self._whose_speed(self.words[c]) for c in subjects), None)
            if whom is None:
                whom = self._inherited(word, depth)[0]
            return (None, None, True) if whom is None else (whom, subjects[0] if subjects else None, True)
        for child in subjects:
            other = self.words[child]
            found = self.cast.referent(child) or self._reduced(other) or self._whose_speed(other)
            if found:
                return found, child, False
            if other.lemma in ("there",) or other.dep == "expl":
                continue
            if child < word.i and self._lemma(word) in (
                "come",
                "run",
                "drive",
                "stand",
                "go",
                "lie",
                "ride",
                "travel",
                "sit",
                "wait",
                "walk",
                "be",
            ):
                late = [
                    c
                    for c in word.children
                    if c > word.i and self.words[c].dep in ("dobj", "attr", "nsubj") and c in self.cast.of
                ]
                if late:
                    return self.cast.of[late[0]], late[0], False
            return None, child, False
        if any(self.words[c].dep == "expl" for c in word.children):
            for child in word.children:
                if self.words[child].dep in ("attr", "dobj"):
                    return self.cast.referent(child), child, False
        told = self._after_bracket(word)
        if told is not None:
            return self.cast.of[told], told, False
        return self._inherited(word, depth)

    def _reduced(self, word: Word) -> Entity | None:
        """The noun of "vehicle approaching from the left does not yield", which is parsed as a clause for a subject."""
        if word.dep != "csubj" or word.tag not in ("VBG", "VBN"):
            return None
        nouns = [c for c in word.children if c < word.i and self.words[c].dep in ("nsubj", "nsubjpass")]
        return self.cast.referent(nouns[0]) if nouns else None

    def _inherited(self, word: Word, depth: int) -> tuple[Entity | None, int | None, bool]:
        head = self.words[word.head]
        if head.i == word.i and depth <= 6:
            inverted = self._inverted(word)
            if inverted[0] is not None:
                return inverted
            for child in word.children:
                if (
                    child < word.i
                    and self.words[child].dep == "ccomp"
                    and any(self.words[c].dep == "nsubj" for c in self.words[child].children)
                ):
                    return self._subject(self.words[child], depth + 1)
            return None, None, False
        if word.dep in ("acl", "relcl"):
            found = self.cast.referent(head.i)
            if found is not None:
                if word.tag == "VBN" and word.dep == "acl":
                    for child in word.children:
                        if self.words[child].dep == "agent":
                            for target in self.words[child].children:
                                self.cast.referent(target)
                return found, head.i, word.dep == "acl" and word.tag == "VBN"
            if word.dep == "acl" and head.tag.startswith("NN"):
                above = self._governor(head)
                bound = word.tag == "VB" or word.tag == "VBG" and head.dep != "pobj"  # "over a tyre lying there"
                if above is not None and above.i != word.i and bound:
                    return self._subject(above, depth + 1)
            return None, head.i, False
        if word.dep == "xcomp" and head.dep == "acomp" and self.words[head.head].verb:  # "is able to go by"
            return self._subject(self.words[head.head], depth + 1)
        if word.dep in {"xcomp", "ccomp"}:
            for child in head.children:
                other = self.words[child]
                if other.dep == "dobj" and child < word.i and head.lemma not in ("use", "borrow", "cross", "enter"):
                    found = self.cast.referent(child)
                    if found:
                        return found, child, False
            if head.verb:
                agent, at, passive = self._subject(head, depth + 1)
                if passive and head.verb:
                    subjects = [c for c in head.children if self.words[c].dep == "nsubjpass"]
                    if subjects and self.cast.referent(subjects[0]):
                        return self.cast.referent(subjects[0]), subjects[0], False
                return agent, at, False
        if word.dep in ("pcomp", "advcl", "conj", "parataxis", "dep", "csubj", "prep", "amod", "appos", "punct"):
            above = head if head.verb or self._is_verb(head) else self._governor(head)
            past = (
                word.tag == "VBN" and above is not None and above.tag == "VBG" and above.dep == "ccomp"
            )  # "and braked"
            finite = past or word.tag in ("VBZ", "VBD", "VBP")
            if word.dep == "conj" and above is not None and finite:
                comma = self.words[word.i - 1].norm == ","
                if (
                    (above.tag == "VB" and above.dep in ("ccomp", "xcomp") or above.dep == "advcl" and comma)
                    or above.dep == "ccomp"
                    and above.tag == "VBG"
                    and word.tag in ("VBD", "VBN")
                    and self._lemma(self.words[above.head]) in BELIEVED  # "thought V1 had gone and ran into it"
                    or above.dep == "advcl"
                    and self.words[word.i - 1].norm == "then"
                    and self.words[word.i - 2].norm != "and"
                ):
                    above = self._governor(above) or above
            above = self._joined_verb(word, above)
            if above is not None and above.i != word.i:
                if word.dep == "csubj":
                    found = next(
                        (
                            self.cast.referent(c)
                            for c in above.children
                            if self.words[c].dep in ("attr", "nsubj") and c > word.i
                        ),
                        None,
                    )
                    if found is not None:
                        return found, above.i, False
                if word.dep == "csubj" and not any(self.words[c].dep in ("nsubj", "attr") for c in above.children):
                    return self._inverted(word)
                inverted = (
                    self._inverted(word)
                    if word.dep in ("conj",) and word.tag in ("VBZ", "VBD") and word.i > above.i
                    else (None, None, False)
                )
                if inverted[0] is not None:
                    return inverted
                agent, at, passive = self._subject(above, depth + 1)
                if passive:
                    passed = [c for c in above.children if self.words[c].dep == "nsubjpass"]
                    if passed and self.cast.referent(passed[0]):
                        return self.cast.referent(passed[0]), passed[0], False
                    if above.dep == "ROOT" and not passed and self._headless(above):
                        return None, None, False
                return agent, at, False
        return self._inverted(word)

    def _inverted(self, word: Word) -> tuple[Entity | None, int | None, bool]:
        """ "Up from behind comes a motorcyclist"; "standing in the lane is a car"."""
        for child in word.children:
            other = self.words[child]
            if (
                child > word.i
                and other.dep in ("attr", "nsubj", "dobj")
                and self._lemma(word)
                in (
                    "come",
                    "be",
                    "stand",
                    "lie",
                    "sit",
                    "follow",
                    "appear",
                    "emerge",
                    "approach",
                    "drive",
                    "ride",
                    "run",
                    "walk",
                    "go",
                    "shoot",
                    "dart",
                    "roll",
                    "step",
                )
            ):
                found = self.cast.referent(child)
                if found and (
                    self._lemma(word) not in ("approach", "follow", "drive", "ride")
                    or any(c < word.i for c in word.children)
                ):
                    return found, child, False
        return None, None, False

    def _nearest(self, word: Word, at: int | None) -> Entity | None:
        """The nearest noun before the verb that no preposition governs, where the tree gives no agent."""
        if (
            any(
                self.words[c].dep in ("nsubj", "nsubjpass")
                and not self.words[c].span
                and self.words[c].norm not in ("traffic", "one", "which", "that", "who")
                for c in word.children
            )
            and at is not None
        ):
            return None
        if word.tag not in ("VBZ", "VBD", "VBP"):
            return None
        for i in range(word.i - 1, max(-1, word.i - 16), -1):
            other = self.words[i]
            if other.sentence != word.sentence or other.norm in (";", ":"):
                return None
            if (
                i in self.cast.of
                and (other.dep not in ("pobj", "poss", "dobj") or i == word.i - 1 and other.dep == "dobj")
                and other.tag != "PRP$"
            ):
                return self.cast.of[i]
        return None

"""Whether something is said to happen: negation, modality, intentions, conditions, alternatives."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.agents import Agents

CONTACT = language.words("contact")


LETTING = ("let", "allow", "permit")


THOSE = frozenset(("that", "this", "which"))
NOBODY = ("nobody", "noone", "none")
MEANWHILE = ("while", "whilst", "when", "as", "before", "after", "because", "since")


class Modes(Agents):
    """The part of Clauses that tells facts from what is denied, meant or only imagined."""

    def _mode(self, word: Word) -> str:
        """Whether it is said to happen."""
        mode = "fact"
        shades = language.table("motions")["modality"]
        for child in word.children:
            other = self.words[child]
            if other.dep == "neg" or other.norm in ("never", "neither", "nor", "hardly", "cannot", "not"):
                if other.norm == "not" and child > word.i and other.dep != "neg":
                    continue
                mode = "negated"
            if other.norm == "longer" and self.words[child - 1].norm in ("no", "any"):
                mode = "negated"
            doubted = other.dep == "aux" and other.norm in ("would", "could", "might")
            if doubted:
                mode = "hypothetical"
            if other.dep == "mark" and other.norm in ("if", "unless", "whether", "lest"):
                mode = "hypothetical"
            if other.dep in ("nsubj", "nsubjpass") and (
                other.norm in ("none", "neither", "nobody", "nothing")
                or any(self.words[c].norm in ("no", "neither") for c in other.children)
            ):
                mode = "negated"
        head = self.words[word.head]
        if (
            word.dep == "pcomp"
            and head.norm in ("without", "of")
            and (head.norm == "without" or self.words[head.head].norm in ("instead", "rather"))
        ):
            return "negated"
        if (
            word.dep == "pcomp"
            and head.norm == "before"
            and self._lemma(word) in (*CONTACT, "touch", "reach", "contact")
        ):
            main = self.words[head.head]
            must = any(self.words[c].norm in ("shall", "must", "should") for c in main.children)
            if must or self._lemma(main) in ("stop", "halt"):
                return "negated"
        if word.dep in ("xcomp", "ccomp", "advcl", "acl", "conj", "pcomp", "relcl") and head.i != word.i:
            lemma = head.lemma
            if word.dep in ("pcomp", "prep"):
                lemma = self.words[head.head].lemma
            to = any(self.words[c].norm == "to" and self.words[c].dep == "aux" for c in word.children)
            if (
                (
                    word.dep in ("xcomp", "ccomp", "pcomp")
                    or word.dep == "advcl"
                    and head.i < word.i
                    and self.words[word.i - 1].norm != ","
                    and self._mark(word) not in MEANWHILE
                )
                and lemma
                in (
                    "fail",
                    "forget",
                    "neglect",
                    "refuse",
                    "omit",
                    "unable",
                    "avoid",
                    "prevent",
                    "refrain",
                    "decline",
                    "impossible",
                    "inability",
                    "keep",
                    "hinder",
                    "block",
                    "bar",
                )
                and (word.dep != "ccomp" or word.i > head.i)  # not what is told before: "the car brakes, ego avoids it"
                and (lemma not in ("keep", "block", "bar") or word.dep == "pcomp" and word.tag == "VBG")
                and (word.dep != "pcomp" or head.norm in ("from", "of", "in", "to"))
            ):
                return "negated" if mode != "negated" else "fact"
            if word.dep in ("xcomp", "advcl", "acl") and lemma in shades["intended"] and (to or lemma == "about"):
                mode = ("intended") if mode == "fact" else mode
                if self._mode(head) in ("negated", "hypothetical") and head.verb:
                    mode = "negated"
            elif (
                word.dep in ("xcomp", "ccomp") and head.lemma in ("able", "capable", "possible") and head.head != head.i
            ):
                above = self._mode(self.words[head.head])
                mode = above if above in ("negated", "hypothetical") and mode == "fact" else mode
            elif (word.dep == "xcomp" or lemma in LETTING) and head.verb and self._is_verb(head):
                above = self._mode(head)
                if above in ("negated", "hypothetical") and mode == "fact":
                    mode = above
            elif word.dep == "advcl" and to and mode == "fact":
                so_not = any(self.words[c].norm in ("not",) for c in word.children)
                mode = "negated" if so_not else "purpose"
            elif word.dep == "conj" and head.verb:
                above = self._mode(head)
                own_subject = any(self.words[c].dep in ("nsubj", "nsubjpass", "aux") for c in word.children)
                if (
                    above in ("hypothetical", "negated", "purpose")
                    and not own_subject
                    and word.tag in ("VB", "VBN")
                    and not (head.tag == "VBG" and head.dep == "ccomp" and word.tag == "VBN")  # "and braked"
                    and self._lemma(word) not in CONTACT
                ):
                    mode = above
        denied = word.dep == "csubj" and head.verb and self._reduced(word) is None
        if denied and self._mode(head) in ("negated", "hypothetical"):
            mode = self._mode(head)
        if (
            word.dep == "conj"
            and mode in ("fact", "intended")
            and any(self.words[c].norm == "or" and c < word.i for c in head.children)
        ):
            mode = "alternative"
        before = [w.norm for w in self.words[max(0, word.i - 3) : word.i] if w.sentence == word.sentence]
        if (
            before[-2:] in (["rather", "than"], ["instead", "of"])
            or before[-1:] == ["nor"]
            or before[-1:] == ["without"]
        ):
            mode = "negated"
        return mode

    def _mark(self, word: Word) -> str:
        for child in sorted(word.children):
            other = self.words[child]
            nouns = [self.words[c] for c in other.children if self.words[c].dep == "pobj"]
            if other.dep == "prep" and (nouns or {self.words[c].norm for c in other.children} & THOSE):
                continue  # "after that", "after some 20 meters"
            if child < word.i and (
                other.dep == "mark"
                or other.norm in ("when", "while", "as", "after", "before", "until", "once", "where", "till")
            ):
                return other.norm
        head = self.words[word.head]
        if word.dep == "pcomp":
            return head.norm
        first = [
            w
            for w in self.words[max(0, word.i - 6) : word.i]
            if w.sentence == word.sentence and w.norm in ("as", "once")
        ]
        return "as" if first and word.dep == "advcl" else ""

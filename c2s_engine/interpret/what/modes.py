"""Whether something is said to happen: negation, modality, intentions, conditions, alternatives."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.agents import Agents

CONTACT = language.words("contact")


LETTING = ("let", "allow", "permit")
BELIEVED = language.words("believed")
UNREAL = language.words("unreal")
CHANCES = language.words("chances")
SEEKS = language.words("seeks")


THOSE = frozenset(("that", "this", "which"))
ENDS = language.words("ends")
RUNS = language.words("runs_of_tests")
OPTIONS = frozenset(("option", "choice", "alternative", "possible", "feasible", "way"))
NOBODY = ("nobody", "noone", "none")
MEANWHILE = ("while", "whilst", "when", "as", "before", "after", "because", "since")
DUTIES = ("have", "need", "require", "oblige", "suppose", "force")


class Modes(Agents):
    """The part of Clauses that tells facts from what is denied, meant or only imagined."""

    def _told_with_would(self, word: Word) -> bool:
        """Whether "would" only tells what happens in a scenario ("after 5 s the lead would brake"), on no condition."""
        perfect = any(self.words[c].norm == "have" for c in word.children)
        somebody = any(self.words[c].dep == "nsubj" and c in self.cast.of for c in word.children)
        if word.dep not in ("ROOT", "conj") or perfect or not somebody:
            return False
        return not UNREAL & {w.norm for w in self.words if w.sentence == word.sentence}

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
            if other.dep == "dobj" and other.norm in NOBODY:
                mode = "negated"
            doubted = (
                other.dep == "aux" and other.norm in ("would", "could", "might") and not self._ended(child, word.i)
            )
            if doubted and not (other.norm == "would" and self._told_with_would(word)):
                mode = "hypothetical"
            if (
                other.dep == "mark"
                and other.norm in ("if", "unless", "whether", "lest")
                and not (self._criterion(word))
            ):
                mode = "hypothetical"
            if other.dep in ("nsubj", "nsubjpass") and (
                other.norm in ("none", "neither", "nobody", "nothing")
                or any(self.words[c].norm in ("no", "neither") for c in other.children)
            ):
                mode = "negated"
        head = self.words[word.head]
        if word.dep == "advcl" and self._ends_run(head):
            return "hypothetical"  # "the test ends when the SV hits the POV"
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
                if above == "intended" and not own_subject and word.tag == "VB":
                    mode = above
        if mode == "fact" and self._only_believed(word):
            mode = "hypothetical"
        if mode == "negated" and self._no_duty(word):
            mode = "hypothetical"
        if word.dep in ("acl", "relcl") and head.lemma in CHANCES and self._sought(head):
            mode = "hypothetical"
        denied = word.dep == "csubj" and head.verb and self._reduced(word) is None
        if denied and self._mode(head) in ("negated", "hypothetical"):
            mode = self._mode(head)
        if word.dep == "csubj" and self._no_option(head):
            mode = "negated"
        if (
            word.dep == "pcomp"
            and (noun := self.words[head.head]).tag.startswith("NN")
            and any(self.words[c].norm == "no" for c in noun.children)
        ):
            mode = "negated"
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

    def _only_believed(self, word: Word) -> bool:
        """Whether somebody only believed that it was going on or about to: "he thought that V2 was turning"."""
        above = self.words[word.head]
        going_on = word.tag == "VBG" and any(self.words[c].norm in ("was", "were") for c in word.children)
        believed = self._lemma(above) in BELIEVED and above.tag in ("VBD", "VBG", "VBN")
        return word.dep == "ccomp" and going_on and believed and above.i < word.i

    def _no_option(self, verb: Word) -> bool:
        """Whether what a clause tells is said to be none of one's options: "moving over was no option"."""
        told = [self.words[c] for c in verb.children if self.words[c].dep in ("attr", "acomp")]
        denied = any(self.words[c].norm in ("no", "not") for w in told for c in (*w.children, *verb.children))
        return any(w.norm in ("impossible", "unthinkable") or denied and w.norm in OPTIONS for w in told)

    def _ends_run(self, verb: Word) -> bool:
        """Whether a verb tells what ends the test, not what happens in it."""
        subjects = [self.words[c].lemma for c in verb.children if self.words[c].dep in ("nsubj", "nsubjpass")]
        return self._lemma(verb) in ENDS and any(s in RUNS for s in subjects)

    def _no_duty(self, word: Word) -> bool:
        """Whether one only need not do it: "does not have to stop", "is not required to stop"."""
        head = self.words[word.head]
        need = any(self.words[c].norm in ("need", "needn't") for c in word.children if self.words[c].dep == "aux")
        return need or word.dep in ("xcomp", "ccomp") and head.lemma in DUTIES and self._mode(head) == "negated"

    def _sought(self, noun: Word) -> bool:
        """Whether somebody only waits or looks for something: "waiting for a chance to pass"."""
        above = self.words[noun.head]
        verb = self.words[above.head] if above.dep == "prep" else above
        return self._lemma(verb) in SEEKS

    def _ended(self, aux: int, verb: int) -> bool:
        """Whether "but" or "and" ends an auxiliary's clause before the verb ("as hard as I could but hit it")."""
        return bool({"but", "and"} & {w.norm for w in self.words[aux + 1 : verb]})

    def _criterion(self, word: Word) -> bool:
        """Whether an if-clause states what a test demands: "passed if the system brakes"."""
        return self.words[word.head].lemma in (
            "pass",
            "succeed",
            "accept",
            "fulfil",
            "satisfy",
            "meet",
            "deem",
            "consider",
            "successful",
            "fulfill",
        )

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

"""Verbs of the text that led to nothing in S: neither an act, nor a place, nor what somebody sees or is hidden by."""

from collections.abc import Iterator
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.accounting.clauses import span_of
from c2s_engine.interpret.reading.motions import base_form
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.scene import Scene

Span = tuple[int, int]

NO_PREDICATE = frozenset(("aux", "auxpass", "amod", "compound", "pcomp", "prep", "csubj", "nsubj", "nsubjpass"))
BARE = frozenset(("be", "have", "involve", "contain", "feature", "include", "consist", "show", "depict"))
"""Verbs that only put somebody there: who is named with them is understood by being in S."""
LISTS = ("notices", "hides", "has_before_one", "stands_still", "waits", "tows", "steers", "says", "begins", "ends")
"""Words of verbs that say who is there, where, or that somebody else does something."""
MEETS = frozenset(("detect", "sense", "confront", "encounter", "face", "spawn"))
"""Who is named with these is there, too."""


class UnaccountedVerbs:
    """The verbs of a scene that led to nothing in S."""

    def __init__(self, scene: Scene, known: set[int]) -> None:
        """`known`: the words that name who is in S."""
        self.scene, self.known = scene, known
        self.read = {e.word for e in scene.clauses.events if not _begun(scene, e.word, e.act, e.agent.mover)}

    def in_clause(self, words: list[Word]) -> Iterator[tuple[Word, Span]]:
        """Each such verb, and the span of it and of what goes with it in the clause."""
        for word in words:
            if self._is_predicate(word) and self._of_somebody(word):
                below = [w for w in words if w.start >= word.start and self._under(w, word)]
                while below[-1].tag[:1] in ".,:" or below[-1].dep == "cc":
                    below.pop()
                yield word, span_of(below)

    def _is_predicate(self, word: Word) -> bool:
        told = word.dep in ("xcomp", "ccomp") and word.head in self.read  # "lets a cyclist pass"
        done = told or word.i in self.read or word.i in self.scene.clauses.light or word.i in self.known
        forms = {word.lemma, word.norm, word.norm.removesuffix("s"), base_form(word.norm, word.lemma)}
        plain = forms & (BARE | MEETS | _of_presence()) or word.tag == "VBN" and forms & language.words("puts")
        return word.tag.startswith("VB") and word.dep not in NO_PREDICATE and not done and not plain

    def _of_somebody(self, word: Word) -> bool:
        """Whether its subject, its own or that of the verb before, is a road user or a thing on the road."""
        cast = self.scene.cast.of
        at = word
        for _ in range(len(self.scene.words)):
            if at.dep in ("acl", "relcl") and (at.tag == "VBG" or at.dep == "relcl") and at.head in cast:
                return True
            subjects = [c for c in at.children if self.scene.words[c].dep in ("nsubj", "nsubjpass")]
            if subjects or at.dep != "conj" or at.head == at.i:
                return any(c in cast for c in subjects)
            at = self.scene.words[at.head]
        return False

    def _under(self, word: Word, verb: Word) -> bool:
        at = word
        for _ in range(len(self.scene.words)):
            if at.i == verb.i:
                return True
            if at.head == at.i or at.dep == "conj" and at.head == verb.i and at.tag.startswith("VB"):
                return False
            at = self.scene.words[at.head]
        return False


def _begun(scene: Scene, i: int, act: str, mover: bool) -> bool:
    """Whether a thing is told as falling: in S it lies there from the start."""
    word = scene.words[i]
    return act == "stationary" and not mover and word.lemma in _falls() and word.tag != "VBN"


@cache
def _falls() -> frozenset[str]:
    rows = language.table("motions")["verbs"]
    return frozenset(v for r in rows if r["act"] == "stationary" and r.get("who") == "thing" for v in r["verbs"])


@cache
def _of_presence() -> frozenset[str]:
    return frozenset(word for name in LISTS for word in language.words(name))

"""Verbs that the tree hangs on the wrong verb: those on a relative clause that go on with the clause before it ("ego
follows a tractor that crawls along and overtakes it": who crawls along cannot overtake itself), and the like."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.joined_subjects import restore_joined_subject
from c2s_engine.interpret.reading.lost_subjects import find_subject
from c2s_engine.interpret.reading.misattached_phrases import reattach_phrase
from c2s_engine.interpret.reading.tree_edits import attach, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

TOWED, SEES, WAITS = language.with_plurals("towed"), language.words("notices"), language.words("waits")


def reattach(words: list[Word]) -> None:
    """Hang each such verb where it belongs."""
    for word in words:
        restore_joined_subject(words, word)
        find_subject(words, word)
        reattach_phrase(words, word)
        _by_which(words, word)
        _two_subjects(words, word)


def _by_which(words: list[Word], using: Word) -> None:
    """Hang "using" on the verb whose object the tree takes for who uses it: "overtakes ego using the other lane"."""
    if using.norm != "using" or using.dep not in ("acl", "ccomp"):
        return
    noun = words[using.head] if using.dep == "acl" else words[using.i - 1]
    verb = None if using.dep == "acl" else words[using.head]
    if verb is None or verb.lemma in SEES:
        return
    if using.dep == "acl" or noun.i in using.children and verb.verb:
        if using.dep == "ccomp":
            attach(words, noun, verb, "dobj")
        attach(words, using, verb, "advcl")


def _two_subjects(words: list[Word], verb: Word) -> None:
    """Join two subjects with "and" between them: "the van in the left lane and the truck in the right lane drift"."""
    subjects = [words[c] for c in verb.children if words[c].dep == "nsubj" and c < verb.i]
    if len(subjects) != 2 or not all(road_user(w) for w in subjects):
        return
    first, second = subjects
    start = min([second.i, *(c for c in second.children if c < second.i)])
    inner = any(w.tag in ("VBZ", "VBD", "VBP", "MD") for w in words[first.i : verb.i])
    if words[start - 1].norm in ("and", "or", "nor") and words[start - 1].head in (first.i, verb.i) and not inner:
        attach(words, second, first, "conj")

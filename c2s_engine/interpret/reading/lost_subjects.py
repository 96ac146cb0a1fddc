"""Subjects that the tree hangs on something else than their verb."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.tree_edits import attach, road_user

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

CONJUNCTIONS = frozenset(("as", "while", "when", "after", "before", "until", "since"))
"""What the tree takes for prepositions before a subject."""
TOLD = frozenset(("latter", "former", "first", "second", "third", "last", "other"))


def find_subject(words: list[Word], word: Word) -> None:
    """Give a verb the subject that the tree took for something else."""
    if (before := _subject_on_time(words, word)) is not None:
        if before.dep == "pobj" and words[before.head].norm in CONJUNCTIONS:
            mark = words[before.head]
            attach(words, mark, word)
            mark.dep = "mark"  # "starts accelerating as a pedestrian crosses"
        attach(words, before, word)
        before.dep = "nsubj"
    _between_two(words, word)
    if word.verb:
        _listed(words, word)


def _subject_on_time(words: list[Word], verb: Word) -> Word | None:
    """The road user that is taken for a part of the time before it ("after ten seconds a car ahead brakes"), or that a
    conjunction is taken to go with ("as V2, an oncoming vehicle, was turning")."""
    aux = {words[c].dep for c in verb.children} & {"aux", "auxpass"} and verb.dep == "advcl"
    finite = verb.tag in ("VBZ", "VBD", "VBP") or aux
    if not finite or any(words[c].dep.startswith("nsubj") for c in verb.children):
        return None
    for word in reversed(words[: verb.i]):
        if word.sentence != verb.sentence or word.verb and word.head != verb.i:
            return None
        second = word.dep == "pobj" and [c for c in words[word.head].children if words[c].dep == "pobj"][0] < word.i
        told = word.dep == "pobj" and words[word.head].norm in CONJUNCTIONS and verb.dep == "advcl"
        if (second or told or word.dep == "compound" and word.head == verb.i) and road_user(word):
            return word
    return None


def _between_two(words: list[Word], verb: Word) -> None:
    """Give the verb of "the van between ego and the truck changes lanes" its one subject."""
    subjects = [words[c] for c in verb.children if words[c].dep == "nsubj" and c < verb.i]
    if len(subjects) != 2:
        return
    prep = next((words[c] for c in subjects[0].children if words[c].norm == "between"), None)
    first = next((words[c] for c in prep.children if words[c].dep == "pobj"), None) if prep is not None else None
    if first is not None:
        attach(words, subjects[1], first)
        subjects[1].dep = "conj"


def _listed(words: list[Word], verb: Word) -> None:
    """Make one of two subjects with a comma between: a list ("a car, a van and a truck drive"), or another name of the
    first ("the vehicle ahead, a white van, brakes")."""
    before = [words[c] for c in verb.children if c < verb.i and words[c].dep in ("nsubj", "dep")]
    if len(before) != 2 or before[1].dep != "nsubj" or not all(road_user(w) or w.norm in TOLD for w in before):
        return
    first, second = before
    opens = min(second.i, *second.children) if second.children else second.i
    cut = words[opens - 1].norm == "," and words[opens].norm in ("a", "an", "one", "another", "two", "three")
    joined = any(words[c].dep == "cc" for c in second.children)
    if cut and (joined or words[verb.i - 1].norm == "," or words[verb.i - 2].norm == ","):
        attach(words, second, first)
        first.dep, second.dep = "nsubj", "conj" if joined else "appos"

"""Subjects that the tree hangs on something else than their verb."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret.reading.hanging import hang, road_user, under

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

CONJUNCTIONS = frozenset(("as", "while", "when", "after", "before", "until", "since"))
"""What the tree takes for prepositions before a subject."""
TOLD = frozenset(("latter", "former", "first", "second", "third", "last", "other"))


def find_subject(words: list[Word], word: Word) -> None:
    """Give a verb the subject that the tree took for something else."""
    joined = word.dep == "conj" and words[word.i - 1].norm == ","
    if (word.dep == "advcl" or joined) and (before := _named_after_place(words, word)) is not None:
        hang(words, before, word)
        before.dep, word.dep = "nsubj", "conj"
    if (before := _after_a_comma(words, word)) is not None:
        hang(words, before, word)
        before.dep = "nsubj"
        placed = words[before.i + 1]
        if placed.head != before.i and not under(words, word, placed):
            hang(words, placed, before)
    if word.dep == "conj" and (before := _subject_before(words, word)) is not None:
        hang(words, before, word)
        before.dep = "nsubj"  # "slowed and V1 struck it": V1 was taken for somebody else that slowed
    if (before := _subject_on_time(words, word)) is not None:
        if before.dep == "pobj" and words[before.head].norm in CONJUNCTIONS:
            mark = words[before.head]
            hang(words, mark, word)
            mark.dep = "mark"  # "starts accelerating as a pedestrian crosses"
        hang(words, before, word)
        before.dep = "nsubj"
    if (before := _subject_of_second(words, word)) is not None:
        for first in (words[c] for c in word.children):
            first.dep = "ccomp" if first.dep == "nsubj" else first.dep  # the verb before
        hang(words, before, word)
        before.dep = "nsubj"
    _between_two(words, word)
    if word.verb:
        _listed(words, word)
        _behind_place(words, word)


def _subject_of_second(words: list[Word], verb: Word) -> Word | None:
    """The road user that the tree joins to a noun before, though it is whom a second verb with an auxiliary tells of:
    "a child should cross the road and a taxi parked on the right should pull out"."""
    aux = next((words[c] for c in sorted(verb.children) if words[c].dep == "aux" and c < verb.i), None)
    if aux is None or any(words[c].dep.startswith("nsubj") and words[c].noun for c in verb.children):
        return None
    if aux.tag == "TO" and not (words[verb.head].tag == "VB" and verb.dep == "advcl"):
        return None
    own: set[int] = set()
    for word in reversed(words[: aux.i]):
        if word.sentence != verb.sentence or word.norm in (",", ";"):
            return None
        own.add(word.i)
        if word.dep == "conj" and road_user(word) and not word.verb:
            inside = all(i == word.i or under(words, words[i], word) for i in own)
            joined = any(w.norm == "and" for w in words[max(0, word.i - 4) : word.i])
            return word if inside and joined and not under(words, verb, word) else None
    return None


def _named_after_place(words: list[Word], word: Word) -> Word | None:
    """The road user behind "and" that the tree has beside a place: "changed to lane two and V1 struck V3"."""
    before = words[word.i - 1] if word.i > 1 else None
    if before is not None and before.norm == ",":  # "and V1, which did not stop, struck it"
        told = [w for w in words[: word.i - 2] if w.sentence == word.sentence and words[w.i + 1].norm == ","]
        before = next((w for w in reversed(told) if w.dep == "conj" and words[w.i + 2].tag in ("WDT", "WP")), None)
    if (
        before is None
        or before.dep != "conj"
        or not road_user(before)
        or words[before.i - 1].norm not in ("and", "but")
    ):
        return None
    beside = words[before.head]
    own = any(words[c].dep.startswith("nsubj") for c in word.children)
    return before if word.tag in ("VBD", "VBZ") and not own and beside.noun and not road_user(beside) else None


def _after_a_comma(words: list[Word], verb: Word) -> Word | None:
    """The road user that begins what a comma joins to a sentence, where the tree leaves its verb without a subject:
    "the van stops, ego behind it does not brake"."""
    aux = [words[c] for c in verb.children if words[c].dep in ("aux", "auxpass") and c < verb.i]
    finite = verb.tag in ("VBZ", "VBD", "VBP") or any(w.tag in ("VBZ", "VBD", "VBP", "MD") for w in aux)
    if (
        not finite
        or verb.dep in ("aux", "auxpass")
        or any(words[c].dep.startswith(("nsubj", "mark", "expl")) for c in verb.children)
    ):
        return None
    start = min([verb.i, *(w.i for w in aux)])
    between = []
    for word in reversed(words[:start]):
        if word.sentence != verb.sentence or word.verb or word.norm in ("and", "but", "or", "which", "who", "that"):
            return None
        if word.norm == ",":
            break
        between.insert(0, word)
    else:
        return None
    nouns = [w for w in between if road_user(w) or names_ego(w)]
    opens = [w for w in between if w.tag not in ("DT", "JJ", "NN", "NNP", "CD") or w in nouns][:1]
    if (
        not nouns
        or opens != nouns[:1]
        or nouns[0].dep not in ("npadvmod", "appos", "dobj", "conj", "dep", "attr", "pobj")
    ):
        return None
    beside = between[between.index(nouns[0]) + 1 :]
    told = beside and beside[0].tag in ("IN", "RB") and any(w.dep == "pobj" or w.tag == "RB" for w in beside)
    return nouns[0] if told and not under(words, verb, nouns[0]) else None


def names_ego(word: Word) -> bool:
    """Whether a word is a name of ego."""
    return word.span is not None and word.span.kind == "ego"


def _subject_before(words: list[Word], word: Word) -> Word | None:
    """The road user right before a finite verb that the tree has beside the verb before."""
    finite = word.tag in ("VBZ", "VBD") and not any(words[c].dep.startswith("nsubj") for c in word.children)
    before = words[word.i - 2 if words[word.i - 1].norm.endswith("ly") else word.i - 1] if word.i > 1 else None
    if not finite or before is None or before.dep != "conj" or before.span is None or before.head != word.head:
        return None
    return before if words[word.head].verb and before.span.kind != "quantity" else None


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
    if first is not None and any(w.norm == "and" for w in words[first.i + 1 : subjects[1].i]):
        hang(words, subjects[1], first)
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
        hang(words, second, first)
        first.dep, second.dep = "nsubj", "conj" if joined else "appos"


def _behind_place(words: list[Word], verb: Word) -> None:
    """Give a verb its subject that was taken for another name of somebody in a place before: "ahead of ego, two cars
    wait"."""
    if verb.dep != "ROOT" or any(words[c].dep.startswith(("nsubj", "expl")) for c in verb.children):
        return
    apposed = [w for w in words[: verb.i] if w.sentence == verb.sentence and w.dep == "appos" and road_user(w)]
    for noun in apposed[:1]:
        opens = min(noun.i, *noun.children) if noun.children else noun.i
        last = max((w.i for w in words[noun.i : verb.i] if w.head == noun.i or w.dep == "conj"), default=noun.i)
        if words[opens - 1].norm == "," and words[noun.head].dep == "pobj" and verb.i - max(last, noun.i) <= 2:
            hang(words, noun, verb)
            noun.dep = "nsubj"

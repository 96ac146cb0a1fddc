"""Verbs that the tree hangs on the wrong verb: those on a relative clause that go on with the clause before it ("ego
follows a tractor that crawls along and overtakes it": who crawls along cannot overtake itself), and the like."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.astray import bring_home
from c2s_engine.interpret.reading.found_standing import found_standing
from c2s_engine.interpret.reading.hanging import hang, road_user
from c2s_engine.interpret.reading.joined_subjects import own_subject
from c2s_engine.interpret.reading.lost_subjects import find_subject
from c2s_engine.interpret.reading.motions import irregular, third_person

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

TOWED, SEES, WAITS = language.with_plurals("towed"), language.words("notices"), language.words("waits")


def reattach(words: list[Word]) -> None:
    """Hang each such verb where it belongs."""
    light = language.table("motions")["modality"]["light"]
    for word in words:
        if word.tag == "VBN" and word.dep == "ROOT" and _has_done(words, word):
            word.tag = "VBD"
        if word.dep == "advcl" and _first_of_several(words, word):
            _turn_round(words, word)
        if word.dep == "advcl" and _light(words, word, light):
            word.dep = "xcomp"  # "starts to slow down": no purpose
        if word.dep == "ccomp" and _joined(words, word):
            word.dep = "conj"  # "overtakes ego and 2 s later brakes"
        found_standing(words, word)
        own_subject(words, word)
        find_subject(words, word)
        bring_home(words, word)
        _by_which(words, word)
        _object_of_relative(words, word)
        _two_subjects(words, word)
        seen = _place_of_seen(words, word)
        if seen is not None:
            hang(words, word, seen)
        accompanying = _accompanying(words, word)
        if accompanying is not None:
            hang(words, word, accompanying)
        beside = _beside(words, word)
        if beside is not None:
            hang(words, word, beside)
        above = _after_waiting(words, word) or _then_did(words, word)
        if above is not None:
            hang(words, word, above)


def _first_of_several(words: list[Word], first: Word) -> bool:
    """Whether a finite verb is only the first that its subject does: "V1 swerved, crossed the line and hit"."""
    last = words[first.head]
    finite = first.tag == last.tag and first.tag in ("VBD", "VBZ") and first.i < last.i
    bare = not any(words[c].dep in ("mark", "advmod", "aux", "auxpass") and c < first.i for c in first.children)
    own = any(words[c].dep == "nsubj" for c in first.children)
    theirs = any(words[c].dep.startswith("nsubj") or words[c].dep == "expl" for c in last.children)
    return finite and bare and own and not theirs and words[last.i - 1].norm in (",", "and", "then")


def _turn_round(words: list[Word], first: Word) -> None:
    """Make the first of several verbs their head."""
    last = words[first.head]
    above, dep = last.head, last.dep
    last.children.remove(first.i)
    first.children = sorted([*first.children, last.i])
    last.head, last.dep = first.i, "conj"
    first.dep, first.head = dep, first.i if above == last.i else above
    if above != last.i:
        words[above].children = sorted([*(c for c in words[above].children if c != last.i), first.i])


def _has_done(words: list[Word], verb: Word) -> bool:
    """Whether a past form with a subject and no auxiliary is finite: "a black Altima pulled out"."""
    before = [words[c] for c in verb.children if c < verb.i]
    subject = any(w.dep == "nsubj" and road_user(w) for w in before)
    return subject and not {"aux", "auxpass", "nsubjpass"} & {w.dep for w in before}


def _by_which(words: list[Word], using: Word) -> None:
    """Hang "using" on the verb whose object the tree takes for who uses it: "overtakes ego using the other lane"."""
    if using.norm != "using" or using.dep not in ("acl", "ccomp"):
        return
    noun = words[using.head] if using.dep == "acl" else words[using.i - 1]
    verb = _clause(words, noun) if using.dep == "acl" else words[using.head]
    if verb is None or verb.lemma in SEES:
        return
    if using.dep == "acl" or noun.i in using.children and verb.verb:
        if using.dep == "ccomp":
            hang(words, noun, verb, "dobj")
        hang(words, using, verb, "advcl")


def _object_of_relative(words: list[Word], verb: Word) -> None:
    """Give the relative clause of "the van that had passed him turned left" its object."""
    subjects = [words[c] for c in verb.children if words[c].dep in ("nsubj", "nsubjpass") and c < verb.i]
    if len(subjects) != 2 or subjects[1].i - 1 in (subjects[0].i, verb.i):
        return
    first, second = subjects


def _two_subjects(words: list[Word], verb: Word) -> None:
    """Join two subjects with "and" between them: "the van in the left lane and the truck in the right lane drift"."""
    subjects = [words[c] for c in verb.children if words[c].dep == "nsubj" and c < verb.i]
    if len(subjects) != 2 or not all(road_user(w) for w in subjects):
        return
    first, second = subjects
    start = min([second.i, *(c for c in second.children if c < second.i)])
    inner = any(w.tag in ("VBZ", "VBD", "VBP", "MD") for w in words[first.i : verb.i])
    if words[start - 1].norm in ("and", "or", "nor") and words[start - 1].head in (first.i, verb.i) and not inner:
        hang(words, second, first, "conj")


def _joined(words: list[Word], word: Word) -> bool:
    """Whether a finite verb without a subject stands behind "and": it has that of the verb before."""
    above = words[word.head]
    subject = any(words[c].dep in ("nsubj", "nsubjpass", "expl") for c in word.children)
    alike = word.tag in ("VBZ", "VBD") and above.tag == word.tag and above.i < word.i
    return alike and not subject and any(w.norm in ("and", "but") for w in words[above.i + 1 : word.i])


def _place_of_seen(words: list[Word], word: Word) -> Word | None:
    """The noun right before a preposition that the tree hangs on a verb of seeing: "notices a van in the left lane"."""
    above = words[word.head]
    if word.dep != "prep" or above.lemma not in SEES or not above.verb or word.i < above.i + 2:
        return None
    at = word.i - 1
    while at > above.i and words[at].norm in (",", "also", "coming"):  # "noticed a cyclist, also from the left"
        at -= 1
    before = words[at]
    objects = [c for c in above.children if words[c].dep == "dobj" and above.i < c < word.i]
    return before if objects and before.noun and before.i != above.i else None


def _accompanying(words: list[Word], word: Word) -> Word | None:
    """Whose place it is that the tree gives to the one whom it accompanies: "a truck with Vehicle 2 behind it"."""
    if word.dep not in ("prep", "advmod") or word.norm not in ("behind", "ahead", "beside", "alongside", "next"):
        return None
    at = word.i - 2 if words[word.i - 1].norm == "," else word.i - 1
    other = words[at]
    while other.dep == "appos":  # "with Vehicle 2, a Ford, behind it"
        other = words[other.head]
    beside = words[other.head]
    below = word.head in (other.i, beside.i)
    return other if other.dep == "pobj" and beside.norm == "with" and road_user(other) and not below else None


def _beside(words: list[Word], word: Word) -> Word | None:
    """The participle beside which another stands: "sees a van stopping and then reversing"."""
    above = words[word.head]
    if word.dep != "conj" or word.tag != "VBG" or above.tag not in ("VBZ", "VBD", "VBP", "VB") or above.i > word.i:
        return None
    told = [words[c] for c in above.children if above.i < c < word.i and words[c].tag == "VBG"]
    return next((w for w in reversed(told) if w.dep in ("ccomp", "acl", "xcomp", "advcl")), None)


def _light(words: list[Word], verb: Word, light: list[str]) -> bool:
    """Whether an infinitive stands right behind a verb that only adds a shade of meaning to it."""
    before = words[verb.i - 2] if verb.i > 1 and words[verb.i - 1].norm == "to" else None
    return verb.tag == "VB" and before is not None and before.i == verb.head and _shades(before, light)


def _shades(verb: Word, light: list[str]) -> bool:
    """Whether a verb only adds a shade of meaning to another."""
    return any(form in (shade, third_person(shade)) for form in (verb.norm, verb.lemma) for shade in light)


def _after_waiting(words: list[Word], word: Word) -> Word | None:
    """Who waited goes on: "ego waits until it has gone by and overtakes the tractor"."""
    awaited = words[word.head]
    if word.dep != "conj" or word.tag not in ("VBZ", "VBD") or awaited.i > word.i:
        return None
    if any(words[c].dep.startswith("nsubj") for c in word.children):
        return None
    above = words[awaited.head]
    marks = {words[c].norm for c in awaited.children if c < awaited.i} | {above.norm}
    above = words[above.head] if above.norm == "for" else above
    waits = irregular().get(above.norm, above.lemma) in WAITS and above.tag == word.tag and above.i < awaited.i
    return above if waits and marks & {"until", "till", "for", "to"} else None


def _then_did(words: list[Word], word: Word) -> Word | None:
    """The verb of a when-clause with which another goes on: "was turning when a van pulled out and hit it"."""
    above = words[word.head]
    alone = not any(words[c].dep in ("nsubj", "nsubjpass", "aux", "auxpass") for c in word.children)
    lasts = any(words[c].dep in ("aux", "auxpass") and words[c].norm in ("was", "were") for c in above.children)
    if word.dep != "conj" or word.tag != "VBD" or not alone or not (lasts or above.norm in ("was", "were")):
        return None
    outer = words[above.head]
    if above.dep == "advcl" and outer.tag == "VBD" and outer.i < above.i and words[word.i - 1].norm in ("and", "then"):
        return outer  # "overtook me as I was turning and went into my door"
    inner = [words[c] for c in above.children if above.i < c < word.i and words[c].dep == "advcl"]
    when = (w for w in inner if w.tag == "VBD" and any(words[c].norm == "when" for c in w.children))
    return next(when, None)


def _clause(words: list[Word], noun: Word) -> Word | None:
    """The verb whose object a noun is, also behind a preposition."""
    if noun.dep not in ("dobj", "pobj"):
        return None
    above = words[noun.head]
    for _ in range(3):
        if above.verb or above.head == above.i:
            break
        above = words[above.head]
    return above if above.verb and above.i < noun.i else None

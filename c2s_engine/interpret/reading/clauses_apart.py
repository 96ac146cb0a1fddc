"""Clauses of which the tree makes one noun phrase with what stands before "and": "crossed the centre line and its front
struck V2", "was stopped at the lights and the car behind ran into it"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.spans import names_one

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

JOINS = frozenset(("and", "but"))
FINITE = frozenset(("VBD", "VBZ", "VBP"))
BETWEEN = frozenset(("advmod", "aux", "auxpass", "neg"))
SAYS = language.words("says") | language.words("notices") | frozenset(("think", "believe", "see", "mean"))
OWN = frozenset(("its", "his", "her", "their", "my", "our"))


def divide(words: list[Word]) -> None:
    """Give each such verb the subject right before it, and hang it beside the verb of the clause before."""
    for verb in words:
        first = _first_noun(words, verb)
        if first is None:
            continue
        noun, beside, join = first
        above = _above(words, beside, verb)
        if above is None:
            continue
        if beside.head == verb.i:
            _move(words, beside, above, "dobj")
        _move(words, verb, above, "conj")
        _move(words, noun, verb, _relation(words, verb))
        _move(words, join, above, "cc")
        verb.tag = "VBD" if verb.tag == "VBN" and noun.dep == "nsubj" else verb.tag


def _first_noun(words: list[Word], verb: Word) -> tuple[Word, Word, Word] | None:
    """(the noun right before a verb, the noun it hangs on, the word between them)."""
    if not (verb.tag in FINITE or verb.tag in ("VBN", "VBG") and verb.dep != "acl"):
        return None
    i = verb.i - 1
    while i > 0 and words[i].dep in BETWEEN and words[i].head == verb.i:
        i -= 1
    noun = next((w for w in _upwards(words, words[i]) if w.dep == "conj" and w.noun), None)
    if noun is None or words[i].sentence != verb.sentence or verb.i in _below(words, noun):
        return None
    first = min(_below(words, noun))
    beside, join = words[noun.head], words[first - 1] if first else noun
    if join.norm not in JOINS or not beside.noun or beside.i > join.i or not _of_road_user(words, noun):
        return None
    return noun, beside, join


def _above(words: list[Word], beside: Word, verb: Word) -> Word | None:
    """The verb of the clause before, where the verb is none of its complements."""
    subjects = [c for c in verb.children if words[c].dep in ("nsubj", "nsubjpass") and c < verb.i]
    if subjects and (subjects != [beside.i] or verb.dep != "ccomp"):
        return None
    above = words[verb.head] if subjects else _finite(words, beside)
    if above is None or above.i >= beside.i or above.i == verb.i or above.lemma in SAYS:
        return None
    finite = verb.tag in FINITE or any(words[c].dep in ("aux", "auxpass") for c in verb.children)
    return above if finite or verb.tag == "VBN" and not subjects else None


def _finite(words: list[Word], noun: Word) -> Word | None:
    """The verb above a noun, with "to turn" the one that it hangs on."""
    verbs = [w for w in _upwards(words, noun) if w.verb]
    return next((w for w in verbs if w.tag != "VB"), verbs[0] if verbs else None)


def _relation(words: list[Word], verb: Word) -> str:
    return "nsubjpass" if any(words[c].dep == "auxpass" for c in verb.children) else "nsubj"


def _of_road_user(words: list[Word], noun: Word) -> bool:
    """Whether a noun is a road user or a part of one."""
    return any(names_one(words[i].span, MOVERS) or words[i].norm in OWN for i in _below(words, noun))


def _upwards(words: list[Word], word: Word) -> list[Word]:
    """A word and what it hangs on, up to the root."""
    found = [word]
    while found[-1].head != found[-1].i and len(found) < 12:
        found.append(words[found[-1].head])
    return found


def _below(words: list[Word], word: Word) -> list[int]:
    """All words of a noun phrase."""
    return [word.i, *(i for c in word.children for i in _below(words, words[c]))]


def _move(words: list[Word], word: Word, above: Word, dep: str) -> None:
    """Hang a word on another one."""
    if word.head != word.i:
        words[word.head].children.remove(word.i)
    above.children = sorted([*above.children, word.i])
    word.head, word.dep = above.i, dep

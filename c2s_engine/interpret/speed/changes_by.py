"""Changes of speed that are told by how much: "slows by 30 percent", "drops to half its speed", "brakes by 20 km/h"."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.speed.by_limit import LIMIT
from c2s_engine.interpret.speed.ratios import SPEED
from c2s_engine.interpret.what.event import Event

CHANGES = ("brake", "accelerate")
HALVED = {"halve": 0.5, "double": 2.0, "triple": 3.0, "treble": 3.0}
ABOUT = r"(?:(?:about|around|roughly|some|only|just|approximately|nearly|almost|a|another) )*"
OWN = rf"(?:(?:its|his|her|their|the|that|my|our) (?:(?!of\b)\w+ ){{0,3}}?{SPEED}\b|{SPEED}\b)"


@dataclass(frozen=True)
class Change:
    """The speed after a change is so many times the one before, and so many m/s more."""

    times: float
    more: float
    span: tuple[int, int]


@cache
def _shares() -> tuple[re.Pattern[str], re.Pattern[str]]:
    """By which part a speed changes, and to which part of what."""
    parts = language.alternatives([f for f, v in language.table("units")["fractions"].items() if v < 1])
    share = rf"(?:(?P<percent>\d+(?:\.\d+)?) ?(?:%|per ?cent\b)|(?P<part>{parts})\b)"
    by = re.compile(rf"\bby {ABOUT}{share}(?! (?:of|more|less) (?!{OWN}))")
    ends = r"\s*(?:[.,;)]|$|(?:and|when|while|as|because|within|in|before|for|at|then|so|but|on|over)\b)"
    to = re.compile(
        rf"\bto {ABOUT}{share}(?: of)?(?: (?:(?P<limit>{LIMIT})|(?P<own>{OWN}|that|it)(?! of)|(?={ends}))|(?={ends}))"
    )
    return by, to


def changes_by(scene: Scene, quantities: list[Span]) -> list[tuple[int, int]]:
    """Give the braking and accelerating that is told by how much its change; where that stands in the text."""
    taken = []
    for event in scene.clauses.events:
        if event.act in CHANGES and event.done and (change := _change(scene, event, quantities)) is not None:
            event.quantities = [*event.quantities, _told(change)]
            taken.append(change.span)
    return taken


def _told(change: Change) -> dict[str, Any]:
    return {"dimension": "change", "times": change.times, "more": change.more, "start": change.span[0]}


def _change(scene: Scene, event: Event, quantities: list[Span]) -> Change | None:
    """How much the speed of an event changes, if its clause says so."""
    word = scene.words[event.word]
    later = (scene.words[e.word].start for e in scene.clauses.events if e.word > event.word)
    sentence = next((end for start, end in scene.sentences if start <= word.start < end), event.end)
    end = min(sentence, min(later, default=sentence))
    told = scene.plain[word.start : end]
    down = event.act == "brake"
    if (times := HALVED.get(word.lemma)) is not None and re.search(SPEED, told):
        return Change(times, 0.0, (word.start, word.end))
    by, to = _shares()
    if (match := by.search(told)) is not None:
        share = _share(match)
        return Change(1 - share if down else 1 + share, 0.0, _within(word.start, match))
    if (match := to.search(told)) is not None:
        if match["limit"]:
            limit = scene.road.speed_limit
            return None if limit is None else Change(0.0, limit * _share(match), _within(word.start, match))
        return Change(_share(match), 0.0, _within(word.start, match))
    for span in quantities:
        before = scene.plain[word.start : span.start] if span.data["dimension"] == "speed" else ""
        if word.start < span.start < end and re.search(rf"\bby {ABOUT}(?:at least |up to |more than )?$", before):
            return Change(1.0, -span.data["low"] if down else span.data["low"], (span.start, span.end))
    return None


def _share(match: re.Match[str]) -> float:
    if match["percent"]:
        return float(match["percent"]) / 100
    return float(language.table("units")["fractions"][match["part"]])


def _within(at: int, match: re.Match[str]) -> tuple[int, int]:
    return at + match.start(), at + match.end()

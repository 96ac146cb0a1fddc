"""Vehicles that a report tells apart only by what happened to them ("the striking vehicle", "the struck truck"): they
are read as vehicle 1 and vehicle 2."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement

NAMED = re.compile(
    r"\bego\b|\b(?:i|we|my|our|us|me)\b|\b(?:v|veh|vehicle|unit|car|driver|d|u|party)[ .-]{0,2}#?(?:\d|[ab])\b"
    r"|\b(?:subject|host|test|insured|claimant|automated|autonomous|equipped)\b|\b(?:av|vut|sv|sut)\b",
    re.IGNORECASE,
)
"""Where the vehicles have other names, these words only describe."""
NOUNS = r"(?P<noun>vehicle|car|truck|van|bus|suv|pickup|motorcycle|taxi|sedan|lorry|tractor[- ]trailer|driver|motorist)"
GENERIC = ("vehicle", "car", "driver", "motorist")


@cache
def _called(number: int) -> re.Pattern[str]:
    words = language.table("rephrased")["pairs"][number]
    return re.compile(rf"\b(?:the|an?) (?:{language.alternatives(words)}) {NOUNS}\b", re.IGNORECASE)


def pairs(text: str) -> list[Replacement]:
    """The number that each of the two is read by, where both are told of and neither has another name."""
    if NAMED.search(text):
        return []
    both = [list(_called(number).finditer(text)) for number in (0, 1)]
    if not all(both):
        return []
    return [
        (m.start(), m.end(), _name(m["noun"], number, first=m is found[0]))
        for number, found in enumerate(both, 1)
        for m in found
    ]


def _name(noun: str, number: int, *, first: bool) -> str:
    """The number, with what it is where that is told first."""
    kind = f" ({'an' if noun[0] in 'aeiouAEIOU' else 'a'} {noun})" if first and noun.lower() not in GENERIC else ""
    return f"vehicle {number}{kind}"

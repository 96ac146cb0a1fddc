"""Dates and times of day ("On May 14 at 2:37 PM a ..."): the parser is shown one plain word for each."""

import re

from c2s_engine.interpret.spans import Span

MONTH = (
    r"(?:jan(?:uary)?|feb(?:ruary)?|mar(?:ch)?|apr(?:il)?|may|june?|july?|aug(?:ust)?|sep(?:t(?:ember)?)?|oct(?:ober)?"
    r"|nov(?:ember)?|dec(?:ember)?)\.?"
)
DAY = r"(?:mon|tues|wednes|thurs|fri|satur|sun)day"
ORDINAL = r"\d{1,2}(?:st|nd|rd|th)?"
DATE = (
    rf"(?:(?:{DAY},? )?(?:the )?(?:{MONTH} {ORDINAL}(?!\d)|{ORDINAL} (?:of )?{MONTH}(?=[ ,.]))(?:,? (?:19|20)\d\d\b)?"
    rf"|\d{{1,2}}[/-]\d{{1,2}}[/-](?:19|20)?\d\d|{DAY}(?: (?:morning|afternoon|evening|night))?)"
)
ABOUT = (
    r"(?:(?:about|approximately|approx\.?|around|roughly|exactly|just after|just before|shortly after|shortly before) )"
)
HALF = r"[ap]\.?m\b\.?"
ZONE = (
    r"(?: (?:[pecm][sd]?t|gmt|utc|local time|(?:pacific|eastern|central|mountain)(?: (?:standard|daylight))? time)\b)"
)
CLOCK = (
    rf"(?:\d{{1,2}}[:.]\d\d(?: ?{HALF}| ?(?:hours|hrs)\b)?|\d{{1,2}} ?{HALF}|[0-2]\d[0-5]\d ?(?:hours|hrs)\b){ZONE}?"
)
AT = rf"(?:at|around|about) {ABOUT}?{CLOCK}"
WHEN = re.compile(
    r"(?:(?<=^)|(?<=[.!?:\n] )|(?<=\n))"
    rf"(?:(?:on |early |late )+{DATE},?(?:,? (?:and )?{AT})?|{AT}(?:,? on {DATE},?)?)(?![\w:/-])"
)


def besides(plain: str, spans: list[Span]) -> list[Span]:
    """The spans, with one for each sentence opening that only tells when: no subject of what follows it."""
    found = [Span("word", m.start(), m.end(), {"proxy": "yesterday"}) for m in WHEN.finditer(plain)]
    free = [f for f in found if not any(s.start < f.end and f.start < s.end for s in spans)]
    return sorted(spans + free, key=lambda s: s.start)

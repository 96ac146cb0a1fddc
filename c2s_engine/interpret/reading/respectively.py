"""Two that are told of together with "respectively", each in a sentence of its own: "the car and the van are in the
left and right lane, respectively"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import division
from c2s_engine.interpret.reading.motions import past_forms, third_person, verb_lemmas
from c2s_engine.interpret.reading.rewritten import Replacement

UNIT = r"(?:km/?h|kph|mph|m/s|metres|meters|m|ft|feet)"
VALUE = rf"\d+(?:\.\d+)? ?{UNIT}?"
WAYS = (
    r"(?:(?:north|south|east|west)(?:bound|wards?)?|[nsew]/?b|left|right|middle|first|second|third|oncoming|adjacent)"
)
WHICH = rf"(?:{VALUE}|{WAYS}|[1-6])"
WHO = r"(?:(?:an?|the|one|another) (?:[\w-]+ ){0,2}?[\w-]+|(?:vehicle|unit|car|driver|v|u)[ -]?#?[1-9a-e]|[A-E])"
PAIR = re.compile(rf"(?P<p>{VALUE}) ?and (?P<q>{VALUE})")
PLURALS = {"are": "is", "were": "was", "have": "has", "do": "does"}


@cache
def _together() -> re.Pattern[str]:
    verbs = language.alternatives([*PLURALS, *verb_lemmas(), *past_forms()])
    return re.compile(
        rf"(?P<before>[^,.;]*?, )??(?:two (?:other )?(?P<kind>\w+)s, )?(?P<a>{WHO}) and (?P<b>{WHO}),? "
        rf"(?P<verb>{verbs})"
        rf"(?P<rest>\b[^.;]*?)(?P<p>{WHICH})(?P<of> lane| side| direction)? and (?P<the>the )?(?P<q>{WHICH})"
        r"(?P<tail>[^.;]*?),? respectively\b(?P<after>[^.;]*)",
        re.IGNORECASE,
    )


def respectively(text: str) -> list[Replacement]:
    """Both sentences for each such one."""
    found: list[Replacement] = []
    for start, end in division.sentences(text):
        match = _together().match(text, start, end) if "respectively" in text[start:end] else None
        if match is not None:
            both = " ".join(_said(match, who, which) for who, which in (("a", "p"), ("b", "q")))
            found.append((match.start(), match.end(), both.removesuffix(".")))
    return found


def _said(match: re.Match[str], who: str, which: str) -> str:
    """What is told of one of the two."""
    value = _unit(match[which], match["q"])
    of = match["of"] or ""
    tail = re.sub(r"\blanes\b", "lane", match["tail"])
    tail = tail if of and tail.startswith(of) else of + tail
    after = PAIR.sub(lambda m: _unit(m["p" if which == "p" else "q"], m["q"]), match["after"])
    name = f"{match['kind']} {match[who]}" if match["kind"] and len(match[who]) == 1 else match[who]
    verb = PLURALS.get(match["verb"], match["verb"])
    verb = third_person(verb) if verb in verb_lemmas() else verb
    rest = re.sub(r"\blanes $", "lane ", match["rest"])
    return f"{match['before'] or ''}{name[:1].upper()}{name[1:]} {verb}{rest}{value}{tail}{after}."


def _unit(value: str, other: str) -> str:
    """A number with the unit of the other one, where it has none: "at 90 and 70 km/h"."""
    unit = re.search(rf"{UNIT}$", other)
    bare = re.fullmatch(r"\d+(?:\.\d+)?", value.strip()) is not None
    return f"{value.strip()} {unit[0]}" if bare and unit is not None else value.strip()

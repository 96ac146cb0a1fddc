"""Titles: a name in quotes that says nothing more, and notes that open with what happens and only then name who is
there ("cut-in from left to right at 15 m, ego 100 km/h, target 80 km/h"): the one other vehicle does it."""

import re

from c2s_engine.interpret.entities import VEHICLES
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.reading.motions import third_persons
from c2s_engine.interpret.reading.rewritten import Replacement
from c2s_engine.interpret.spans import Span

SIDE = r"(?:left|right)(?:[- ](?:hand )?(?:lane|side))?"
TITLE = re.compile(
    r"\A\s*(?:(?:sudden|late|aggressive|close|tight|sharp|highway|motorway|simple|slow|near|short|critical)[ -])*"
    r"(?P<deed>cut[- ]?(?:in|out))s?(?: (?:scenario|manoeuvre|maneuver|test|case|situation))?"
    r"(?P<rest>(?:,? (?:from (?:the )?(?P<from>" + SIDE + r")(?: to (?:the )?" + SIDE + r")?|(?:in)?to (?:the )?"
    r"(?P<to>" + SIDE + r")|(?:at|with|gap|of|an?|the|about|only|distance|in|on|motorway|highway|road)\b"
    r"|(?P<gap>\d+(?:\.\d+)?) ?(?:m|metres?|meters?)\b(?:,? gap)?))*)\s*(?P<end>[,.:;(\n]| with | - )",
    re.IGNORECASE,
)
TOLD = re.compile(r"\bcut(?:s|ting)?[- ]?(?:in|out|back)\b|\b(?:merg|chang|swerv|pull|mov)(?:e?s|ing)\b", re.IGNORECASE)
AFTERWARDS = frozenset(("brakes", "slows", "stops", "decelerates", "accelerates"))
"""What one may do that has cut in."""
SAID = {"cut in": "cuts in", "cut out": "cuts out"}


QUOTED = re.compile(
    r"\A\s*(?:[\w.#/-]+[ ,:–-]+){0,7}?[\"“](?P<title>(?:[\w'’/-]+,? ?){1,8})[\"”]\s*[:.,–-]+\s*(?=(?:\S+\s+){9})"
)


def quoted_title(text: str) -> list[Replacement]:
    """Nothing instead of a title in quotes that names nobody whom the text does not tell of."""
    match = QUOTED.match(text)
    if match is None:
        return []
    names = scan.names(scan.normalised(text))
    before = [s for s in names if s.start < match.end()]
    after = {s.data.get("type") for s in names if s.start >= match.end()}
    after |= {"vehicle"} if after & VEHICLES else set()
    told = all(s.kind == "actor" and s.data["type"] in after for s in before)
    return [(match.start(), match.end(), "")] if told else []


def titled_deeds(text: str) -> list[Replacement]:
    """The sentence that says so, instead of the title; nothing where the text tells it again, or names nobody alone."""
    match = TITLE.match(text)
    if match is None or TOLD.search(text, match.end()) is not None:
        return []
    names = [s for s in scan.names(scan.normalised(text)) if s.start >= match.end() - 1]
    others = [s for s in names if s.kind == "actor" and s.data["type"] in VEHICLES and not s.data["plural"]]
    doers = _doers(text, others)
    if len(doers) != 1 or not any(s.kind == "ego" for s in names) or _acts(text, doers[0]):
        return []
    first = next(s for s in others if _noun(text, s) == doers[0])
    deed = re.sub(r"cut[- ]?", "cut ", match["deed"].lower())
    where = match["from"] or match["to"]
    side = where.split()[0].split("-")[0].lower() if where else ""
    if bool(match["from"]) is (deed == "cut out"):
        side = {"left": "right", "right": "left"}.get(side, "")
    way = "from" if deed == "cut in" else "to"
    said = f"The {doers[0]} {SAID[deed]}{f' {way} the {side}' if side else ''}"
    said += f" at {match['gap']} m" if match["gap"] else ""
    article = re.search(r"\b(?:an?|one|another) \Z", text[: first.start], re.IGNORECASE)
    again = [(article.start(), article.end(), "the ")] if article is not None else []
    return [(match.start(), match.end(), f"{said}. "), *again]


def _acts(text: str, noun: str) -> bool:
    """Whether the text tells in a verb what it does, other than that it brakes."""
    verbs = re.finditer(rf"\b{re.escape(noun)} (?:then |now |suddenly |\w+ly )?(?P<verb>\w+)", text, re.IGNORECASE)
    return any(m["verb"].lower() in third_persons() - AFTERWARDS for m in verbs)


def _noun(text: str, span: Span) -> str:
    return text[span.start : span.end].lower()


def _doers(text: str, others: list[Span]) -> list[str]:
    """The nouns of who may do it: of several, not those that stand there."""
    nouns = list(dict.fromkeys(_noun(text, s) for s in others))
    if len(nouns) < 2:
        return nouns
    return list(
        dict.fromkeys(_noun(text, s) for s in others if not {"stationary", "parked", "slow"} & {*s.data["roles"]})
    )

"""Bare letters that name road users: "car A follows B", "M comes down the ramp", "D, a pedestrian, stands"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import third_person, third_persons
from c2s_engine.interpret.reading.people import people
from c2s_engine.interpret.reading.scan import LABEL_NUMBERS, Span

BARE = re.compile(r"(?<![\w'’/&.-])(?P<letter>[A-HJ-Z])(?![\w/&%-]|\.\w|['’](?!s\b|\s)|\d|\.\s+[A-Z][a-z]+\s[A-Z])")
STARTS = re.compile(r"(?:^|[.!?:;(\"\n])\s*$")
ARTICLE = re.compile(r"\s*,\s*(?:an?|the|our|which|who|in|on|next|behind|ahead|coming|\d)\b")
GOVERNED = re.compile(
    r"\b(?:behind|between|follow\w*|trail\w*|pass(?:es|ed|ing)?|overtak\w+|hit\w*|strik\w+|struck|rear-end\w*|past"
    r"|let|lets"
    r"|ahead of|in front of|seeing|and|reach\w*|approach\w*|alongside|beside|avoid\w*|towards?|by|of|to|from|into|with)"
    r"\s+$"
)
NO_NAME = re.compile(
    r"\b(?:class|level|scenario|case|point|lane|street|avenue|ave|road|route|exit|gate|step|phase|part|group|zone"
    r"|area|plan"
    r"|grade|type|variant|version|option|figure|fig|table|section|appendix|town|junction|position|location|site|arm|leg"
    r"|vitamin|model|series|schedule|annex|article|terminal|stop|platform|vehicle type|building)\s+$"
)
NO_FOLLOWER = re.compile(
    r"[\s-]*(?:roads?|junctions?|intersections?|pillar|turns?\b(?= (?:left|right|at))|shaped?|lanes?|streets?"
    r"|avenue|km|side"
    r"|license|licence|class|crossing|kerb|curb|hand|shoulder|degrees|ramps?|exit|band)\b"
)
PARTIES = ("driver", "motorist", "operator", "party", "participant")
SIDES = frozenset("lrnesw")
AUXILIARIES = language.words("auxiliaries")


@cache
def _verbs() -> frozenset[str]:
    """The third person singular of verbs of motion and of those that govern them, and auxiliaries."""
    shades = {v for words in language.table("motions")["modality"].values() for v in words}
    return third_persons() | {third_person(v) for v in shades} | AUXILIARIES


@cache
def _typed() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?P<noun>{language.alternatives([*language.actor_nouns(), *PARTIES])})\s$")


def _acts(after: str) -> bool:
    """Whether a letter is followed by what somebody does."""
    word = re.match(r"\s+(?:then |now |also |suddenly |\w+ly )?(?P<verb>[a-z-]+)\b", after)
    past = re.match(r"\s+\w+ed\s*(?:[.,;]|$|at\b|in\b|on\b|behind\b|for\b|by\b|to\b|into\b|out\b|hard\b)", after)
    return bool(word and word["verb"] in _verbs() or past or re.match(r"['’]s\b", after))


def cased(text: str, plain: str) -> list[Span]:
    """Letters, people and models, which only a text's own case tells."""
    return [
        *letters(text, plain),
        *people(text, plain),
    ]


def letters(text: str, plain: str) -> list[Span]:
    """The letters that stand for road users in a text (in its own case), with the noun before them if there is one."""
    sure: dict[str, Span] = {}
    loose: list[tuple[str, int]] = []
    again: set[str] = set()
    for match in BARE.finditer(text):
        letter, at = match["letter"].lower(), match.start()
        before, after = plain[max(0, at - 40) : at], plain[match.end() : match.end() + 30]
        if NO_NAME.search(before) or re.search(r"\d\s*$", before):
            continue
        opens = bool(STARTS.search(before))
        acts, apposed = _acts(after), ARTICLE.match(after) is not None
        if NO_FOLLOWER.match(after) and not acts or letter == "a" and opens and not acts:
            continue
        noun = _typed().search(before)
        if noun is not None:
            word = re.sub(r"[\s-]+", " ", noun["noun"])
            sure.setdefault(letter, _label(letter, word, match.end() - 1 - len(noun[0]), match.end()))
        elif re.match(r"\s?\d", after):
            continue
        elif (
            acts
            or apposed
            and (opens or letter != "a")
            or letter not in SIDES
            and letter != "a"
            and GOVERNED.search(before)
        ):
            again.add(letter)
            loose.append((letter, at))
            continue
        loose.append((letter, at))
    counts = {letter: sum(1 for name, _ in loose if name == letter) for letter in again}
    agents = {n for n in again if counts[n] > 1 or len(again) > 1 or n not in SIDES}
    spans = list(sure.values())
    for letter, at in loose:
        if any(s.start <= at < s.end for s in spans) or letter not in sure and letter not in agents:
            continue
        data = sure[letter].data if letter in sure else _label(letter, "", at, at + 1).data
        typed = _typed().search(plain[max(0, at - 40) : at])
        start = at - len(typed[0]) if typed else at
        spans.append(Span("label", start, at + 1, {"label": data["label"], "word": "letter"}))
    return spans


def _label(letter: str, noun: str, start: int, end: int) -> Span:
    """The label of a letter: by its number after a generic noun or alone, by its noun otherwise."""
    generic = noun in ("", "vehicle", "car", *PARTIES)
    label = (LABEL_NUMBERS.get(letter) or f"vehicle {letter}") if generic else f"{noun} {letter}"
    return Span("label", start, end, {"label": label, "word": noun or "letter"})

"""Members of a group that are only placed ("two vans, one on the left and one on the right"), each in a sentence."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import division
from c2s_engine.interpret.reading.rewritten import Replacement

SEVERAL = re.compile(r"\b(?:two|three|four|both|several|a pair|pair of|2|3|4)\b", re.IGNORECASE)
NAMES = ("One", "The second", "The third", "The fourth")
THEN = (
    r"\s?[,;]?(?: and| while| whereas)? (?:(?:the|an?|the one) )?(?:other|another|second|third|last|one|fourth)"
    r"(?: one)?(?: of them)? (?:is )?"
)
FOLLOWED = r"(?:\)|(?=\s*(?:[.,;:]|$| while\b| and\b| when\b| as\b)))"


def _words() -> dict[str, list[str]]:
    found: dict[str, list[str]] = language.table("rephrased")["each_apart"]
    return found


@cache
def _listed() -> re.Pattern[str]:
    data = _words()
    word = rf"(?:{language.alternatives(data['where'])}|\d+(?:\.\d+)?(?: ?(?:m|ft|metres|meters|feet|yards))?)"
    place = rf"(?:(?:{language.alternatives(data['doing'])}) )?{word}(?: {word}){{0,9}}"
    first = r"\s?[,;:(-]+ ?(?:with )?(?:the first|one|a first)(?: of them)? (?:is )?"
    return re.compile(rf"{first}(?P<first>{place})(?P<rest>(?:{THEN}{place})+){FOLLOWED}", re.IGNORECASE)


@cache
def _each() -> re.Pattern[str]:
    return re.compile(rf"{THEN}(?!side\b|lane\b|hand\b)", re.IGNORECASE)


def each_apart(text: str) -> list[Replacement]:
    """Where each of several is, taken out of the sentence that tells of them, as a sentence of its own."""
    found: list[Replacement] = []
    for start, end in division.sentences(text):
        match = _listed().search(text, start, end)
        if match is None or not SEVERAL.search(text[start : match.start()]):
            continue
        places = [match["first"], *(p for p in _each().split(match["rest"]) if p.strip())]
        names = ("One", "The other") if len(places) == 2 else NAMES
        said = " ".join(f"{name} {_verb(place)} {place.strip()}." for name, place in zip(names, places, strict=False))
        ends = re.search(r"[.;!]?\s*$", text[start:end])
        stop = start + ends.start() if ends else end
        found += [(match.start(), match.end(), ""), (stop, end, f". {said} ")]
    return found


def _verb(place: str) -> str:
    return "comes" if re.match(r"from\b", place.strip(), re.IGNORECASE) else "is"

"""Ego's way through an intersection where only the way is told: "straight instead of left", "make it a right turn"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import PlaceSpec

DEMANDS = {
    "left": "ego should turn left",
    "right": "ego should turn right",
    "straight": "ego should go straight on",
    "u_turn": "ego should make a u-turn",
}


@cache
def _forms() -> list[re.Pattern[str]]:
    table = language.table("wordings")["ways"]
    return [re.compile(language.filled(form, table["words"])) for form in table["says"]]


def own_way(sentence: str, structure: Structure) -> str:
    """A sentence that tells but a way as a demand of ego, where the way given up is ego's; else the sentence."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    match = next((m for form in _forms() if (m := form.fullmatch(sentence.strip()))), None)
    if match is None or place.kind != "intersection":
        return sentence
    match.groupdict().get("old")
    return DEMANDS[_way(match["way"]) or "straight"]


def _way(words: str) -> str | None:
    """The way that words name; None for any turn."""
    return next((way for way in ("left", "right", "straight") if way in words), None)

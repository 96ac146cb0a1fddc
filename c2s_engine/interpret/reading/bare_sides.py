"""Lanes told by nothing but a side: "three lanes, ego right, truck left": in the right and in the left lane."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR
from c2s_engine.interpret.reading.rewritten import Replacement

LANES = re.compile(r"\blanes?\b|\bmotorway\b|\bhighway\b|\bfreeway\b|\bautobahn\b", re.IGNORECASE)
CROSSES = re.compile(
    r"\b(?:junctions?|intersections?|cross\w*|turn\w*|roundabout|t-bone|zebra|signals?|traffic lights?|stop sign)\b",
    re.IGNORECASE,
)
"""Where a side alone may tell from where one comes, or where to."""


@cache
def _noted() -> re.Pattern[str]:
    nouns = [n for n, (kind, several, rider) in language.actor_nouns().items() if kind in MOTOR and not several]
    names = language.alternatives([*nouns, "ego", "vut", "sv", "av"])
    return re.compile(
        rf"(?:(?<=\A)|(?<=[,;:.+&] )|(?<=[,;:.(\n\"])"
        rf"|(?<=\band )|(?<=\bwith )|(?<=\bspawn )|(?<=\bplace )|(?<=\badd ))(?:an? |the |one )?(?:{names}) "
        r"(?P<side>left|right)(?=\s*(?:[,;.)+&]|$|\band\b|\d))",
        re.IGNORECASE,
    )


def bare_sides(text: str) -> list[Replacement]:
    """The word that is left out; nothing where such a side may be another than that of a lane."""
    found = list(_noted().finditer(text))
    both = {m["side"].lower() for m in found} == {"left", "right"}
    if CROSSES.search(text) or not (LANES.search(text) or both):
        return []
    return [(m.start("side"), m.end("side"), f"in the {m['side'].lower()} lane") for m in found]

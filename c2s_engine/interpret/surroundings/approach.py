"""How far ego is from the junction, crosswalk or ramp at the start: "starts 50 m from the intersection"."""

import re

from c2s_engine.interpret.spans import Span

PLACE = (
    r"(?:\w+[- ]){0,2}?(?:intersection|junction|crossroads?|crossing|crosswalk|zebra|stop line|traffic lights?|lights"
    r"|signal|roundabout|on-?ramp|off-?ramp|ramp|exit|merge(?: point)?)\b"
)
TO = re.compile(
    r"^\s*(?:\w+ )?(?:away )?(?:before|from|short of|in front of|ahead of|upstream of|to|out from|off) "
    rf"(?:the |an? |its )?{PLACE}"
)
STARTS = re.compile(
    r"\b(?:start|begin|spawn|place[sd]?|position|initial|locat|set off|(?:is|are|be|stands?|drives?|travels?"
    r"|approach\w*|heads?|nears?)\b)"
)
LATER = re.compile(
    r"\b(?:stop|halt|brak|slow|decelerat|turn|until|when|once|as soon|within|after|yield|wait|whenever|if)\w*\b"
)


def start_distance(
    plain: str, sentences: list[tuple[int, int]], quantities: list[Span], ego: list[int]
) -> float | None:
    """The distance (m) that is told from ego's start to the place; `ego`: where ego is mentioned."""
    for span in quantities:
        if span.data["dimension"] != "distance" or not 5 <= span.data["low"] <= 400:
            continue
        start, end = next(((s, e) for s, e in sentences if s <= span.start < e), (0, 0))
        before, after = plain[start : span.start], plain[span.end : end]
        clause = re.split(r"[;,]| and (?!drives|travels)", before)[-1]
        if LATER.search(clause):
            continue
        mine = any(start <= at < span.start for at in ego)
        if TO.match(after) and (mine and STARTS.search(clause)):
            return float(span.data["low"])
    return None

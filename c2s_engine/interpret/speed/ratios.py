"""Speeds told as a part or multiple of another: "80 % of the limit", "half as fast as ego", "20 % faster than V2"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading import amounts
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.speed.by_limit import LIMIT
from c2s_engine.interpret.speed.comparisons import owner_of

SPEED = r"(?:speed|velocity|pace)"
ENDS = r"(?=\s*(?:[.,;)]|$|of\b|while\b|when\b|and\b))"
BASE = (
    rf"{LIMIT}|#?\d+(?:\.\d+)? ?(?:km/h|kph|mph|m/s)|(?:that|this|its|their|his|the|our|my) (?:\S+ ){{0,4}}?{SPEED}\b"
    rf"|(?:that|it){ENDS}|{SPEED}\b|\S+(?: \S+)? ?'s (?:\w+ )?{SPEED}\b|(?:ego|host|sv|vut) {SPEED}\b"
)
MORE = r"(?P<more>faster|quicker|higher|greater|more|above|over|in excess of)"


@cache
def _ratio() -> re.Pattern[str]:
    fractions = language.alternatives(list(language.table("units")["fractions"]))
    words = language.alternatives([w for w, v in language.table("units")["numbers"].items() if 1 < float(v) <= 10])
    number = r"\d+(?:\.\d+)?"
    return re.compile(
        rf"(?:(?P<percent>{number}) ?(?:%|per ?cent\b)|(?<![\w.])(?P<times>{number}|{words}) ?(?:times|x|×)(?!\w)"
        rf"|\b(?P<part>{fractions})\b)"
        rf"(?P<by> (?:{MORE}|slower|lower|less|below|under)(?: than)?(?P<than> [^.;]{{0,60}})?"
        rf"| as (?:fast|quick(?:ly)?)(?: as(?P<like> [^.;]{{0,60}}))?|(?: of)? (?P<base>(?:{BASE})[^.;]{{0,60}}))"
    )


def speeds_by_ratio(scene: Scene) -> None:
    """The speeds that are told as a part, a multiple or a percentage of another speed or of the limit."""
    for match in _ratio().finditer(scene.plain):
        owner = owner_of(scene, match.start())
        told = match["than"] or match["like"] or match["base"] or ""
        if owner is None or match["by"].strip() in ("over", "under", "more", "less", "above", "below") and not told:
            continue
        factor = _factor(match)
        base = None
        if base is None:
            continue
        low, high, start, end = base
        scene.speeds[owner] = (low * factor, high * factor, min(match.start(), start), max(match.end("by"), end))


def _factor(match: re.Match[str]) -> float:
    compared = match["base"] is None and match["like"] is None and " as " not in match["by"]
    part = amounts.value_of(match["times"]) if match["times"] else language.table("units")["fractions"][match["part"]]
    return 1 / part if compared and not match["more"] else part

"""Speeds told by the posted limit: "10 over the limit", "5 mph below it", "at the limit", "exceeds it by 15 km/h"."""

import re

from c2s_engine.interpret.reading import amounts
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.speed.comparisons import owner_of

NUMBER = r"\d+(?:\.\d+)? ?(?:km/h|kph|kmh|mph|m/s)?"
LIMIT = (
    r"(?:the |its |their |this |that |his |her |my |our )?"
    rf"(?:local |current |posted |legal |permitted |allowed |maximum |speed |signed |{NUMBER} )*limit\b"
)
OVER = r"(?P<more>over|above|faster than|higher than|more than|in excess of|beyond)"
UNDER = r"(?:under|below|slower than|less than|short of|beneath)"
ENDS = r"(?=\s*(?:[.,;)]|$|(?:and|when|while|as|but|because|in|on|at|with|behind|until)\b))"
BY_LIMIT = re.compile(rf"\s*(?:{OVER}|{UNDER})(?: (?:{LIMIT}|(?P<it>(?:it|that|this)\b(?! of)))|(?P<bare>{ENDS}))")
BARE = re.compile(
    r"\b(?:doing|do|does|did|going|goes|go|went|drives?|driving|drove|travell?(?:s|ing|ed)|at|by|was|is|were|about|around"
    r"|maybe|some|roughly|runs|running) (?P<n>\d{1,2}) "
    rf"(?:{OVER}|{UNDER})(?: {LIMIT}|{ENDS})"
)
EXCEEDS = re.compile(
    rf"\b(?:exceed\w*|(?:is|was|drives?|driving|drove|goes|going) {OVER}"
    rf"|(?:stay|keep|drive|drove|go|goes|is|was)\w* {UNDER})"
    rf" (?:{LIMIT}|it|this|that) by (?:about |around |roughly |some |at least |no more than |more than |up to )*$"
)
VAGUE = re.compile(
    r"\b(?P<lot>well|far|way|much|considerably|significantly)?"
    r"(?:(?:just|slightly|marginally|a (?:little|bit|touch|shade|tad))(?: bit)?)?"
    rf" ?\b(?:{OVER}|{UNDER}) {LIMIT}"
)
LITTLE, LOT = 0.06, 0.25
"""By which part of it one is just, or well, over or under the limit."""
AT_LIMIT = re.compile(
    r"\b(?:at|doing|does|do|drives?|driving|drove|keeps? to|keeping to|kept to|sticks? to|exactly|just|observes"
    rf"|respects) {LIMIT}(?! of| is| was|,? \d)"
)


def by_limit(scene: Scene, quantities: list[Span]) -> None:
    """The speeds that are told by the posted limit: so much over or under it, or the limit itself."""
    limit = scene.road.speed_limit
    if limit is None:
        return
    for span in quantities:
        sign = told_by_limit(scene, span)
        if sign:
            _give(scene, limit + sign * span.data["low"], span.start, span.end)
    for match in BARE.finditer(scene.plain):
        if not any(q.start <= match.start("n") < q.end for q in quantities):
            change = float(match["n"]) * _factor(scene) * (1 if match["more"] else -1)
            _give(scene, limit + change, match.start("n"), match.end())
    for match in VAGUE.finditer(scene.plain):
        before = scene.plain[: match.start()].rstrip()
        if (
            match[0].strip()
            and not before[-1:].isdigit()
            and not re.search(r"(?:\d ?\S{1,4}|%|percent|times)$", before[-12:])
        ):
            share = (LOT if match["lot"] else LITTLE) * (1 if match["more"] else -1)
            _give(scene, limit * (1 + share), match.start(), match.end())
    for match in AT_LIMIT.finditer(scene.plain):
        _give(scene, limit, match.start(), match.end())


def told_by_limit(scene: Scene, span: Span) -> int:
    """1 where a speed is only by how much one drives over the limit, -1 where under it, else 0."""
    if span.data["dimension"] != "speed":
        return 0
    before = scene.plain[max(0, span.start - 70) : span.start]
    match = BY_LIMIT.match(scene.plain[span.end : span.end + 60]) or EXCEEDS.search(before)
    if match is None or match.re is BY_LIMIT and match["it"] and not limit_before(scene, span.start, " it"):
        return 0
    if match.re is BY_LIMIT and match["bare"] is not None and scene.road.speed_limit is None:
        return 0
    return 1 if match["more"] or match[0].startswith("exceed") else -1


def limit_before(scene: Scene, at: int, told: str) -> bool:
    """Whether "15 % above it" means the limit that the sentence or the one before spoke of."""
    if not re.match(r" ?(?:it|this|that)\b(?! (?:of|\w*speed))", told):
        return False
    start = max((s for s, _ in scene.sentences if s <= at), default=0)
    return re.search(r"\blimit\b", scene.plain[max(0, start - 60) : at]) is not None


def _give(scene: Scene, speed: float, start: int, end: int) -> None:
    owner = owner_of(scene, start)
    if owner is not None and owner not in scene.speeds:
        scene.speeds[owner] = (max(0.5, speed), max(0.5, speed), start, end)


def _factor(scene: Scene) -> float:
    """The unit of a bare number: that of the limit."""
    start, end = scene.road.spans.get("speed_limit", (0, 0))
    said = re.search(r"mph|miles|km|kph|m/s", scene.plain[start:end])
    if said is not None and said[0] == "m/s":
        return 1.0
    miles = said[0] in ("mph", "miles") if said is not None else amounts.in_miles(scene.plain)
    return 0.44704 if miles else 1 / 3.6

"""The road that a text describes: kind, junction, control, lanes, oncoming traffic, limits."""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.surroundings.lanes import lanes_of


@dataclass
class Road:
    """What is said of the road, with the words that say it."""

    kind: str | None = None
    arms: int | None = None
    control: str | None = None
    lanes: int | None = None
    ego_lane: str | None = None
    oncoming: bool | None = None
    curve: str | None = None
    straight: bool = False
    bend: bool = False
    no_intersection: bool = False
    ramp: bool = False
    crosswalk: bool = False
    driveway: bool = False
    sidewalk: bool = False
    shoulder: bool = False
    setting: str | None = None  # rural, urban, highway
    speed_limit: float | None = None
    stop_sign: bool = False
    yield_sign: bool = False
    signal: bool = False
    spans: dict[str, tuple[int, int]] = field(default_factory=dict)


@cache
def _re(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)


def read(plain: str, sentences: list[tuple[int, int]], quantities: list[Span]) -> Road:
    """The road of a text."""
    data = language.table("places")
    road = Road()
    negation = _re(data["negation"])
    kinds: list[tuple[str, dict[str, Any]]] = []
    for entry in data["patterns"]:
        for start, end in sentences:
            sentence = plain[start:end]
            if "not" in entry and _re(entry["not"]).search(sentence):
                continue
            for match in _re(entry["find"]).finditer(sentence):
                before = sentence[max(0, match.start() - 45) : match.start()]
                span = (start + match.start(), start + match.end())
                if entry.get("no_intersection"):
                    road.no_intersection = True
                    road.spans.setdefault("no_intersection", span)
                    continue
                if negation.search(before):
                    if entry.get("kind") == "intersection" and not _re(r"signal|light|sign").search(match[0]):
                        road.no_intersection = True
                        road.spans.setdefault("no_intersection", span)
                    continue
                kinds.append((entry["kind"], entry))
                road.spans.setdefault(entry["kind"], span)
                if entry.get("arms") and road.arms is None:
                    road.arms = entry["arms"]
                if entry.get("ramp"):
                    road.ramp = True
                if entry["kind"] == "curve":
                    side = re.search(r"\b(left|right)", match[0])
                    if side and road.curve is None:
                        road.curve = side[1]
    _control(plain, sentences, road, data)
    names = [k for k, _ in kinds]
    road.bend, road.straight = "curve" in names, "straight" in names
    road.kind = _kind(names, road)
    road.lanes, lanes_told, beside = lanes_of(plain)
    road.oncoming = True if beside else None
    if lanes_told:
        road.spans["lanes"] = lanes_told
    for entry in data["ego_lane"]:
        if hit := _re(entry["find"]).search(plain):
            road.spans.setdefault("ego_lane", hit.span())
    for entry in data["oncoming"]:
        hit = _re(entry["find"]).search(plain)
        if hit and road.oncoming is None:
            road.oncoming = entry["there"]
            road.spans.setdefault("oncoming", hit.span())
    other = data["other"]
    for name in ("crosswalk", "driveway", "sidewalk", "shoulder"):
        for hit in _re(other[name]).finditer(plain):
            if not negation.search(plain[max(0, hit.start() - 45) : hit.start()]):
                setattr(road, name, True)
                road.spans.setdefault(name, hit.span())
                break
    for name in ("highway", "rural", "urban"):
        hit = _re(rf"\b(?:{other[name]})").search(plain)
        if hit and (road.setting is None or name != "highway"):
            road.setting = name if not (name == "urban" and road.setting == "rural") else road.setting
            if road.setting == name:
                road.spans["setting"] = hit.span()
    _limit(plain, road, data, quantities)
    return road


def _kind(names: list[str], road: Road) -> str | None:
    if "roundabout" in names:
        return "roundabout"
    if "off_ramp" in names:
        return "off_ramp"
    if "intersection" in names and not ("motorway" in names and road.no_intersection):
        return "intersection"
    if "motorway" in names:
        return "motorway"
    if "curve" in names:
        return "curve"
    if "straight" in names:
        return "straight"
    return None


def _control(plain: str, sentences: list[tuple[int, int]], road: Road, data: dict[str, Any]) -> None:
    absent = False
    for entry in data["control"]:
        hits = list(_re(entry["find"]).finditer(plain))
        if entry["is"] == "signal":
            unless = _re(entry["unless"])
            absent = bool(unless.search(plain))
            if hits and not absent:
                road.signal = True
                road.control = road.control or "signal"
                road.spans.setdefault("control", hits[0].span())
        elif entry["is"] == "none":
            if hits and not road.signal:
                road.control = "none"
                road.spans.setdefault("control", hits[0].span())
        elif hits:
            name = "stop_sign" if entry["is"] == "stop" else "yield_sign"
            setattr(road, name, True)
            if road.control in (None, "none"):
                road.control = entry["is"]
            road.spans.setdefault("control", hits[0].span())


def _limit(plain: str, road: Road, data: dict[str, Any], quantities: list[Span]) -> None:
    for span in quantities:
        if span.data["dimension"] != "speed":
            continue
        before, after = plain[max(0, span.start - 40) : span.start], plain[span.end : span.end + 45]
        before = re.split(r"[.;]\s", before)[-1]
        after = re.split(r"[.;,]\s", after)[0]
        if is_limit(before, after):
            road.speed_limit = span.data["low"]
            road.spans["speed_limit"] = (span.start, span.end)
            span.data["role"] = "limit"
        elif re.search(r"(city|urban|town|country|rural|residential)\s(street|road)", after[:25]) and re.search(
            r"(on|a|an)\s(a |an )?$", before
        ):
            road.speed_limit = span.data["low"]
            span.data["role"] = "limit"


def is_limit(before: str, after: str) -> bool:
    """Whether a speed between those words is a bound of the road, not a speed that is driven."""
    pattern = _re(language.table("places")["speed_limit"])
    near = re.search(pattern.pattern + r"(,? which)?(\s+(?!and\b|but\b)[\w-]+){0,4}[:(\s]*$", before)
    follows = re.match(
        (
            r"[\s-]*(or (more|above|higher|less|over|faster) (is |are |was )?(allowed|permitted|may)|(is"
            r"|was|being) (the )?(posted |speed )*(limit|allowed|permitted)|(speed )?(limit|zone)"
            r"|(speed )?signs?\b(?! off)|or (more|higher|above) may|(are|is) (allowed|permitted)|(city|urban"
            r"|residential) (street|road)?\s?(limit)|(is|was) posted|may be (driven|done)|posted|max\b"
            r"|tops?\b)"
        ),
        after,
    )
    if re.search(r"\d( ?(km/?h|kph|mph|k))? in an? $|, posted( at)? $", before):  # "50 in a 30", "50 mph, posted 30"
        return True
    return bool(near or follows) and not re.search(
        r"travel|\bdriv(es?|ing)\b|drove|going at|cruis|set speed", before[-25:]
    )

"""Lanes that follow from lane changes, sideswipes and hits: who was beside ego, and ego's own lane by whom it meets."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast

UNSEEN = re.compile(
    r"(?:without (?:see|notic|spott|detect)\w*"
    r"|(?:not|n't|never|fail\w* to|neglect\w* to) (?:see|notice|spot|detect|observe)"
    r"|overlook\w*|unaware of|missed?|did not realise|did not check for)[^.;,]*?@(?P<who>a\d+)\b(?! 's)"
)
FROM_BEHIND = re.compile(r"\bfrom (?:behind|the rear)|\brear-?end")
NEAR_JUNCTION = re.compile(
    r"\b(?:intersections?|junctions?|crossroads|roundabout|side (?:road|street)|driveway|t-junction|traffic lights?)\b"
)
INTO_EGO_LANE = re.compile(r"^\w+ (?:\w+ )?(?:in|on)?to (?:the )?@ego 's (?:\w+ )?(?:lane|path)\b")
IN_MIDDLE = re.compile(r"\bin the (?:middle|cent(?:er|re)) lane\b")
IN_NAMED = re.compile(r"\bin the (?:left|right|middle|cent(?:er|re))(?:-?hand|-?most)? lane\b")
LEAVES = frozenset(("cut_in", "lane_change", "cut_out", "swerve", "drift", "turn", "enter_road", "cross_path"))
HALTS = ("stationary", "stop", "brake_stop")
BEHIND = re.compile(r"(?:(?!lane|left|right|,|;)\S+ ){1,6}behind (?:the |an? )?(?:[\w-]+ )?@(?P<who>a\d+)\b(?! 's)")
STANDING_OR_LED = frozenset(("stationary", "parked", "lead", "oncoming", "crossing"))


def hit_beside(event: Event, clauses: Clauses, where: Where) -> None:
    """Whom ego hits while it changes lanes is in the lane beside; into whose path it runs a sign crosses."""
    who = event.patient
    assert who is not None
    if not who.mover or who.person or not where.open or where.lane is not None or who.roles & STANDING_OR_LED:
        return
    before = [e for e in clauses.events if e.agent.ego and e.done and e.order <= event.order]
    over = [e for e in before if e.act in ("lane_change", "drift")]
    slows = any(
        e.agent is who and e.done and e.act in ("brake", "stop", "brake_stop", "stationary") for e in clauses.events
    )
    if event.act in ("collide", "drift") and over and "rear" not in event.whole:
        towards = next((s for e in reversed(over) if (s := side(e))), None)
        where.lane, where.side, where.rel = towards or "adjacent", towards, "ahead" if slows else "beside"


def sideswipes(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Who sideswipes ego, or hits it while it changes lanes, was beside it."""
    where = of[event.agent]
    if event.patient is None or not event.patient.ego or not where.open:
        return
    over = [e for e in clauses.events if e.agent is event.agent and e.done and e.act in ("lane_change", "cut_out")]
    if over and where.rel is None:
        where.lane, where.rel = "adjacent", "beside"
        for change in over:
            change.act = "cut_in"


def in_from(event: Event, of: dict[Entity, Where]) -> bool:
    """Whether one comes in "from the right" or "from the left"."""
    return event.agent in of and bool(event.act == "cut_in")


def in_from_aside(clauses: Clauses, where: Where) -> None:
    """Who cuts in "from the right", no junction being near, comes out of the lane on that side."""
    words = " ".join(w.norm for w in clauses.words)
    if where.lane == "crossing" and where.side in ("left", "right") and not NEAR_JUNCTION.search(words):
        where.lane, where.rel = where.side, where.rel or "beside"


def unseen(event: Event, cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Whom ego did not see when it changed lanes is beside it on that side."""
    towards = side(event)
    sentence = cast.words[event.word].sentence
    text = clauses.render([w.i for w in cast.words if w.sentence in (sentence, sentence + 1)])
    match = UNSEEN.search(text)
    other = next((e for e in cast.entities if match and e.key == match["who"]), None)
    if other is None or towards is None or not other.mover or other.person or other not in of or not of[other].open:
        return
    of[other].lane, of[other].side, of[other].rel = towards, towards, "beside"


def into_ego_lane(event: Event, of: dict[Entity, Where]) -> None:
    """One who comes into the lane "where ego is travelling" was in the lane beside and cuts in."""
    if INTO_EGO_LANE.search(event.text) and event.act in ("lane_change", "drift"):
        _comes_in(event, of[event.agent])


def _comes_in(event: Event, where: Where) -> None:
    """One who drifts into ego's lane from a place that is not told, or from beside it, cuts in."""
    beside = where.rel == "beside" and event.act == "lane_change"
    if beside:
        event.act = "cut_in"


def followed_lane(clauses: Clauses, of: dict[Entity, Where]) -> str | None:
    """Ego's lane where it follows one "in the right lane", or waits behind it: it is the same."""
    for event in clauses.events:
        other = _stood_behind(event, of) or event.patient
        where = of.get(other) if other is not None else None
        behind = event.act in ("follow", *HALTS) or event.act == "collide" and _runs_up_to(event, clauses)
        told = " ; ".join([event.whole, *(text for _, text in where.phrases)]) if where is not None else ""
        behind = behind or event.act == "approach" and _only_lane(event, told, clauses)
        if not behind or not event.done or not event.agent.ego or where is None or where.of is not None:
            continue
        if where.lane in (None, "same") and where.rel in (None, "ahead") and IN_MIDDLE.search(told):
            return "middle"
        if where.lane in ("left", "right") and where.rel in (None, "ahead"):
            lane, where.lane, where.side, where.rel = where.lane, "same", None, "ahead"
            return f"{lane}most"
    return None


def _only_lane(event: Event, told: str, clauses: Clauses) -> bool:
    """Whether ego comes up to one whose lane is the only one that is named, and who stays in it."""
    lanes = [w for w in clauses.words if w.norm == "lane"]
    moves = any(e.agent is event.patient and e.done and e.act in LEAVES for e in clauses.events)
    named = len(lanes) == 1 and IN_NAMED.search(told) is not None
    return named and not moves and "stationary" not in {e.act for e in clauses.events if e.agent.ego}


def _stood_behind(event: Event, of: dict[Entity, Where]) -> Entity | None:
    """Behind whom ego stands or stops, where no lane of its own is told before."""
    match = BEHIND.match(event.text) if event.act in HALTS else None
    return next((e for e in of if match and e.key == match["who"]), None)


def _runs_up_to(hit: Event, clauses: Clauses) -> bool:
    """Whether ego runs into another from behind, or into one that stands, in its own lane."""
    own = [e.act for e in clauses.events if e.agent.ego and e.done and e.order < hit.order]
    stood = any(e.agent is hit.patient and e.act in ("stationary", "stop") and e.done for e in clauses.events)
    aside = {"lane_change", "swerve", "drift", "overtake", "cut_out", "leave_road", "evade"} & set(own)
    return FROM_BEHIND.search(hit.whole) is not None or stood and not aside

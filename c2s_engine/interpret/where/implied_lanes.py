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
NEAR_JUNCTION = re.compile(
    r"\b(?:intersections?|junctions?|crossroads|roundabout|side (?:road|street)|driveway|t-junction|traffic lights?)\b"
)
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


def in_from_aside(event: Event, clauses: Clauses, where: Where) -> None:
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

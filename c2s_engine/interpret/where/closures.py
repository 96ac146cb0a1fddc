"""Lanes that works, cones or barriers close: whoever closes one stands in it."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import ZONES, Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import OPPOSITE, side
from c2s_engine.interpret.who.mentions import Cast

CLOSERS = ZONES | {"cone", "barrier", "warning_sign"}
_LANE = r"(?P<{0}>left|right)(?:-hand|most)? (?:lane|one\b|of (?:the )?(?:two|three|four) lanes|most lane)"
_SHUT = r"(?:clos|block|shut|occup|obstruct|cordon|fenc|cone|taken|take (?:out|up|away)|narrow)"
CLOSED = re.compile(
    rf"\b{_LANE.format('a')}\b[^.;]{{0,25}}?\b{_SHUT}"
    rf"|\b{_SHUT}\w* (?:off |up |out |away )?(?:\w+ )?(?:the |all of the )?{_LANE.format('b')}"
)


def closed_lanes(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> str | None:
    """Place what closes a lane that its sentence names in that lane; ego's own lane, where ego has to leave it."""
    own = None
    for entity in cast.entities:
        where = of[entity]
        if entity.type not in CLOSERS or not entity.mentions or where.lane not in (None, "roadside", "left", "right"):
            continue
        number = cast.words[entity.mentions[0].word].sentence
        match = CLOSED.search(clauses.render([w.i for w in cast.words if w.sentence == number]))
        closed = (match["a"] or match["b"]) if match else where.lane if entity.type in ZONES else None
        if closed not in ("left", "right"):
            continue
        if _leaves(closed, clauses):
            own = f"{closed}most"
        if match is not None:
            where.lane = where.side = closed
            where.phrases.append(("noun", f"in the {closed} lane"))
    return own


def _leaves(closed: str, clauses: Clauses) -> bool:
    """Whether ego changes away from that side, and is not said to be in another lane than the closed one."""
    away = OPPOSITE[closed]
    events = [e for e in clauses.events if e.agent.ego and e.done]
    lanes = re.compile(rf"\b(?:in|on|along) (?:the |its )?(?:{away}|middle|cent(?:er|re))(?:-hand|most)? lane")
    told = any(lanes.search(e.whole) for e in events if e.act not in ("lane_change", "cut_in"))
    return not told and any(e.act == "lane_change" and side(e) == away for e in events)


def in_closed_lanes(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Who stands "in the closed lane" is in the lane that is told to be shut, else in that of ego which hits it."""
    shut = [where.lane for e, where in of.items() if e.type in CLOSERS and where.lane in ("left", "right")]
    for event in clauses.events:
        match = IN_SHUT.search(event.whole) if event.act == "stationary" and event.agent in of else None
        zone = next((e for e in cast.entities if match and e.key == match["zone"]), None)
        if match is None or match["zone"] and (zone is None or zone.type != "lane_closure"):
            continue
        where, lane = of[event.agent], match["side"] or (shut[0] if shut else None)
        hit = any(e.act == "collide" and e.agent.ego and e.patient is event.agent for e in clauses.events)
        if where.lane not in (None, "parked", "same") or event.agent.person or not (lane or hit):
            continue
        where.lane, where.side, where.rel = lane or "same", lane, None if lane else "ahead"
        for other in (where, of[zone]) if zone is not None and lane else (where,):
            other.lane, other.side, other.rel = where.lane, where.side, where.rel
            other.phrases.append(("noun", f"in the {lane} lane"))


IN_SHUT = re.compile(
    r"\b(?:in|within|on|inside) the (?:(?:closed|blocked|shut|coned)(?:-? ?off)? "
    r"(?:(?P<side>left|right)(?:-hand)? |\w+ )?lane\b|@(?P<zone>a\d+)\b)"
)

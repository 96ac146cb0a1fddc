"""Lanes that works, cones or barriers close: whoever closes one stands in it."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import ZONES, Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

CLOSERS = ZONES | {"cone", "barrier", "warning_sign"}
_LANE = r"(?P<{0}>left|right)(?:-hand|most)? (?:lane|one\b|of (?:the )?(?:two|three|four) lanes|most lane)"


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

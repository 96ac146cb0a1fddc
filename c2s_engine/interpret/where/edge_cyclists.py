"""Cyclists who come towards ego along the edge of ego's own side of the road."""

import re

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Entity

EDGE = re.compile(
    r"\b(?:on|along|at|by|near|down|up|in|hug\w*|close to) (?:the |its |his |@ego 's )?(?:very )?"
    r"(?P<side>right|near|left)(?:[- ]?(?:hand|side))* "
    r"(?:edge|side|kerb|curb|verge|shoulder|gutter|(?:bike|cycle|bicycle) lane)\b"
)
UNSIDED = re.compile(
    r"\b(?:on|along|at|by|near|down|up|in|hug\w*|close to) (?:the |its |his )?"
    r"(?:\w+ )?(?:edge|kerb|curb|verge|shoulder|gutter|(?:bike|cycle|bicycle) lane)\b"
)
ACROSS = frozenset(("cross_road", "enter_road", "cross_path", "turn", "cut_in", "lane_change"))


def place_edge_cyclists(clauses: Clauses, of: dict[Entity, Where], road: Road) -> None:
    """Put cyclists there who come along the right edge (on a one-way street: either), or along an edge against the
    traffic; what they do is ride."""
    for entity, where in of.items():
        own = [e for e in clauses.events if e.agent is entity and e.done]
        if entity.type != "bicycle" or any(e.act in ACROSS for e in own):
            continue
        told = " ; ".join([*(t for _, t in where.phrases), *(e.whole for e in own)])
        if not (where.lane == "oncoming" or where.facing == "against"):
            continue
        edge = EDGE.search(told)
        if edge is None and not (UNSIDED.search(told) and where.side != "left"):
            continue
        side = "left" if edge is not None and edge["side"] == "left" else "right"
        if side == "left" and road.oncoming is not False:
            continue  # on the side of the other direction
        where.lane, where.side, where.facing, where.rel = "partly", side, "against", None
        for event in own:
            event.act = "move_along" if event.act in ("oncoming", "approach", "travel") else event.act

"""Cyclists who come towards ego along the edge of ego's own side of the road."""

import re

from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Entity

EDGE = re.compile(
    r"\b(?:on|along|at|by|near|down|up|in|hug\w*|close to) (?:the |its |his |@ego 's )?(?:very )?"
    r"(?P<side>right|near)(?:[- ]?(?:hand|side))* (?:edge|side|kerb|curb|verge|shoulder|gutter|(?:bike|cycle|bicycle) lane)\b"
)
UNSIDED = re.compile(
    r"\b(?:on|along|at|by|near|down|up|in|hug\w*|close to) (?:the |its |his )?"
    r"(?:\w+ )?(?:edge|kerb|curb|verge|shoulder|gutter|(?:bike|cycle|bicycle) lane)\b"
)
AGAINST = re.compile(
    r"\bwrong(?:[- ](?:way|direction))|(?:against|contrary to) (?:the )?(?:\w+ )?(?:traffic|direction|flow|stream)|facing traffic"
)
ACROSS = frozenset(("cross_road", "enter_road", "cross_path", "turn", "cut_in", "lane_change"))


def on_own_edge(clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Put cyclists there who come along the right edge, or along an edge against the traffic; what they do is ride."""
    for entity, where in of.items():
        own = [e for e in clauses.events if e.agent is entity and e.done]
        if entity.type != "bicycle" or any(e.act in ACROSS for e in own):
            continue
        told = " ; ".join([*(t for _, t in where.phrases), *(e.whole for e in own)])
        towards = where.lane == "oncoming" or where.facing == "against" or AGAINST.search(told)
        if towards and (EDGE.search(told) or UNSIDED.search(told) and AGAINST.search(told) and where.side != "left"):
            where.lane, where.side, where.facing, where.rel = "partly", "right", "against", None
            entity.roles.discard("oncoming")
            for event in own:
                event.act = "move_along" if event.act in ("oncoming", "approach", "travel") else event.act

"""The other lane of two in one direction: the next one, not the one of those who come the other way."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.whereabouts import Where

OTHER = re.compile(r"\bother (?:(?:traffic|travel|through|open|free) )?lane\b")
COMES = re.compile(
    r"\b(?:on-?coming|oppos\w+|against|contrary|wrong|towards?|head-on|other (?:way|direction|side)"
    r"|com(?:e|es|ing)(?! (?:up|from behind)))\b"
)
"""What tells that the lane is that of the other direction."""
ENDS = re.compile(
    r"\blanes? (?:\w+ ){0,2}(?:ends?|ending|narrows?|merges?|becomes?|drops?|closes?|closed)\b"
    r"|\b(?:ending|ends?|closed|dropped) lane\b"
    r"|\blane drop\b|\b(?:two|2) lanes (?:in)?to (?:one|1|a single)\b"
)


def next_lane(plain: str, road: Road, of: dict[Entity, Where]) -> None:
    """Put those in "the other lane" into the next one, where more than one lane leads ego's way."""
    several = (road.lanes or 0) > 1 or road.kind == "motorway" or road.oncoming is False or ENDS.search(plain)
    if not several or road.oncoming:
        return
    for entity, where in of.items():
        told = [text for _, text in where.phrases]
        if where.lane != "oncoming" or "oncoming" in entity.roles or not any(OTHER.search(t) for t in told):
            continue
        if not any(COMES.search(OTHER.sub("", t)) for t in told):
            where.lane, where.facing = "adjacent", None

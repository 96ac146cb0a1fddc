"""The other lane of two in one direction: the next one, not the one of those who come the other way."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses

OTHER = re.compile(r"\bother (?:(?:traffic|travel|through|open|free) )?lane\b")
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


OPPOSITE_WAY = re.compile(
    r"\bin (?:the |an )?(?:opposite|other) direction\b(?! (?:of|to|from|as|than))|\bthe other way\b"
)
DRIVES = frozenset(("travel", "approach", "keep_lane"))


def meets_ego(clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Put the one spoken of before into the other direction, where ego is told to drive in the opposite one."""
    for event in clauses.events:
        if not (event.agent.ego and event.done and event.act in DRIVES and OPPOSITE_WAY.search(event.text)):
            continue

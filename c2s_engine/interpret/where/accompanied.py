"""Who is told of with others: "a truck stands in the lane with cones behind it", "a car between ego and the truck"."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

ITEM = (
    r"(?:the |an? |some |several |another |two |three |#?\w+ ){0,2}@(a\d+) (?:#?\w+ ){0,2}?"
    r"(behind|in front of|ahead of|beside|next to|alongside) (?:it|them|him|her|(?:the )?@\w+)"
)
WITH_ANOTHER = re.compile(rf" (?:, )?with {ITEM}(?: and {ITEM})?")
NEARER = (0.3, 0.5)
"""The part of the distance to another at which one between ego and it is."""
RELATIONS = {"behind": "behind", "in front of": "ahead", "ahead of": "ahead"}


def accompanied(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Place those whom a clause about another names with it: they are seen from that other."""
    by_key = {e.key: e for e in cast.entities}
    for event in clauses.events:
        match = WITH_ANOTHER.search(event.whole) if event.done else None
        for key, how in (match.groups()[:2], match.groups()[2:]) if match else ():
            other = by_key.get(key or "")
            if other is None or other is event.agent or other not in of:
                continue
            where = of[other]
            where.rel, where.of = RELATIONS.get(how, "beside"), event.agent


WITHIN = re.compile(
    r"\bbetween (?:(?:the |our )?@ego and (?:the |an? )?(?:\w+ ){0,2}@(?P<far>a\d+)"
    r"|(?:the |an? )?(?:\w+ ){0,2}@(?P<far2>a\d+) and (?:the |our )?@ego)\b"
)


def within(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Place those who are between ego and another: both are ahead, the other beyond it."""
    by_key = {e.key: e for e in cast.entities}
    for entity, where in of.items():
        told = [t for _, t in where.phrases] + [e.whole for e in clauses.events if e.agent is entity and e.done]
        match = next((m for t in told if (m := WITHIN.search(t))), None)
        far = by_key.get(match["far"] or match["far2"]) if match else None
        if far is None or far is entity or far not in of or of[far].rel == "behind":
            continue
        if entity.person and entity.type != "bicycle":
            continue
        where.rel, where.of, where.lane = "ahead", cast.ego, where.lane or "same"
        other = of[far]
        if other.gap is not None and where.gap is None:
            where.gap = (other.gap[0] * NEARER[0], other.gap[1] * NEARER[1])
        elif other.gap is None:
            other.rel, other.of, other.lane = "ahead", entity, other.lane or "same"

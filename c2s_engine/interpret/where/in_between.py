"""Who cuts in "between the lead and ego" cuts in before ego, and behind the other."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event

BETWEEN = re.compile(
    r"\bbetween (?:the |an? |its )?(?:[\w-]+ ){0,2}@(?P<a>\w+)(?: ahead| in front)?"
    r" and (?:the |an? |its )?(?:[\w-]+ ){0,2}@(?P<b>\w+)(?P<back> behind)?"
)
INTO_GAP = frozenset(("cut_in", "lane_change"))


def in_between(clauses: Clauses) -> list[tuple[Event, Entity]]:
    """Make ego the one before whom somebody cuts in between it and another; such deeds, with the other."""
    found = []
    for event in clauses.events:
        match = BETWEEN.search(event.text) if event.act in INTO_GAP and not event.agent.ego else None
        if match is None or "ego" not in match.group("a", "b") or match["back"]:
            continue
        event.act, event.patient = "cut_in", clauses.cast.ego
        found += [(event, e) for e in clauses.cast.entities if e.key in match.group("a", "b")]
    return found


def ahead_of_the_gap(pairs: list[tuple[Event, Entity]], of: dict[Entity, Where]) -> None:
    """Put the other ahead of ego, not of who comes between."""
    for event, other in pairs:
        where = of[other]
        if where.of is event.agent or where.of is None and where.rel is None and where.lane is None:
            where.of, where.rel, where.lane = None, "ahead", "same"

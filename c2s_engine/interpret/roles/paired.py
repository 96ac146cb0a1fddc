"""Ego as one of several that were introduced together: "Two cars collided. One was turning left"."""

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast, Entity


def leave_group(one: Entity, cast: Cast, clauses: Clauses) -> None:
    """Take one that becomes ego out of its group: the group is the others then, and what it did with itself it did
    with ego."""
    group = one.group
    if group is None:
        return
    others = [e for e in cast.entities if e.group is group and e is not one]
    group.count -= 1
    rest = others if sum(e.count for e in others) >= group.count else [group]
    for event in clauses.events:
        event.agent, event.also = one, [*event.also, *rest]
    one.group = None

"""Ego as one of several that were introduced together: "Two cars collided. One was turning left"."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, Cast, Entity

MEET = re.compile(
    r"(?:meet|approach|near|reach|arrive|come)\b.*\b(?:intersection|junction|crossroads?|crossing|right angles?)\b"
)


def one_of_both(cast: Cast, clauses: Clauses) -> list[Entity]:
    """One of two that collided with each other or met at a junction, where nothing tells them apart: that is ego."""
    for event in clauses.events:
        group = event.agent
        met = event.act == "collide" or event.act == "approach" and MEET.match(event.text)
        if met and event.done and event.patient is None and group.type in MOTOR and group.count > 1:
            first = cast.member(group, "first")
            return [first] if first is not None else []
    return []


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
        if event.agent is not group:
            event.patient = rest[0] if event.patient is group else event.patient
        elif event.act in ("collide", "approach") and event.patient is None:
            event.agent, event.patient, event.also = rest[0], one, rest[1:]
        else:
            event.agent, event.also = one, [*event.also, *rest]
    one.group = None
    if rest is others:
        for i, entity in cast.of.items():
            cast.of[i] = others[0] if entity is group else entity
        for other in others:
            other.group, other.roles = None, other.roles | group.roles
        cast.entities.remove(group)

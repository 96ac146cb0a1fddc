"""Groups that split: "two vans, the second brakes", "cars in both adjacent lanes"."""

from __future__ import annotations

import re

from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, Cast, Entity


def split_groups(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Members that do or are something of their own leave their group; the others are the group itself again."""
    for group in [e for e in cast.entities if e.count > 1 and e.mover and e.group is None]:
        members = sorted((e for e in cast.entities if e.group is group), key=lambda e: e.ordinal or 0)
        own = [m for m in members if _matters(m, clauses, of)]
        if own:
            _leave(group, own, cast, clauses, of)


def abreast(clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Two told together that are side by side ("a taxi and a van wait side by side"): one is in the lane beside."""
    for event in clauses.events:
        pair = [event.agent, *event.also]
        if len(pair) != 2 or not event.done or not ABREAST.search(event.whole) or event.patient in pair:
            continue
        if any(e.ego or e.type not in MOTOR or e.count > 1 for e in pair):
            continue
        for where in (of[e] for e in pair):
            where.rel = "ahead" if where.rel == "beside" and (where.of is None or where.of in pair) else where.rel


def _matters(member: Entity, clauses: Clauses, of: dict[Entity, Where]) -> bool:
    """Whether a member is told apart from its group by more than being pointed at."""
    group = member.group
    assert group is not None
    where = of[member]
    return (
        member.type != group.type
        or where.hidden_by is not None
        or where.gap is not None
        or where.lane is not None
        or where.side is not None
        or any(
            e.done and (e.agent is member or e.patient is member and e.act in ("collide", "follow", "overtake"))
            for e in clauses.events
        )
    )


def _numbers(member: Entity, whole: int) -> range:
    """Which of a group a member is, or several are."""
    first = member.ordinal if member.ordinal and member.ordinal > 0 else whole - member.count + 1
    return range(first, first + member.count)


def _leave(group: Entity, own: list[Entity], cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Members of their own start where the group starts, one behind the other in the group's order."""
    whole, where = group.count, of[group]
    group.count -= sum(m.count for m in own)
    queue: list[Entity] = []
    for number in range(1, whole + 1):
        member = next((m for m in own if number in _numbers(m, whole)), None)
        queue.append(member if member is not None else group)
    queue = list(dict.fromkeys(queue)) if any(m.count > 1 for m in own) else queue
    queue = queue if all(m in queue for m in own) else [*([group] if group.count else []), *own]
    for member in own:
        before = queue[queue.index(member) - 1] if queue.index(member) else None
        theirs = of[member]
        theirs.lane, theirs.side = theirs.lane or where.lane, theirs.side or where.side
        theirs.facing = theirs.facing or where.facing
        theirs.phrases = [*where.phrases, *theirs.phrases]
        theirs.gap = theirs.gap or (where.gap if before is None else None)
        if theirs.rel in (None, where.rel):
            theirs.rel = where.rel
            aside = (
                theirs.side is not None and theirs.side != (where if before is group else of[before]).side
                if before
                else False
            )
            in_line = before is not None and before is not member and theirs.of is None and not aside
            if before is not None and in_line and theirs.lane in (None, "same"):
                theirs.of, theirs.rel = before, "behind" if where.rel == "behind" else "ahead"
        member.roles |= group.roles - {"group"}
        for event in clauses.events:
            told = any(e.agent is member and e.act == event.act for e in clauses.events)
            if event.agent is group and event.done and member not in event.also and group.count and not told:
                event.also = [*event.also, member]
    if group.count <= 0:
        for event in clauses.events:
            if event.agent is group:
                event.agent, event.also = own[0], [*event.also, *own[1:]]
            event.patient = own[0] if event.patient is group else event.patient
        for theirs in of.values():
            theirs.of = own[0] if theirs.of is group else theirs.of
        cast.entities.remove(group)
    elif queue[0] is not group and where.rel != "behind":
        where.of = queue[queue.index(group) - 1] if where.lane in (None, "same") else where.of


ABREAST = re.compile(
    r"\b(?:side by side|abreast|next to (?:each other|one another)|neck and neck|alongside each other)\b"
)

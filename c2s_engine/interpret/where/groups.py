"""Groups that split: "two vans, the second brakes", "cars in both adjacent lanes"."""

from __future__ import annotations

import re
from copy import copy

from c2s_engine.interpret import language
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, MOVERS, Cast, Entity

BOTH = re.compile(
    r"(?<!across )(?<!over )(?<!cross )(?<!block )"
    r"\b(?:both|either|each) (?:of the )?(?:adjacent |neighbou?ring |adjoining |other |outer |next )?"
    r"(?:lanes?|sides?)\b"
    r"|\b(?:left|right)(?:-hand)?(?: lane| side)? and (?:(?:in|on|to) )?(?:the |its )?(?:left|right)\b(?! turn)"
)


ASIDE = frozenset(("lane_change", "cut_out", "leave_road", "swerve", "yield", "cut_in"))
FROM_BOTH = re.compile(r"\bfrom (?:both|either|each|opposite|the two) (?:sides?|directions?|arms?)\b")


def split_groups(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Members that do or are something of their own leave their group; the others are the group itself again."""
    for group in [e for e in cast.entities if e.count > 1 and e.mover and e.group is None]:
        members = sorted((e for e in cast.entities if e.group is group), key=lambda e: e.ordinal or 0)
        own = [m for m in members if _matters(m, clauses, of)]
        for member in members:
            if member not in own:
                _dissolve(member, group, cast, clauses, of)
        if own:
            _leave(group, own, cast, clauses, of)
        elif group.ordinal is None and _every_lane(group, cast, of):
            _in_every_lane(group, cast, clauses, of)
        elif group.ordinal is None and any(p.search(_said(group, cast, of)) for p in (BOTH, FROM_BOTH)):
            _both_sides(group, cast, clauses, of)


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


def _said(entity: Entity, cast: Cast, of: dict[Entity, Where]) -> str:
    near = [
        " ".join(w.norm for w in cast.words[m.word : m.word + 9] if w.sentence == cast.words[m.word].sentence)
        for m in entity.mentions[:1]
    ]
    return " ; ".join([*near, *(t for _, t in of[entity].phrases)])


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


def _dissolve(member: Entity, group: Entity, cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """The member is only pointed at: it stands for the group."""
    for i, entity in list(cast.of.items()):
        if entity is member:
            cast.of[i] = group
    for event in clauses.events:
        event.agent = group if event.agent is member else event.agent
        event.patient = group if event.patient is member else event.patient
    for where in of.values():
        where.of = group if where.of is member else where.of
        where.hidden_by = group if where.hidden_by is member else where.hidden_by
    cast.entities.remove(member)
    of.pop(member, None)


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
    idle = group.count > 0 and not any(group in (e.agent, e.patient) for e in clauses.events)
    if idle and where.rel is None and where.lane is None and of[own[0]].lane is None and _counted(group, cast):
        where.rel = "ahead"
    if cast.in_a_row(group) and where.rel in (None, "ahead") and where.lane != "oncoming":
        queue.reverse()  # ego is behind: the last one is the nearest
    for member in own:
        before = queue[queue.index(member) - 1] if queue.index(member) else None
        theirs = of[member]
        theirs.lane, theirs.side = theirs.lane or where.lane, theirs.side or where.side
        if where.lane == "parked" and theirs.side:
            theirs.lane = "parked"
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


def _both_sides(group: Entity, cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """One half of the group is on the left, the other on the right."""
    where = of[group]
    queue = group.noun in language.table("actors")["queues"]
    if (
        queue
        or group.type not in MOVERS
        or where.lane in ("oncoming", "ramp")
        or where.lane == "crossing"
        and where.side
        or group.roles & {"oncoming"}
    ):
        return
    twin = copy(group)
    twin.key, twin.roles, twin.mentions = f"{group.key}0", set(group.roles), list(group.mentions)
    off = where.lane in ("parked", "roadside", "sidewalk") or "parked" in group.roles or group.person
    rows = off and group.type in MOTOR and group.count == 2 and not _counted(group, cast)
    twin.count = 2 if rows else max(1, group.count // 2)
    group.count = 2 if rows else max(1, group.count - twin.count)
    cast.entities.insert(cast.entities.index(group) + 1, twin)
    other = copy(where)
    other.phrases = list(where.phrases)
    moves = [e for e in clauses.events if e.agent is group and e.act in ASIDE]
    for event in moves:
        event.side = "left"
    for half, side in ((where, "left"), (other, "right")):
        half.side = side
        if not off:
            half.lane, half.rel = side, half.rel or "beside"
    of[twin] = other
    for event in clauses.events:
        if event.agent is group:
            event.also = [*event.also, twin]


def _counted(group: Entity, cast: Cast) -> bool:
    """Whether a number is told with a group: "two cars", not "cars"."""
    counts = language.table("actors")["counts"]
    at = group.mentions[0].word
    return any(w.norm in counts or w.tag == "CD" for w in cast.words[max(0, at - 3) : at])


EVERY = re.compile(
    r"\b(?:both|all|two|all two|the two) (?:of the |the )?lanes?\b[^.;]{0,40}?\b(?:by|with|of|full)\b[^.;]{0,20}$"
)


IN_ALL = re.compile(r"\bin (?:both|all|the two|all three|all two) (?:of the )?lanes\b")
MIDDLE = re.compile(r"\b(?:middle|cent(?:er|re)) (?:one )?(?:lane|of)\b")


def _ego_in_middle(cast: Cast) -> bool:
    """Whether ego has a lane on either side, so that "both lanes" are those beside it."""
    return MIDDLE.search(" ".join(w.norm for w in cast.words)) is not None


ABREAST = re.compile(
    r"\b(?:side by side|abreast|next to (?:each other|one another)|neck and neck|alongside each other)\b"
)


def _every_lane(group: Entity, cast: Cast, of: dict[Entity, Where]) -> bool:
    """Whether some fill the lanes of ego's direction: "both lanes are blocked by stationary cars", "two trucks side by
    side block both lanes"."""
    if group.type not in MOTOR:
        return False
    if IN_ALL.search(_said(group, cast, of)) and not _ego_in_middle(cast):
        return True
    if "stationary" not in group.roles:
        return False
    for mention in group.mentions:
        number = cast.words[mention.word].sentence
        before = [w.norm for w in cast.words[max(0, mention.word - 12) : mention.word] if w.sentence == number]
        if EVERY.search(" ".join(before) + " "):
            return True
    return False


def _in_every_lane(group: Entity, cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """One half of the group is in ego's lane, the other in the lane beside; of three, one is in each lane."""
    where = of[group]
    where.lane, where.rel, where.side = "same", "ahead", None
    where.of = None if where.of is not None and where.of.ego else where.of
    lanes = ("left", "right") if group.count == 3 else ("adjacent",)
    for number, lane in enumerate(lanes):
        twin = copy(group)
        twin.key, twin.roles, twin.mentions = f"{group.key}{number}", set(group.roles), list(group.mentions)
        twin.count = max(1, group.count // (len(lanes) + 1 - number))
        group.count = max(1, group.count - twin.count)
        cast.entities.insert(cast.entities.index(group) + 1, twin)
        other = copy(where)
        other.phrases, other.lane = list(where.phrases), lane
        of[twin] = other
        for event in clauses.events:
            if event.agent is group:
                event.also = [*event.also, twin]

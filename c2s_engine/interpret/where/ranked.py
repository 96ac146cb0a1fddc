"""Ego as one of a row ("the second of three trucks", "third in the queue", "parked between two cars"): who is ahead of
it and who is behind."""

from __future__ import annotations

import re
from copy import copy

from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

NTH = {"first": 1, "leading": 1, "front": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "last": -1, "rear": -1}
_NTH = "|".join([*NTH, "rearmost", "middle", "central"])
IN_LINE = re.compile(
    rf"\b(?:(?P<nth>{_NTH})(?: (?:one|truck|vehicle|car|@\w+))?(?: \w+)? )?"
    r"in (?:(?:a|the|this|that|its) (?:[\w-]+ ){0,2}?(?:queue|tailback|jam|line|row)|line)\b"
    r"(?! (?:with|of (?:sight|fire|the)))"
)
BETWEEN = re.compile(
    r"\bbetween (?:the |two |a |an )?(?:other |\w+ )?@(?P<a>a\d+)(?: and (?:a |an |another )?(?:\w+ )?@(?P<b>a\d+))?"
)


def ranked(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> tuple[Entity | None, str | None]:
    """Place the others of a row of which ego is one: the group to which it belongs, and the lane in which that is."""
    row, lane = None, None
    for event in clauses.events:
        if not event.agent.ego or not event.done:
            continue
        said = [w for w in cast.words if w.sentence == cast.words[event.word].sentence]
        if event.act == "stationary" and (match := IN_LINE.search(event.text)) is not None:
            struck = any(e.act == "collide" and e.done and e.patient is cast.ego for e in clauses.events)
            if match["nth"] or not struck:
                _in_a_queue(match["nth"], event, cast, of)
        whole = clauses.render([w.i for w in said])
        if event.act == "stationary" and "park" in whole and (match := BETWEEN.search(whole)) is not None:
            _parked_between(match, cast, of)
    return row, f"{lane}most" if lane in ("left", "right") else None


def _part(group: Entity, ahead: int, behind: int, cast: Cast, of: dict[Entity, Where]) -> None:
    """So many of a group are ahead of ego, so many behind it, in its lane."""
    where = of[group]
    where.lane = "same" if where.lane in (None, "left", "right") else where.lane
    where.rel, where.of = "ahead" if ahead else "behind", None
    group.count = ahead or behind
    if not (ahead and behind):
        return
    twin = copy(group)
    twin.key, twin.roles, twin.mentions, twin.count = f"{group.key}0", set(group.roles), list(group.mentions), behind
    cast.entities.insert(cast.entities.index(group) + 1, twin)
    of[twin] = copy(where)
    of[twin].phrases, of[twin].rel = list(where.phrases), "behind"


def _in_a_queue(nth: str | None, event: Event, cast: Cast, of: dict[Entity, Where]) -> None:
    """Those who stand before ego in a queue, where nobody else is told to be there."""
    if nth and NTH.get(nth) == 1:
        return
    if any(e.type in MOTOR and (w.rel == "ahead" or e.count > 1 and w.rel is None) for e, w in of.items()):
        return
    _row("car", "cars", 2, event, cast, of)


def _row(kind: str, noun: str, count: int, event: Event, cast: Cast, of: dict[Entity, Where]) -> Entity:
    """Some ahead of ego, of whom only the row is told."""
    row = Entity(f"q{event.word}", kind, noun, count, mentions=list(cast.ego.mentions[:1]), typed=True)
    cast.entities.append(row)
    of[row] = Where(rel="ahead", lane="same")
    return row


def _parked_between(match: re.Match[str], cast: Cast, of: dict[Entity, Where]) -> None:
    """Of two between which ego is parked one is ahead, the other behind."""
    pair = [e for key in ("a", "b") for e in cast.entities if e.key == match[key]]
    if len(pair) == 1 and pair[0].count == 2:
        _part(pair[0], 1, 1, cast, of)

"""Ego as one of a line of vehicles that were told together: "three cars drive in a row, the last one is ego"."""

from __future__ import annotations

import re
from copy import copy

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, ORDINALS, Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

NUMBERS = {**{name: at + 1 or -1 for name, at in ORDINALS.items()}, "middle": 0, "rearmost": -1, "hindmost": -1}
NUMBER = f"(?P<n>{'|'.join(NUMBERS)})"
LINE = r"(?:in|of) (?:a |the |this |that )?(?:line|row|queue|convoy|column|platoon|chain|file|string|procession)"
PATTERNS = (
    re.compile(
        r"@ego(?: ,)? (?:(?:am|is|are|was|were|be|being|drives|drove|driving|travels|travelling|comes|runs|as|the) )*"
        rf"{NUMBER}(?: (?:one|@a\d+|@ego))?(?= of\b| {LINE}| ?[,.;)]|$)"
    ),
    re.compile(
        rf"\b{NUMBER}(?: (?:one|@a\d+|@ego))?(?: of (?:which|them|these|those|whom|@a\d+))?(?: ,)?"
        r" (?:is|was|being) (?:the )?@ego\b"
    ),
    re.compile(rf"\b{NUMBER} (?:one|@a\d+|@ego) [,(] (?:the )?@ego(?= ?[,.;)]|$)"),
)
LANES = {"left": "leftmost", "right": "rightmost"}


def ego_in_line(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> str | None:
    """Put the others of such a line ahead of ego and behind it; ego's lane ("": not told), None where there is none."""
    for group in [e for e in cast.entities if e.count > 1 and e in of]:
        told = _number(group, cast) if of[group].lane in (None, "same", *LANES) else None
        if told is not None:
            lane = LANES.get(of[group].lane or "", "")
            _same(group, told[1], cast, clauses)
            _take_apart(group, told[1], cast, of)
            return lane
    return None


def _same(group: Entity, at: int, cast: Cast, clauses: Clauses) -> None:
    """Who is told by that number is ego; to be "third in line" is no standing."""
    if not cast.ego.typed and group.type != "vehicle":
        cast.ego.type, cast.ego.typed = group.type, True
    for one in list(cast.entities):
        member = one.count == 1 and one.group is group and (one.ordinal if one.ordinal != -1 else group.count) == at
        if member:
            _is_ego(one, cast, clauses)


def _take_apart(group: Entity, at: int, cast: Cast, of: dict[Entity, Where]) -> None:
    """Place the members of a group of which ego is one by their numbers."""
    members: dict[int, Entity] = {}
    for one in [e for e in cast.entities if e.group is group]:
        first = group.count if one.ordinal == -1 else one.ordinal or 0
        members |= dict.fromkeys(range(first, first + one.count), one)
    ahead = [members.get(k, group) for k in range(at - 1, 0, -1)]
    behind = [members.get(k, group) for k in range(at + 1, group.count + 1)]
    if group in ahead and group in behind:
        behind = [_twin(group, behind.count(group), cast, of) if e is group else e for e in behind]
    group.count = (ahead + behind).count(group)
    for row, rel in ((ahead, "ahead"), (behind, "behind")):
        _line_up(list(dict.fromkeys(row)), rel, of)
    for member in dict.fromkeys(members.values()):
        member.group, member.roles = None, member.roles | group.roles


def _twin(group: Entity, count: int, cast: Cast, of: dict[Entity, Where]) -> Entity:
    """Those of a group that are behind ego, where others are ahead of it."""
    found = next((e for e in cast.entities if e.key == f"{group.key}0"), None)
    if found is None:
        found = copy(group)
        found.key, found.roles, found.count = f"{group.key}0", set(group.roles), count
        cast.entities.insert(cast.entities.index(group) + 1, found)
        of[found] = copy(of[group])
    return found


def _number(group: Entity, cast: Cast) -> tuple[int, int] | None:
    """The sentence that tells ego's place in a group of vehicles, and that place, counted from the front."""
    queue = group.noun in language.table("actors")["queues"]
    if group.type not in MOTOR | {"vehicle"} or queue or not group.mentions or group.count < 2:
        return None
    first = cast.words[group.mentions[0].word].sentence
    for number in sorted({w.sentence for w in cast.words if w.sentence >= first}):
        text = _sentence_with_keys(cast, number)
        match = next((m for p in PATTERNS if (m := p.search(text))), None)
        if match is not None:
            place = NUMBERS[match["n"]]
            place = group.count if place == -1 else place or (group.count + 1) // 2
            return (number, place) if place <= group.count else None
    return None


def _sentence_with_keys(cast: Cast, number: int) -> str:
    """A sentence with ego and the others by their keys."""
    words = [w for w in cast.words if w.sentence == number]
    return " ".join(f"@{cast.of[w.i].key}" if w.i in cast.of and w.norm not in NUMBERS else w.norm for w in words)


def _is_ego(member: Entity, cast: Cast, clauses: Clauses) -> None:
    """What was told of that member was told of ego."""
    for event in clauses.events:
        event.agent = cast.ego if event.agent is member else event.agent
        event.patient = cast.ego if event.patient is member else event.patient
    cast.entities.remove(member)


def _line_up(row: list[Entity], rel: str, of: dict[Entity, Where]) -> None:
    """Each one of the row further from ego than the one before."""
    last: Entity | None = None
    for one in row:
        where = of[one]
        where.rel, where.of, where.lane, where.side = rel, last, "same", None
        last = one

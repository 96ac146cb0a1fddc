"""How much of the S of a scene a reading has: field by field, objects matched as fits best."""

from collections import Counter
from dataclasses import dataclass
from itertools import islice, permutations
from typing import Any

from c2s_engine.structure.components import Structure

NOT_SAID = ("component", "name", "model", "later")
"""Fields that no text says."""
MOST = 6
"""Objects up to which every matching is tried."""


@dataclass(frozen=True)
class Agreement:
    """Fields that agree, fields read, fields that are there; whether as many objects were read."""

    agreed: int
    read: int
    there: int
    objects: bool

    @property
    def exact(self) -> bool:
        """Whether nothing is missing and nothing too much."""
        return self.agreed == self.read == self.there


def agreement(read: Structure, there: Structure) -> Agreement:
    """The best agreement over the ways to match the objects."""
    found = _agreed(read, there, matching(read, there))
    count = [sum(sum(_fields(s, c.id, {}).values()) for c in s.components) for s in (read, there)]
    return Agreement(found, count[0], count[1], len(read.objects) == len(there.objects))


def matching(read: Structure, there: Structure) -> dict[str, str | None]:
    """By object that is there, the one that was read of it, as fits best; None where none was."""
    mine, theirs = [o.id for o in read.objects], [o.id for o in there.objects]
    slots: list[str | None] = [*mine, *[None] * max(0, len(theirs) - len(mine))]
    ways = permutations(slots, len(theirs)) if len(slots) <= MOST else islice(permutations(slots, len(theirs)), 1)
    matches = (dict(zip(theirs, way, strict=True)) for way in ways)
    return max(matches, key=lambda match: _agreed(read, there, match), default={})


def _agreed(read: Structure, there: Structure, match: dict[str, str | None]) -> int:
    names = {own: their for their, own in match.items() if own is not None}
    pairs = [*((c, c) for c in ("G", "R", "E", "T")), *((own, their) for own, their in names.items())]
    return sum(sum((_fields(read, own, names) & _fields(there, their, {})).values()) for own, their in pairs)


def _fields(structure: Structure, cid: str, names: dict[str, str]) -> Counter[Any]:
    """What a component says, as a bag of (where, field, value): the order of phases apart."""
    found: Counter[Any] = Counter()

    def walk(data: dict[str, Any], path: str) -> None:
        for name, value in data.items():
            if name in NOT_SAID:
                continue
            if isinstance(value, list) and value and isinstance(value[0], dict):
                for row in value:
                    head = row.get("action") or row.get("kind") or row.get("to")
                    if len(row) > 1 or head != "keep_lane":
                        found[path, name, head] += 1
                        walk({k: v for k, v in row.items() if k != "action"}, f"{path}.{head}")
            elif isinstance(value, dict):
                walk(value, f"{path}.{name}")
            else:
                found[path, name, str(_plain(value, names))] += 1

    walk(structure[cid].spec.model_dump(mode="json", exclude_defaults=True, exclude_none=True), "")
    return found


def _plain(value: Any, names: dict[str, str]) -> Any:
    if isinstance(value, list):
        middle = all(isinstance(v, float) for v in value) and len(value) == 2
        return round(sum(value) / 2, 1) if middle else [_plain(v, names) for v in value]
    if isinstance(value, float):
        return round(value, 1)
    return names.get(value, value) if isinstance(value, str) else value

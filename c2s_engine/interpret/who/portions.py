"""Portions of a group: "the first two", "the rest", "two of them", each an entity of its own that leaves the group."""

from __future__ import annotations

from c2s_engine.interpret.entities import ORDINALS, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.by_place import ByPlace


class Portions(ByPlace):
    """The part of Cast that takes several out of a group."""

    words: list[Word]
    entities: list[Entity]
    of: dict[int, Entity]

    def _new(self, entity: Entity) -> Entity:
        raise NotImplementedError

    def _together(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _all_of(self, word: Word, those: list[Entity]) -> Entity:
        raise NotImplementedError

    def _groups(self) -> list[Entity]:
        """Those who were told of as several, without what was taken out of them."""
        return [e for e in self.entities if e.count > 1 and e.mover and e.group is None and "group" not in e.roles]

    def portion(self, group: Entity, end: str, number: int) -> Entity | None:
        """The first or last few of a group; of a vague plural there is one more."""
        group.count = max(group.count, number + 1)
        return self._portion(group, 1 if end == "first" else group.count - number + 1, number)

    def _portion(self, group: Entity, first: int, number: int) -> Entity:
        known = (e for e in self.entities if e.group is group and e.ordinal == first and e.count == number)
        roles = set(group.roles)
        new = Entity("", group.type, noun=group.noun, count=number, roles=roles, group=group, ordinal=first)
        return next(known, None) or self._new(new)

    def member(self, group: Entity, told: str) -> Entity | None:
        """The member of a group by its number; None where the group has fewer."""
        number = ORDINALS[told] + 1 or -1
        if number > group.count:
            return None
        number = -1 if number == group.count else number
        known = next((e for e in self.entities if e.group is group and e.ordinal == number), None)
        if known is not None:
            return known
        return self._new(
            Entity("", group.type, noun=group.noun, typed=False, roles=set(group.roles), group=group, ordinal=number)
        )

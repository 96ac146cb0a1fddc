"""Portions of a group: "the first two", "the rest", "two of them", each an entity of its own that leaves the group."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import ORDINALS, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.by_place import ByPlace

ROW = re.compile(r"\b(?:platoon|convoy|column|queue|line|row|file|string|procession|caravan|train) of\b")


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

    def _share(self, word: Word) -> Entity | None:
        """Whom words for a share mean: "the first two", "each of them", "the rest"."""
        assert word.span is not None
        share, number = word.span.data["share"], word.span.data["n"]
        groups = self._groups()
        if not groups:
            return self._of_single(word, share, number)
        if share == "all":
            return groups[-1]
        if share == "rest":
            return self.rest(groups[-1], number)
        if number > 1:
            return self.portion(groups[-1], share, number)
        if share == "one":
            return self.member(groups[-1], "last" if self.in_a_row(groups[-1]) else "first")
        return self.member(groups[-1], share)

    def in_a_row(self, group: Entity) -> bool:
        """Whether a group goes or stands one behind the other, so that its first is the front one."""
        first = self.words[group.mentions[0].word] if group.mentions else None
        near = self.words[max(0, first.i - 5) : first.i] if first is not None else []
        return ROW.search(" ".join(w.norm for w in near if first and w.sentence == first.sentence)) is not None

    def _groups(self) -> list[Entity]:
        """Those who were told of as several, without what was taken out of them."""
        return [e for e in self.entities if e.count > 1 and e.mover and e.group is None and "group" not in e.roles]

    def _of_single(self, word: Word, share: str, number: int) -> Entity | None:
        """Those who were told of one by one: "all three brake", "the first two turn off"."""
        told = list(dict.fromkeys(self.of[i] for i in sorted(self.of) if i < word.i))
        single = [e for e in told if e.mover and not e.ego and e.count == 1]
        wanted = number or len(single)
        if share == "all" and wanted == 2 or len(single) < 2:
            return self._together(word)
        alike = [e for e in single if e.person == single[-1].person]
        if share == "all" and wanted != len(alike):
            return None  # ego may be one of them
        at = ORDINALS.get(share, 0)
        return single[at] if at < len(single) else None

    def portion(self, group: Entity, end: str, number: int) -> Entity | None:
        """The first or last few of a group; of a vague plural there is one more."""
        group.count = max(group.count, number + 1)
        return self._portion(group, 1 if end == "first" else group.count - number + 1, number)

    def rest(self, group: Entity, number: int = 0) -> Entity | None:
        """Those of a group who were not told apart; the group where nobody was."""
        known = [e for e in self.entities if e.group is group]
        if not known:
            return group
        taken: set[int] = set()
        for member in known:
            first = member.ordinal if (member.ordinal or 0) > 0 else group.count - member.count + 1
            taken |= set(range(first or 1, (first or 1) + member.count))
        group.count = max(group.count, len(taken) + max(1, number))
        left = sorted(set(range(1, group.count + 1)) - taken)
        return self._portion(group, left[0], number or len(left))

    def _portion(self, group: Entity, first: int, number: int) -> Entity:
        known = (e for e in self.entities if e.group is group and e.ordinal == first and e.count == number)
        roles = set(group.roles)
        new = Entity("", group.type, noun=group.noun, count=number, roles=roles, group=group, ordinal=first)
        return next(known, None) or self._new(new)

    def member(self, group: Entity, told: str) -> Entity | None:
        """The member of a group by its number; None where the group has fewer."""
        number = ORDINALS[told] + 1 or -1
        if number == 3 and group.count == 2:  # "several": more than two
            group.count = 3
        if number > group.count:
            return None
        number = -1 if number == group.count else number
        known = next((e for e in self.entities if e.group is group and e.ordinal == number), None)
        if known is not None:
            return known
        return self._new(
            Entity("", group.type, noun=group.noun, typed=False, roles=set(group.roles), group=group, ordinal=number)
        )

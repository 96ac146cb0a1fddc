"""Members of groups and words that leave the noun out: "the second", "one ..., the other ...", "another"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import ORDINALS, VEHICLES, Entity, Mention
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.portions import Portions

ENDS = {
    "first": {"before": ("front", "leading", "foremost"), "after": r"(?:in|at the) front\b|ahead\b"},
    "last": {"before": ("rear", "rearmost", "trailing", "back"), "after": r"behind\b|at the (?:back|rear|end)\b"},
}
"""What tells the first and the last of a group, before and after "one"."""
PICKED = {"latter": "last", "former": "first", "one": "first"}
"""Words that pick one out of those who are named after "of"."""
NUMBERS = frozenset(("two", "three", "four"))
COUNTED = frozenset(("second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"))


class Members(Portions):
    """The part of Cast that finds who is meant by a number or by "another"."""

    words: list[Word]
    entities: list[Entity]
    of: dict[int, Entity]
    both: dict[int, list[Entity]]
    subjects: list[tuple[int, Entity]]

    def _governor(self, word: Word) -> Word:
        raise NotImplementedError

    def _subject_of(self, verb: Word) -> Entity | None:
        raise NotImplementedError

    def _member_of(self, word: Word) -> Entity | None:
        """ "The second", "the last one", "the first of them", after a group was spoken of: a member of it."""
        before = [w.norm for w in self.words[max(0, word.i - 2) : word.i] if w.sentence == word.sentence]
        groups = self._groups()
        told = word.norm if word.norm in ORDINALS else before[-1] if before and word.norm == "one" else ""
        if word.norm == "one" and groups and (end := self._end(word, before, groups[-1])):
            return self.member(groups[-1], end)
        named = before[-1:] if told == word.norm else before[-2:-1]
        single = self._one_of(word, before, groups[-1]) if groups else None
        if single is not None:
            return single
        if told not in ORDINALS or named not in (["the"], ["its"]):
            return None
        return self.member(groups[-1], told) if groups else None

    def _end(self, word: Word, before: list[str], group: Entity) -> str:
        """Which end of a group "the one in front", "the rear one" or "the one behind" is."""
        if "the" not in before:
            return ""
        ahead = "ahead" in self._hints(group)  # the first of those ahead is the nearest
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 5] if w.sentence == word.sentence)
        if group.count == 2 and (side := re.match(r"(?:on|to) (?:the|its|@ego 's) (left|right)\b", after)):
            return "first" if side[1] == "left" else "last"
        for number, ends in ENDS.items():
            if before[-1] in ends["before"]:
                return number if not ahead else "last" if number == "first" else "first"
        return ""

    def _hints(self, entity: Entity) -> set[str]:
        raise NotImplementedError

    def _cataphoric_member(self) -> None:
        """ "The second of the three cars", "two of the vans", where the group is named after its member."""
        counts = language.table("actors")["counts"]
        for word in self.words:
            told = PICKED.get(word.norm, word.norm)
            number = int(counts.get(word.norm, 0)) if word.norm in NUMBERS else 0
            if told not in ORDINALS and not number or word.i in self.of or word.dep in ("nummod", "amod", "det"):
                continue
            for by in (self.words[c] for c in word.children if self.words[c].norm == "of"):
                groups = [self.of[c] for c in by.children if c in self.of and self.of[c].count > max(1, number)]
                if not groups or not groups[0].mover:
                    continue
                found = self.portion(groups[0], "first", number) if number else self.member(groups[0], told)
                if found is not None:
                    self.of[word.i] = found
                    found.mentions.append(Mention(word.i, word.start, word.end, kind="pronoun"))

    def _one_of(self, word: Word, before: list[str], group: Entity) -> Entity | None:
        """ "One bolts across, the other stays", after two were spoken of: one member and the other."""
        acts = word.i + 1 < len(self.words) and (self.words[word.i + 1].verb or word.dep == "nsubj")
        if not acts or group.mentions and group.mentions[0].word >= word.i:
            return None
        bare = not before or before[-1] not in ("the", "that", "this", "other", "every", "each", "no", "last", "first")
        if word.norm == "one" and bare and not (before and before[-1] in ORDINALS):
            return self.member(group, "first")
        known = [e for e in self.entities if e.group is group]
        if (word.norm == "other" or word.norm == "one" and before[-1:] == ["other"]) and known:
            return self.member(group, "first" if len(known) == 1 and known[0].ordinal == -1 else "last")
        return None

    def _elliptic(self, word: Word) -> Entity | None:
        """ "another", "the latter", "the other", "one", "the first", "a third", "both", "the two"."""
        norm = word.norm
        if word.children and any(self.words[c].span for c in word.children if self.words[c].dep == "compound"):
            return None
        argument = word.dep in (
            "nsubj",
            "nsubjpass",
            "dobj",
            "pobj",
            "conj",
            "ROOT",
            "attr",
            "appos",
            "dep",
            "npadvmod",
        )
        following = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        if (
            following is not None
            and (following.noun or following.tag.startswith("JJ"))
            and following.sentence == word.sentence
            and following.norm not in ("one",)
            and not following.verb
            or word.norm in COUNTED
            and "lane" in [w.norm for w in self.words[word.i + 1 : word.i + 4]]
        ):
            return None
        movers = [e for e in self.entities if e.mover]
        if not argument or not movers:
            return None
        member = self._member_of(word)
        if member is not None:
            return member
        if norm in ("former", "latter"):
            spoken = [
                self.of[w.i] for w in self.words[: word.i] if w.i in self.of and w.norm not in ("former", "latter")
            ]
            others = [
                self.of[w.i]
                for w in self.words[: word.i]
                if w.i in self.of
                and (w.span is not None or w.norm == "another")
                and w.sentence >= word.sentence - 3
                and not self.of[w.i].ego
            ]
            spoken = others if len(set(others)) > 1 else spoken
            pair = list(dict.fromkeys(reversed(spoken)))[:2]
            return pair[0 if norm == "latter" or len(pair) == 1 else 1] if pair else None
        counted = norm == "one" and word.i > 1 and self.words[word.i - 1].norm in COUNTED
        if (
            norm == "another"
            or norm == "one"
            and self.words[word.i - 1].norm == "another"
            or norm in COUNTED
            and self.words[word.i - 1].norm in ("a", "the")
            or counted
            and self.words[word.i - 2].norm == "a"
        ):
            model = movers[-1]
            after = [w.norm for w in self.words[word.i + 1 : word.i + 3]]
            of_a_kind = model.noun != "vehicle" and after not in ([",", "a"], [",", "an"])  # "the third, a Nissan, ran"
            return self._new(
                Entity(
                    "",
                    model.type if of_a_kind else "vehicle",
                    noun=model.noun if of_a_kind else "",
                    typed=model.typed and of_a_kind,
                    roles=set(model.roles & {"parked", "stationary"}),
                )
            )
        if norm == "one" and self.words[word.i - 1].norm in ("that", "this"):
            return movers[-1]
        before = self.words[word.i - 1].norm if word.i else ""
        if norm in ("other", "others") and before == "the" or norm == "one" and before == "other":
            mutual = "one" in [w.norm for w in self.words[max(0, word.i - 4) : word.i - 1]]
            return self._the_other(movers, mutual)
        if norm == "one" and word.dep == "nsubj" and self.words[word.i - 1].sentence != word.sentence:
            return self._one_of_two(word)
        if norm == "both" or norm in ("two", "pair", "duo") and self.words[word.i - 1].norm in ("the", "these"):
            return self._together(word)
        return None

    def _the_other(self, movers: list[Entity], mutual: bool) -> Entity:
        """Whom "the other" means: not who was the last subject (unless in "one behind the other"), one of the same kind
        or a vehicle if there is one."""
        last = next((e for _, e in reversed(self.subjects) if not e.ego), None) if not mutual else None
        rest = [e for e in movers if e is not last] or movers
        alike = [e for e in rest if last is not None and e.type == last.type]
        vehicles = [e for e in rest if e.type in VEHICLES]
        return (alike or vehicles or rest)[-1]

    def _one_of_two(self, word: Word) -> Entity | None:
        """Whom "one" means where "the other" follows, and two were told of singly: the first of them."""
        after = [w.norm for w in self.words[word.i : word.i + 40] if w.sentence <= word.sentence + 1]
        told = dict.fromkeys(self.of[i] for i in sorted(self.of) if i < word.i)
        single = [e for e in told if e.mover and not e.ego and e.count == 1]
        return single[0] if "other" in after and len(single) == 2 else None

    def _together(self, word: Word) -> Entity | None:
        """Whom "both" or "the two" mean: a group, those of a joint subject, else the last two spoken of."""
        earlier = [self.of[i] for i in sorted(self.of) if i < word.i and self.of[i].mover]
        groups = [e for e in earlier if e.count > 1]
        since = list(dict.fromkeys(e for e in earlier[earlier.index(groups[-1]) :] if e.count == 1)) if groups else []
        if groups and not (groups[-1].roles & {"parked", "stationary"} and len([e for e in since if not e.ego]) > 1):
            return groups[-1]
        joint = None
        doer = self._subject_of(self._governor(word)) if word.dep in ("dobj", "pobj", "npadvmod") else None
        earlier = [e for e in earlier if e is not doer]
        if (joint is None or doer in joint) and earlier:
            last = list(dict.fromkeys(reversed(earlier)))[:2]
            joint = sorted(last, key=lambda e: e.ego) if len(last) == 2 else None
        return self._all_of(word, joint) if joint else None

    def _all_of(self, word: Word, those: list[Entity]) -> Entity:
        """One word that means several of them: the first, with the others beside."""
        self.both[word.i] = those[1:]
        return those[0]

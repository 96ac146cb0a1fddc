"""Whom a definite noun phrase means of those spoken of before."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import ORDINALS, URGENT, VEHICLES, Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.owned import Owned

ANYBODY = language.words("anybody")
"""Nouns of no type by which ego may be meant, too: not "the target", "the attacker"."""
COLOURS = language.words("colours")
BOUND = language.words("bound")
"""Which way one drives, by which it is told from another."""
CARS = frozenset(("car", "vehicle", "van", "police_car"))
TOLD_APART = frozenset(("oncoming", "crossing", "lead", "following", "cut_in", "adjacent", "adversary"))
"""Parts in the scene by which another one is meant, unless somebody had that part before."""


ALL_OF_THEM = frozenset(("both", "the", "these", "all", "neither"))


class Reference(Owned):
    """The part of Cast that resolves definite nouns."""

    ego_named: bool

    def _definite(
        self,
        word: Word,
        kind: str,
        noun: str,
        roles: set[str],
        other: bool,
        ordinal: int | None,
        definite: bool,
        count: int,
        bare: bool,
    ) -> Entity | None:
        before = self._near(word)
        candidates = [e for e in self.entities if fits(e, kind)]
        ways = BOUND & set(before)
        candidates = [e for e in candidates if not ways or ways & e.names or not BOUND & e.names]
        if count == 1 and kind != "vehicle":  # the tractor is not the oncoming traffic
            candidates = [e for e in candidates if e.noun != "traffic"]
        candidates = list(candidates)
        coloured = [e for e in candidates if e.names & COLOURS & set(before)]
        candidates = coloured or candidates
        if noun in (brands := language.makes()):  # "the Kia hit the Hyundai"
            same = language.table("actors")["same_makes"].get(noun, noun)
            candidates = [e for e in candidates if e.noun not in brands or {noun, same} & {e.noun, *e.names}]
            candidates = [e for e in candidates if count > 1 or not e.noun.endswith("queue")]
        groups = [e for e in candidates if e.count > 1 and e.group is None and "group" not in e.roles]
        if ordinal is not None and count == 1 and definite and not roles:
            told = next((name for name, at in ORDINALS.items() if at == ordinal), "")
            if groups and (member := self.member(groups[-1], told)) is not None:
                return member
        plural = count > 1 or word.span is not None and bool(word.span.data.get("plural"))
        if roles:
            same = [e for e in candidates if e.roles & roles and (definite or (e.count > 1) == (count > 1))]
            if same:
                several = [e for e in same if e.count > 1] if plural else []
                return (several or same)[-1]  # "one of the parked cars": of the group, not of the one
            if roles == {"following"} and definite and count == 1:
                followers = [e for e in candidates if "following" in self._hints(e)]
                if followers:
                    return followers[-1]
            if roles & {"lead"}:
                ahead = [e for e in candidates if "ahead" in self._hints(e)]
                if ahead:
                    return ahead[-1]
            if roles & {"oncoming"} and definite:
                towards = [e for e in candidates if "oncoming" in self._hints(e)]
                if towards:
                    return towards[-1]
            if not definite and roles & {"stationary", "parked", "slow", "turning", "fast"}:
                return None
            if roles & TOLD_APART or not candidates:
                return None
        alone = noun in ("car", "vehicle") and not candidates and not roles and definite and not other
        if alone and (self._out_of_my_hand(word)):
            return self.ego
        if kind == "vehicle" and noun == "vehicle" and not self.ego_named and not bare and not other:
            generic = [e for e in candidates if e.noun == "vehicle"]
            plain = [e for e in candidates if e.noun != "vehicle" and not e.roles and e.type != "bicycle"]
            asked = any(self.words[c].norm in ("shall", "must") for c in self.words[word.head].children)
            if asked and not generic and word.dep == "nsubj" and all(e.type in URGENT for e in candidates):
                return None  # "when an ambulance approaches, the vehicle shall clear the lane"
            if not generic and (len(candidates) != 1 or not plain):
                return None
        if bare and not roles and self._distinguished(word):
            return None  # "car in front stops. Car in front moves"
        if bare and not roles:
            called = (e for e in reversed(candidates) if e.noun == noun or e.noun.endswith(f" {noun}"))
            same = next(called, None)
            mine = same is None and kind == self.ego.type and self.ego.typed and self._ego_by(noun)
            return self.ego if mine else same  # "... my bus. Front side of bus was damaged"
        if other:
            vehicles = [e for e in candidates if not e.ego]
            single = [e for e in vehicles if e.count == 1 and "group" not in e.roles]
            itself = self._subject_of(self._governor(word)) if word.dep in ("dobj", "pobj") else None
            single = [e for e in single if e is not itself]  # "the car struck the other car"
            return None if not single else single[-1]
        if ordinal is not None and 0 < len(candidates) <= ordinal and not self.ego_named and count == 1:
            return None  # "the lead vehicle stopped. The second vehicle ..."
        if (place := self._where_said(word)) and definite:
            there = [e for e in candidates if place in self._hints(e) and e.count == 1]
            if there:
                return there[-1]
        alike = kind == "rider" or any(e.noun == noun or e.type == kind for e in candidates)
        if self._distinguished(word) and (not alike or kind in ("vehicle", "car")):
            return None
        if count > 1:
            many = [e for e in candidates if e.count > 1 and "group" not in e.roles]
            counted = any(w.norm in language.table("actors")["counts"] for w in self.words[word.i - 2 : word.i])
            many = [e for e in many if e.count == count] if counted else many
            if many:
                return many[-1]
            all_of_them = {w.norm for w in self.words[max(0, word.i - 2) : word.i]} & ALL_OF_THEM
            every = VEHICLES if noun == "vehicles" else CARS if noun == "cars" else ()
            fitting = [e for e in self.entities if e.type in every] if every else candidates
            singles = sorted((e for e in fitting if e.mentions and e.count == 1), key=lambda e: e.mentions[-1].word)
            if self.ego.mentions and noun in ("vehicles", "cars") and len(singles) == count - 1:
                singles.append(self.ego)
            if all_of_them and len(singles) >= count:
                return self._all_of(word, sorted(singles[-count:], key=lambda e: (e.ego, e.mentions[0].word)))
            return None
        scored: list[tuple[float, int, Entity]] = []
        never = kind == "vehicle" and noun in language.actor_nouns() and noun not in ANYBODY
        for entity in [
            *candidates,
            *(
                [self.ego]
                if self.ego_named and not never and (kind == "vehicle" or kind == self.ego.type and self._ego_by(noun))
                else []
            ),
        ]:
            score = entity.mentions[-1].word / 1000 if entity.mentions else 0
            score += 2 if entity.noun == noun and not (entity.ego and self._ego_besides(noun)) else 0
            score += 1.5 if entity.ego and self._ego_by(noun) else 0
            score += 1 if entity.type == kind and not entity.ego else 0
            score += 3 if entity is None else 0
            score -= 0.5 if entity.count > 1 else 0
            scored.append((score, len(scored), entity))
        if not scored and kind == self.ego.type and self.ego.typed:
            return self.ego
        return max(scored)[2] if scored else None

    def _where_said(self, word: Word) -> str:
        """Where one is by the words right behind the noun: "the car in front", "the van behind"."""
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 4] if w.sentence == word.sentence)
        told = re.match(r"(?P<ahead>in front|ahead)\b(?! of (?!ego))|(?P<following>behind)\b(?! (?!ego))", after)
        return told.lastgroup or "" if told else ""

    def _distinguished(self, word: Word) -> bool:
        """Whether the noun phrase goes on to say which one: "the car in front of it", "the van that ..."."""
        for child in word.children:
            other = self.words[child]
            aside = other.dep == "relcl" and self.words[word.i + 1].norm == ","  # "the vehicle, which ..."
            if aside and word.norm == "vehicle":
                continue
            if child > word.i and other.dep in ("prep", "acl", "relcl", "advmod") and other.norm not in ("of",):
                return True
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 4] if w.sentence == word.sentence)
        return re.match(r"(?:in front|ahead|behind)\b(?! of\b)", after) is not None

    def _hints(self, entity: Entity) -> set[str]:
        """What the words after an entity's mentions say about its place, as far as reference needs it."""
        found = set()
        for mention in entity.mentions:
            near = " ".join(
                w.norm
                for w in self.words[mention.word : mention.word + 9]
                if w.sentence == self.words[mention.word].sentence
            )
            if re.search(r"ahead|in front|slow|before it|precedes|\bleads\b|\bleading\b", near):
                found.add("ahead")
            if re.search(r"the (?:other|opposite|oncoming) (?:way|direction|lane|side)\b|towards? (?:ego|it)\b", near):
                found.add("oncoming")
            if re.match(r"\S+ (?:(?:is|was) )?(?:follow(?:s|ed|ing)|(?:close |travell?ing )?behind|trailing)\b", near):
                found.add("following")
            before = " ".join(
                w.norm
                for w in self.words[max(0, mention.word - 6) : mention.word]
                if w.sentence == self.words[mention.word].sentence
            )
            if re.search(r"behind|follow|tail|trail|ahead|in front", before):
                found.add("ahead")
        return found

    def _new(self, entity: Entity) -> Entity:
        entity.key = f"a{sum(1 for _ in self.entities) + 1}"
        while any(e.key == entity.key for e in self.entities):
            entity.key = f"a{int(entity.key[1:]) + 1}"
        self.entities.append(entity)
        return entity

    def _near(self, word: Word) -> list[str]:
        return [w.norm for w in self.words[max(0, word.i - 3) : word.i] if w.sentence == word.sentence]

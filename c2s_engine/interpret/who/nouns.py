"""Nouns that name road users and things: a new one, or one spoken of before."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import DEFINITE, MOTOR, MOVERS, ORDINALS, PERSONS, VEHICLES, ZONES, Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.absent_mentions import AbsentMentions
from c2s_engine.interpret.who.attached import Attached
from c2s_engine.interpret.who.counted import Counted
from c2s_engine.interpret.who.persons import DRIVERS, PARTIES
from c2s_engine.interpret.who.reference import BOUND, COLOURS


class Nouns(Attached, AbsentMentions, Counted):
    """The part of Cast that reads nouns."""

    def _apposed(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _copula(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _actor(self, word: Word) -> Entity | None:
        data = word.span.data  # type: ignore[union-attr]
        kind, noun, roles = data["type"], data.get("noun", ""), set(data.get("roles", ()))
        if data.get("names"):
            return self._by_name(word)
        if data.get("label"):
            roles = self._parts(word)  # "a stationary GVT"
            host = self.of.get(word.i - 2) if word.i > 1 and self.words[word.i - 1].norm == "(" else None
            for entity in self.entities:
                if entity.label == data["label"] or (roles & entity.roles - {"stationary", "parked"}):
                    entity.roles |= roles
                    return entity
            return self._new(Entity("", "vehicle", label=data["label"], roles=roles))
        if noun in language.table("actors")["riders"] and (mount := self._mount(word)) is not None:
            return mount
        if (puller := self._pulled(word, noun)) is not None:
            return puller
        before = self._modifiers(word)
        previous = self.words[word.i - 1].norm if word.i and self.words[word.i - 1].sentence == word.sentence else ""
        if previous in ("other",) and "no" in self._near(word):
            return None
        if kind == "pedestrian" and noun == "man" and previous in ("green", "red", "white"):
            return None  # of a light
        if "no" in before or previous in ("no", "without", "any", "most"):
            return None
        if previous in ("my", "our") and word.i - 1 in self.asking:
            return None  # "I was walking my dog when I saw ..."
        if (kind in ("pedestrian", "child") or noun in language.table("actors")["drivers"]) and self._rides(word):
            return None
        if kind in ("pedestrian", "child") and not data.get("plural"):
            at_wheel = self._at_wheel(word, None)
            driver = at_wheel or self._steering(word)
            driver = driver or self._drives_on(word)
            if driver is not None:
                driver.names.add(noun.split(" ")[-1])
                return driver
        if word.i in self.wheels:
            return self._retyped(self.wheels[word.i], kind, roles, noun)
        if self._is_modifier(word):
            return None
        if noun == "traffic" and (not roles):
            return None
        if {"every", "each"} & {previous, *before}:
            several = [e for e in self.entities if e.count > 1]
            if several:
                return several[-1]  # "three pupils cross ... until every child is across"
        count = self._count(word, before, data)
        if re.search(
            r"(queue|line|row|jam|tailback|column|string) of( \w+)?$", " ".join(self._near(word)[-3:])
        ) and re.search(
            r"stationary|standing|stopped|waiting|queue|jam|tailback",
            " ".join(w.norm for w in self.words[max(0, word.i - 5) : word.i]),
        ):
            roles.add("stationary")
        known = language.roles()
        roles |= {known[b] for b in before if b in known}
        host = self._copula(word)
        if (
            host is not None
            and (host.type == "vehicle" or kind in ("vehicle", host.type) or host.ego or host.label)
            and (host.mover or not MOVERS & {kind})
        ):
            return self._retyped(host, kind, roles, noun)
        host = self._called(word)
        host = self._apposed(word)
        if (
            host is None
            and word.dep == "appos"
            and word.head in self.of
            and self.of[word.head].type in ("vehicle", kind)
            and {"a", "an"} & set(before)
            and not any(w.verb and not self._tells_of(w, word.head) for w in self.words[word.head + 1 : word.i])
        ):
            host = self.of[word.head]
        bracket = word.i and any(w.norm in ("(", "--", "-", ":") for w in self.words[max(0, word.i - 4) : word.i])
        if (
            host is not None
            and (
                word.dep in ("appos", "attr")
                or bracket
                or (bool(host.label) or host.noun in PARTIES)
                and not host.typed
            )
            and self.words[word.i - 1].norm not in ("and", "or", "one")
            and (fits(host, kind) or host.type == "vehicle" or (host.ego and not self.ego.typed and kind in MOTOR))
            and not (word.dep == "conj" and not host.label and not host.ego)
            and not (word.dep == "appos" and self.of.get(word.head, host) is not host)
        ):
            return self._retyped(host, kind, roles, noun)
        host = self._driven_by(word)
        if host is not None and kind in VEHICLES:
            return self._retyped(host, kind, roles, noun)
        pronominal = self._type_of_definite(word, kind)
        definite = bool(DEFINITE & set(before)) or previous in DEFINITE or previous == "neither"
        other = bool({"other", "another"} & set(before)) or previous in ("other", "another")
        ordinal = next((ORDINALS[b] for b in before if b in ORDINALS), None)
        if definite and not other and ordinal is None and (" " not in noun):
            shade = COLOURS & set(before)
            named = [e for e in self.entities if e.noun.endswith(f" {noun}") and e.count == count]
            named = [e for e in named if not shade]
            if named:
                return named[-1]
        if not ordinal:
            for entity in self.entities:
                if (
                    (
                        entity.type == kind
                        or {entity.type, kind} <= PERSONS - {"animal"}
                        or entity.type == "vehicle"
                        and kind in MOTOR
                        and bool(roles & entity.roles)
                    )
                    and len(entity.mentions) == 1
                    and (not other)
                    and count == entity.count
                    and self._heading(self.words[entity.mentions[0].word].sentence)
                    and self.words[entity.mentions[0].word].sentence < word.sentence
                ):
                    entity.type = kind
                    entity.roles |= roles
                    return entity
        titled = self._titled(word, kind) if not other and ordinal is None and count == 1 else None
        if titled is not None:
            return self._retyped(titled, kind, roles, noun)
        if noun == "road works" or kind in ZONES:
            for entity in self.entities:
                if entity.type == kind:
                    return entity
        if pronominal is not None:
            return pronominal
        bare = not {*before} - {","} and previous not in ("a", "an") and not data.get("plural")
        if definite or bare or (roles and not {"a", "an", "another", "second", "third"} & set(before)):
            found = self._definite(word, kind, noun, roles, other, ordinal, definite, count, bare)
            if found is None and bare and data.get("person") and not roles:
                found = next((e for e in reversed(self.entities) if fits(e, kind) and e.count == 1), None)
            if found is not None and found is not self._placed(word):
                if not found.ego and found.type == "vehicle" and kind != "vehicle" and kind in MOTOR:
                    found.type, found.typed = kind, True
                found.roles |= set() if data.get("person") and found.noun == noun else roles
                return found
        found = Entity(
            "", kind, noun=noun, count=count, roles=roles, typed=kind not in ("vehicle", "rider"), ordinal=ordinal
        )
        if count == 1:
            found.names |= (COLOURS | BOUND) & set(before)
            found.names |= set(self._near(word)) & language.makes()
        if data.get("make"):  # "a Ford Focus": "the Ford" is the same
            found.names.add(data["make"])
        return self._new(found)

    def _tells_of(self, verb: Word, noun: int) -> bool:
        """Whether a participle only says which one a noun means: "the vehicle preceding ego, a pickup, brakes"."""
        return verb.dep == "acl" and verb.head == noun and verb.tag in ("VBG", "VBN")

    def _is_modifier(self, word: Word) -> bool:
        """Whether the noun only qualifies another ("truck lane", "bus stop", "car park", "dog walker")."""
        head = self.words[word.head]
        following = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        return bool(
            word.dep in ("compound", "nmod", "amod")
            and following is not None
            and not (
                following.lemma in DRIVERS and word.span is not None and word.span.data.get("noun") in language.makes()
            )
            and following.sentence == word.sentence
            and following.norm not in language.word_list("directions")
            and (head.i == following.i or following.norm in ("lane", "stop", "park", "length", "lengths", "width"))
            and head.span is None
            and not head.verb
        )

    def _retyped(self, host: Entity, kind: str, roles: set[str], noun: str) -> Entity:
        if host.ego:
            if kind in MOTOR and kind != "vehicle":
                host.type, host.typed = kind, True
        elif (host.type == "vehicle" or not host.typed) and kind not in ("vehicle", "rider"):
            host.type, host.typed = kind, True
        host.roles |= roles
        if noun and not host.noun:
            host.noun = noun
        elif noun and not host.ego and noun != host.noun:
            host.names.add(noun)
        return host

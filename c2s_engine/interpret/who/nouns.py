"""Nouns that name road users and things: a new one, or one spoken of before."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import DEFINITE, MOTOR, MOVERS, ORDINALS, PERSONS, VEHICLES, ZONES, Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.counted import Counted
from c2s_engine.interpret.who.introduced import Introduced
from c2s_engine.interpret.who.not_there import NotThere
from c2s_engine.interpret.who.persons import DRIVERS, PARTIES
from c2s_engine.interpret.who.reference import BOUND, COLOURS

TWO_WHEELERS = language.words("two_wheelers")
THIRD = frozenset(("his", "her", "its", "their"))
AUTHORITIES = language.words("authorities")
RIDES = frozenset(("ride", "rides", "rode", "riding", "ridden"))


class Nouns(Introduced, NotThere, Counted):
    """The part of Cast that reads nouns."""

    def _apposed(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _aboard_label(self, word: Word, kind: str) -> Entity | None:
        raise NotImplementedError

    def _copula(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _set_off(self, word: Word) -> bool:
        raise NotImplementedError

    def _actor(self, word: Word) -> Entity | None:
        data = word.span.data  # type: ignore[union-attr]
        kind, noun, roles = data["type"], data.get("noun", ""), set(data.get("roles", ()))
        if data.get("names"):
            return self._by_name(word)
        if data.get("label"):
            roles = self._parts(word)  # "a stationary GVT"
            host = self.of.get(word.i - 2) if word.i > 1 and self.words[word.i - 1].norm == "(" else None
            if host is not None and not host.ego and not host.label and host.mover:  # "the lead (GVT)"
                host.label = data["label"]
                return host
            for entity in self.entities:
                if entity.label == data["label"] or (roles & entity.roles - {"stationary", "parked"}):
                    entity.roles |= roles
                    return entity
            return self._new(Entity("", "vehicle", label=data["label"], roles=roles))
        if noun in TWO_WHEELERS and kind == "bicycle" and (self._motor_bike(word) or self._splits_lanes(word)):
            kind = "motorcycle"
        if noun == "scooter" and (who := self._aboard(word)) is not None and who.span.data["type"] == "child":
            kind = "bicycle"  # "a kid on a scooter"
        if (aboard := self._aboard_label(word, "rider" if noun == "rider" else kind)) is not None:
            return aboard
        if noun in language.table("actors")["riders"] and (mount := self._mount(word)) is not None:
            return mount
        if self._rider_of(word):
            return None
        if (puller := self._pulled(word, noun)) is not None:
            return puller
        before = self._modifiers(word)
        previous = self.words[word.i - 1].norm if word.i and self.words[word.i - 1].sentence == word.sentence else ""
        if previous in ("other",) and "no" in self._near(word):
            return None
        if data.get("plural") and noun in AUTHORITIES and self._reports(word):
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
            at_wheel = (
                self._driver_of(word) or self._at_wheel(word, self._owner_told(word, noun)) or self._aboard_before(word)
            )
            driver = at_wheel or self._steering(word)
            driver = driver or self._drives_on(word)
            if driver is not None:
                driver.names.add(noun.split(" ")[-1])
                return driver
        if kind == self.me.type == "pedestrian":
            return self.me  # "School patrol, 8.25. I walked out ..."
        drives = data.get("person") and (kind in MOTOR or kind == "rider" or noun.endswith("courier"))
        if drives and not data.get("plural") and self._on_foot(word):
            return self._new(Entity("", "pedestrian", noun=noun, typed=True))  # "the van driver gets out"
        if word.i in self.wheels:
            return self._retyped(self.wheels[word.i], kind, roles, noun)
        if self._is_modifier(word) or self._proper(word):
            return None
        if noun == "traffic" and (not roles and not self._halts(word) or self._watched(word)):
            return None
        if self._gone(word, before) or self._only_a_place(word, noun) or self._heads_list(word):
            return None
        if self._cab_of(word, noun) or self._all_of_a_kind(word):
            return None
        if self._writers_own(word, kind):
            return self._retyped(self.ego, kind, roles, noun)
        if {"every", "each"} & {previous, *before}:
            several = [e for e in self.entities if e.count > 1]
            if several:
                return several[-1]  # "three pupils cross ... until every child is across"
        if previous == "neither" and kind in MOTOR:
            data, noun = {**data, "plural": True}, language.plurals(noun)[0]  # "neither car brakes": of two
        count = 2 if noun == "traffic" and not roles and self._flows(word) else self._count(word, before, data)
        parties = self._parties(word, before, data, roles)
        if parties is not None:
            return parties
        if re.search(
            r"(queue|line|row|jam|tailback|column|string) of( \w+)?$", " ".join(self._near(word)[-3:])
        ) and re.search(
            r"stationary|standing|stopped|waiting|queue|jam|tailback",
            " ".join(w.norm for w in self.words[max(0, word.i - 5) : word.i]),
        ):
            roles.add("stationary")
        known = language.roles()
        roles |= {known[b] for b in (*before, *self._behind(word)) if b in known}
        host = self._copula(word)
        if (
            host is not None
            and (host.type == "vehicle" or kind in ("vehicle", host.type) or host.ego or host.label)
            and (host.mover or not MOVERS & {kind})
        ):
            return self._retyped(host, kind, roles, noun)
        first = self._alternative(word)
        if first is not None and first.type in VEHICLES | PERSONS and kind in VEHICLES | PERSONS:
            return first
        host = self._called(word)
        if host is not None:
            return self._retyped(host, kind, roles, noun)
        host = self._apposed(word)
        if (
            host is None
            and word.dep == "appos"
            and word.head in self.of
            and self.of[word.head].type in ("vehicle", kind)
            and {"a", "an"} & set(before)
            and not self._elsewhere(word)
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
                or self._set_off(word)
            )
            and self.words[word.i - 1].norm not in ("and", "or", "one")
            and (fits(host, kind) or host.type == "vehicle" or (host.ego and not self.ego.typed and kind in MOTOR))
            and not (word.dep == "conj" and not host.label and not host.ego)
            and not (word.dep == "appos" and self.of.get(word.head, host) is not host)
        ):
            return self._retyped(host, kind, roles, noun)
        host = self._driven_by(word)
        if host is not None and kind in ("motorcycle", "bicycle") and host.type in ("motorcycle", "bicycle", "rider"):
            host.type = kind
            return host
        if host is not None and kind in VEHICLES:
            return self._retyped(host, kind, roles, noun)
        pronominal = self._type_of_definite(word, before, kind)
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
                    and (not other or self._after_ego(word, entity))
                    and count == entity.count
                    and self._heading(self.words[entity.mentions[0].word].sentence)
                    and self.words[entity.mentions[0].word].sentence < word.sentence
                ):
                    entity.type = kind
                    entity.roles |= roles
                    return entity
        first_told = self._told_again(word, kind, noun, count) if not other and ordinal is None else None
        titled = self._titled(word, kind) if not other and ordinal is None and count == 1 else None
        titled = titled or (self._in_headline(word, kind) if not other and ordinal is None and count == 1 else None)
        new = {"a", "an"} & {previous, *before} and not other and ordinal is None and count == 1
        if new and titled is None and first_told is None:
            titled = None
        if (titled := titled or first_told) is not None:
            return self._retyped(titled, kind, roles, noun)
        if kind != "vehicle" and previous in ("a", "an") or {"a", "an"} & set(before):
            named = self._revealed(word, kind)
            if named is not None:
                return self._retyped(named, kind, roles, noun)
        if noun == "road works" or kind in ZONES:
            for entity in self.entities:
                if entity.type == kind:
                    return entity
        if pronominal is not None:
            return pronominal
        bare = not {*before} - {","} and previous not in ("a", "an") and not data.get("plural")
        if kind in PERSONS and self._of_a_person(word, noun):
            return self._new(Entity("", kind, noun=noun, count=count, roles=roles, typed=True))
        if noun in PARTIES and (self._other_side(noun) or self._drives_another(word)):
            kind = "pedestrian" if self._party_afoot(word) else kind
            return self._new(Entity("", kind, noun=noun, roles=roles, typed=kind in PERSONS))
        if (bare or set(before) <= {"that", ","}) and (party := self._same_party(noun)) is not None:
            return party
        if definite or bare or (roles and not {"a", "an", "another", "second", "third"} & set(before)):
            found = self._definite(word, kind, noun, roles, other, ordinal, definite, count, bare)
            if found is None and bare and data.get("person") and not roles:
                found = next((e for e in reversed(self.entities) if fits(e, kind) and e.count == 1), None)
            if found is not None and found is not self._placed(word):
                if not found.ego and found.type == "vehicle" and kind != "vehicle" and kind in MOTOR:
                    found.type, found.typed = kind, True
                found.roles |= set() if data.get("person") and found.noun == noun else roles
                return found
        if other and count == 1 and not roles and (pair := self._ego_and_another(word, kind)) is not None:
            pair.roles.add("group")
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

    def _of_a_person(self, word: Word, noun: str) -> bool:
        """Whether it is somebody's mother, friend or dog, of whom was not spoken before."""
        owners = [self.words[c] for c in word.children if self.words[c].dep == "poss"]
        person = any(w.norm in THIRD or w.i in self.of and self.of[w.i].person for w in owners)
        mine = any(w.i in self.of and self.of[w.i].ego for w in owners)
        return person and not mine and all(e.noun != noun for e in self.entities)

    def _splits_lanes(self, word: Word) -> bool:
        """Whether a bike is one that splits the lanes: a motorcycle."""
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 8] if w.sentence == word.sentence)
        return re.search(r"\b(?:split|filter)\w* (?:\w+ ){0,3}lanes?\b|\blane ?-? ?split", after) is not None

    def _motor_bike(self, word: Word) -> bool:
        """Whether "the bike" is a motorcycle spoken of before, as no bicycle was."""
        new = {"a", "an", "another"} & {self.words[c].norm for c in word.children}
        kinds = {e.type for e in self.entities} | ({self.ego.type} if self.ego.typed else set())
        return "bicycle" not in kinds and ("motorcycle" in kinds or not new and self._ridden_by_me())

    def _ridden_by_me(self) -> bool:
        """Whether the first person, who drives in the story, is said to ride: "I was riding along at 50"."""
        rides = (w for w in self.words if w.norm in RIDES and w.dep != "amod")
        subjects = (self.words[c].norm for w in rides for c in w.children if self.words[c].dep == "nsubj")
        return self.driven_by_me and not {"i", "we"}.isdisjoint(subjects)

    def _watched(self, word: Word) -> bool:
        """Whether traffic is only looked at or checked for."""
        above = self.words[word.head]
        verb = self.words[above.head] if above.dep == "prep" else above
        return word.dep in ("pobj", "dobj") and verb.lemma in ("look", "watch", "check", "monitor", "scan", "glance")

    def _proper(self, word: Word) -> bool:
        """Whether the noun is part of a name ("Van Ness", "Ford")."""
        if not word.text[:1].isupper() or word.text.isupper() or word.i + 1 >= len(self.words) or word.i == 0:
            return False
        if self._house(word):
            return True
        before, after = self.words[word.i - 1], self.words[word.i + 1]
        return (
            before.sentence == word.sentence
            and after.text[:1].isupper()
            and not after.text.isupper()
            and after.span is None
            and before.norm not in (".", ":", ";", "a", "the", "(", "an")
        )

    def _is_modifier(self, word: Word) -> bool:
        """Whether the noun only qualifies another ("truck lane", "bus stop", "car park", "dog walker")."""
        head = self.words[word.head]
        following = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        if following is not None and self._carried(word, following):
            return True
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

"""Third stage: who is meant. Mentions of ego and of the others become entities, over sentences."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import (
    DEFINITE,
    MOTOR,
    MOVERS,
    ORDINALS,
    PERSONS,
    VEHICLES,
    ZONES,
    Entity,
    Mention,
    fits,
)
from c2s_engine.interpret.pronouns import Pronouns
from c2s_engine.interpret.syntax import Word

__all__ = [
    "DEFINITE",
    "MOTOR",
    "MOVERS",
    "ORDINALS",
    "PERSONS",
    "VEHICLES",
    "ZONES",
    "Cast",
    "Entity",
    "Mention",
    "fits",
]


class Cast(Pronouns):
    """The entities of a text, and who each word means."""

    def __init__(self, words: list[Word]) -> None:
        self.words = words
        self.ego = Entity("ego", "car")
        self.entities: list[Entity] = []
        self.of: dict[int, Entity] = {}
        self.both: dict[int, list[Entity]] = {}
        self.subjects: list[tuple[int, Entity]] = []  # grammatical subjects so far: (word, entity)
        self.strong_ego = any(w.span and w.span.kind == "ego" for w in words)
        self.ego_named = self.strong_ego or any(
            w.span and w.span.kind == "label" and w.span.data["label"] == "1" for w in words
        )
        self.one_is_ego = self._label_is_ego()
        self._resolve()

    # -- building ------------------------------------------------------------------------------------------------
    def _resolve(self) -> None:
        done: set[int] = set()
        for word in self.words:
            if word.i in done:
                continue
            span = word.span
            entity = None
            if span and span.kind in ("ego", "label", "actor"):
                if word.i + 1 < len(self.words) and self.words[word.i + 1].span is span and word.norm == "the":
                    continue
                entity = self._named(word)
            else:
                entity = self._pronoun(word)
            if entity is not None:
                self.of[word.i] = entity
                entity.mentions.append(Mention(word.i, word.start, word.end, kind=span.kind if span else "pronoun"))
                if word.dep in ("nsubj", "nsubjpass") or self._fronted(word):
                    self.subjects.append((word.i, entity))

    def _fronted(self, word: Word) -> bool:
        return word.dep == "ROOT" and not word.tag.startswith("VB")

    def _named(self, word: Word) -> Entity | None:
        span = word.span
        assert span is not None
        if span.kind == "ego":
            self._ego_type(word)
            named = self._copula(word) or self._which_is(word)
            after = self.words[word.i + 1].norm if word.i + 1 < len(self.words) else ""
            near = named is not None and any(0 < word.i - m.word <= 6 for m in named.mentions)
            if (
                named is not None
                and near
                and not named.ego
                and named.mover
                and len(named.mentions) <= 2
                and after not in ("'s", "'")
            ):
                self._become_ego(named)
            return self.ego
        if span.kind == "label":
            return self._labelled(word)
        return self._actor(word)

    def _ego_type(self, word: Word) -> None:
        for kind in ("truck", "van", "bus", "motorcycle"):
            if re.search(rf"\b{kind}\b", word.norm):
                self.ego.type, self.ego.typed = kind, True

    def _label_is_ego(self) -> bool:
        """Whether number 1 is ego although ego has another name: "V1, the subject vehicle"."""
        if not self.strong_ego:
            return True
        text = " ".join(
            "@one"
            if w.span and w.span.kind == "label" and w.span.data["label"] == "1"
            else "@ego"
            if w.span and w.span.kind == "ego"
            else w.norm
            for w in self.words
        )
        return bool(re.search(r"@one (,|\(|is|was|being|, which is) (the )?@ego|@ego (,|\(|is|was) ?\(? ?@one", text))

    def _labelled(self, word: Word) -> Entity | None:
        data = word.span.data  # type: ignore[union-attr]
        label = data["label"]
        if label == "1" and self.one_is_ego:
            host = self._apposed(word)
            if host and not host.ego and len(host.mentions) == 1:
                self._become_ego(host)
            return self.ego
        for entity in self.entities:
            if entity.label == label:
                return entity
        host = self._apposed(word)
        if host is None and word.i and self.words[word.i - 1].norm == "(":
            near = [
                i
                for i in sorted(self.of)
                if i < word.i
                and self.words[i].sentence == word.sentence
                and not self.of[i].ego
                and not self.of[i].label
            ]
            host = self.of[near[-1]] if near else None
        if host and not host.ego and not host.label:
            host.label = label
            return host
        kind = language.actor_nouns()[data["word"]][0] if " " in label else "vehicle"
        return self._new(
            Entity("", kind, noun=data["word"] if " " in label else "", label=label, typed=kind != "vehicle")
        )

    def _become_ego(self, entity: Entity) -> None:
        if entity.type != "vehicle":
            self.ego.type, self.ego.typed = entity.type, True
        for mention in entity.mentions:
            self.of[mention.word] = self.ego
        self.ego.mentions += entity.mentions
        self.entities.remove(entity)
        self.subjects = [(i, self.ego if e is entity else e) for i, e in self.subjects]

    def _apposed(self, word: Word) -> Entity | None:
        """The entity that a label or noun stands beside: "a car (V2)", "V2, a car", "V2 was a truck"."""
        before = [w for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence]
        gap: list[str] = []
        for other in reversed(before):
            if other.i in self.of:
                text = re.sub(
                    r"^(ahead|in front|behind|alongside|ahead of it|in front of it) ", "", " ".join(reversed(gap))
                )
                if re.fullmatch(
                    r"(\(|,|, which (is|was)|:|-+|, (driven|operated) by)?( ?(the|a|an|another|called|designated|labelled|labeled|as|known as|i\.e\.|ie|namely))?( [\w-]+){0,2}",
                    text,
                ) and (gap and gap[-1] in ("(", ",", "-", "--", ":") or not gap):
                    if (
                        gap
                        and gap[-1] == ","
                        and not re.search(r"\b(a|an|the|called|as)\b", text)
                        and word.dep != "appos"
                    ):
                        return None
                    return self.of[other.i]
                return None
            gap.append(other.norm)
        return None

    def _copula(self, word: Word) -> Entity | None:
        """The subject of "X is/was a truck"."""
        head = self.words[word.head]
        if word.dep == "attr" and head.lemma == "be":
            for child in head.children:
                if (
                    self.words[child].dep == "nsubj"
                    and child in self.of
                    and child < word.i
                    and self.words[child].norm not in ("it", "they")
                ):
                    return self.of[child]
                if self.words[child].dep == "nsubj" and child < word.i:
                    return None
        return None

    def _which_is(self, word: Word) -> Entity | None:
        """The one of whom it is said "which is our ego"."""
        back = [w for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence]
        text = " ".join("@" if w.i in self.of and w.span is not None else w.norm for w in back)
        if re.search(r"@ ?,? (which|that|who) (is|was) (our |the |my )?$", text + " "):
            return next((self.of[w.i] for w in reversed(back) if w.i in self.of and w.span is not None), None)
        return None

    def _modifiers(self, word: Word) -> list[str]:
        found = []
        for i in range(max(0, word.i - 5), word.i):
            other = self.words[i]
            if other.sentence == word.sentence and (
                i in word.children
                or other.head in word.children
                and other.i < word.i
                and other.tag in ("RB", "CD", "JJ", "DT", "PDT")
            ):
                found.append(other.norm)
        return found

    def _actor(self, word: Word) -> Entity | None:
        data = word.span.data  # type: ignore[union-attr]
        kind, noun, roles = data["type"], data.get("noun", ""), set(data.get("roles", ()))
        if data.get("label"):
            for entity in self.entities:
                if entity.label == data["label"] or (roles & entity.roles):
                    return entity
            return self._new(Entity("", "vehicle", label=data["label"], roles=roles))
        before = self._modifiers(word)
        previous = self.words[word.i - 1].norm if word.i and self.words[word.i - 1].sentence == word.sentence else ""
        if previous in ("other",) and "no" in self._near(word):
            return None
        if "no" in before or previous in ("no", "without", "any"):
            return None
        if kind in ("pedestrian", "child") and self._rides(word):
            return None
        if self._is_modifier(word) or noun == "traffic" and not roles or self._proper(word):
            return None
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
        after = self.words[word.i + 1].norm if word.i + 1 < len(self.words) else ""
        host = self._copula(word)
        if (
            host is not None
            and (host.type == "vehicle" or kind in ("vehicle", host.type) or host.ego or host.label)
            and (host.mover or not MOVERS & {kind})
        ):
            return self._retyped(host, kind, roles, noun)
        host = self._apposed(word)
        if (
            host is None
            and word.dep == "appos"
            and word.head in self.of
            and self.of[word.head].type in ("vehicle", kind)
            and {"a", "an"} & set(before)
        ):
            host = self.of[word.head]
        if (
            host is None
            and word.dep == "nsubj"
            and {"a", "an"} & set(before)
            and word.i + 1 < len(self.words)
            and self.words[word.i + 1].norm == ","
        ):
            twins = [
                c
                for c in self.words[word.head].children
                if c < word.i and self.words[c].dep == "nsubj" and c in self.of and not self.of[c].ego
            ]
            if twins and self.of[twins[-1]].type in ("vehicle", kind):
                return self._retyped(self.of[twins[-1]], kind, roles, noun)
        bracket = word.i and any(w.norm in ("(", "--", "-", ":") for w in self.words[max(0, word.i - 4) : word.i])
        if (
            host is not None
            and (word.dep in ("appos", "attr") or bracket or (bool(host.label) and not host.typed))
            and self.words[word.i - 1].norm not in ("and", "or")
            and (fits(host, kind) or host.type == "vehicle" or (host.ego and not self.ego.typed and kind in MOTOR))
            and not (word.dep == "conj" and not host.label and not host.ego)
        ):
            return self._retyped(host, kind, roles, noun)
        host = self._driven_by(word)
        if host is not None and kind in VEHICLES:
            return self._retyped(host, kind, roles, noun)
        pronominal = self._type_of_definite(word, before, kind)
        definite = bool(DEFINITE & set(before)) or previous in DEFINITE
        other = bool({"other", "another"} & set(before)) or previous in ("other", "another")
        ordinal = next((ORDINALS[b] for b in before if b in ORDINALS), None)
        if definite and not other and ordinal is None and " " not in noun:
            named = [e for e in self.entities if e.noun.endswith(f" {noun}") and e.count == count]
            if named:
                return named[-1]
        if not other and not ordinal:
            for entity in self.entities:
                if (
                    entity.type == kind
                    and len(entity.mentions) == 1
                    and count == entity.count
                    and self._heading(self.words[entity.mentions[0].word].sentence)
                    and self.words[entity.mentions[0].word].sentence < word.sentence
                ):
                    return entity
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
        bare = not before and previous not in ("a", "an") and not data.get("plural")
        if definite or bare or (roles and not {"a", "an", "another", "second", "third"} & set(before)):
            found = self._definite(word, kind, noun, roles, other, ordinal, definite, count, bare)
            if found is not None:
                if not found.ego and found.type == "vehicle" and kind != "vehicle" and kind in MOTOR:
                    found.type, found.typed = kind, True
                found.roles |= roles
                return found
        return self._new(
            Entity("", kind, noun=noun, count=count, roles=roles, typed=kind != "vehicle", ordinal=ordinal)
        )

    def _driven_by(self, word: Word) -> Entity | None:
        """Whose vehicle it is in "the defendant, operating a dump truck": the driver and the vehicle are one."""
        back = [w for w in self.words[max(0, word.i - 7) : word.i] if w.sentence == word.sentence]
        text = " ".join("@" if w.i in self.of and w.span is not None else w.norm for w in back)
        match = re.search(
            r"@( ?,)?( ?\(?who (was|is|were))? (operating|driving|riding|at the wheel of|in charge of|in|on) (an?|his|her|the|their)( [\w-]+){0,2} $",
            text + " ",
        )
        if match is None:
            return None
        owner = next(self.of[w.i] for w in reversed(back) if w.i in self.of and w.span is not None)
        if match[4] in ("in", "on") and not re.search(r"driver|motorist|party|defendant|respondent|rider", owner.noun):
            return None
        return owner if owner.type in ("vehicle", "rider") or owner.ego else None

    def _heading(self, sentence: int) -> bool:
        """Whether a sentence is a title: without a finite verb."""
        return not any(w.sentence == sentence and w.tag in ("VBZ", "VBD", "VBP", "MD") for w in self.words)

    def _revealed(self, word: Word, kind: str) -> Entity | None:
        """The bare label that a colon explains: "V3 came into view: a disabled car"."""
        sentence = [w for w in self.words[: word.i] if w.sentence == word.sentence]
        if not any(w.norm == ":" for w in sentence[-4:]):
            return None
        labels = [
            self.of[w.i]
            for w in sentence
            if w.i in self.of and self.of[w.i].label and self.of[w.i].type == "vehicle" and not self.of[w.i].ego
        ]
        return labels[-1] if labels and kind in MOTOR else None

    def _near(self, word: Word) -> list[str]:
        return [w.norm for w in self.words[max(0, word.i - 3) : word.i] if w.sentence == word.sentence]

    def _rides(self, word: Word) -> bool:
        """Whether a person is only the one inside a vehicle ("a man in a white van"), who stands for it."""
        following = [w for w in self.words[word.i + 1 : word.i + 6] if w.sentence == word.sentence]
        if not following or following[0].norm not in ("in", "on", "driving", "riding"):
            return False
        for other in following[1:]:
            if other.span is not None:
                return (
                    other.span.kind == "actor"
                    and other.span.data["type"] in VEHICLES - {"vehicle"}
                    and not other.span.data.get("person")
                )
            if other.tag in ("NN", "NNS", "IN") or other.verb:
                return False
        return False

    def _proper(self, word: Word) -> bool:
        """Whether the noun is part of a name ("Van Ness", "Ford")."""
        if not word.text[:1].isupper() or word.text.isupper() or word.i + 1 >= len(self.words) or word.i == 0:
            return False
        before, after = self.words[word.i - 1], self.words[word.i + 1]
        return (
            before.sentence == word.sentence
            and after.text[:1].isupper()
            and not after.text.isupper()
            and after.span is None
            and before.norm not in (".", ":", ";", "a", "the", "(", "an")
        )

    def _is_modifier(self, word: Word) -> bool:
        """Whether the noun only qualifies another ("truck lane", "bus stop", "bicycle lane", "car park", "dog walker")."""
        head = self.words[word.head]
        following = self.words[word.i + 1] if word.i + 1 < len(self.words) else None
        return bool(
            word.dep in ("compound", "nmod", "amod")
            and following is not None
            and following.sentence == word.sentence
            and following.norm not in ("level", "side", "abreast", "alongside", "following", "facing")
            and (head.i == following.i or following.norm in ("lane", "stop", "park", "length", "lengths", "width"))
            and head.span is None
            and not head.verb
        )

    def _count(self, word: Word, before: list[str], data: dict) -> int:
        counts = language.table("actors")["counts"]
        if not data.get("plural"):
            return 1
        for text in [*before, *self._near(word)]:
            if text.isdigit() and 1 <= int(text) <= 8:
                return int(text)
            if text in counts:
                return int(counts[text])
        return 2

    def _retyped(self, host: Entity, kind: str, roles: set[str], noun: str) -> Entity:
        if host.ego:
            if kind in MOTOR and kind != "vehicle":
                host.type, host.typed = kind, True
        elif (host.type == "vehicle" or not host.typed) and kind != "vehicle":
            host.type, host.typed = kind, True
        host.roles |= roles
        if noun and not host.noun:
            host.noun = noun
        return host

    def _type_of_definite(self, word: Word, before: list[str], kind: str) -> Entity | None:
        for child in word.children:
            if (
                self.words[child].tag == "PRP$"
                and child in self.of
                and self.of[child].ego
                and kind in VEHICLES
                and word.span is not None
                and not word.span.data.get("words")
            ):
                return self.ego
        if before and before[0] in ("our", "my"):
            return self.ego if kind in VEHICLES else None
        return None

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
        candidates = [e for e in self.entities if fits(e, kind)]
        if roles:
            same = [e for e in candidates if e.roles & roles]
            if same:
                return same[-1]
            if roles & {"lead"}:
                ahead = [e for e in candidates if "ahead" in self._hints(e)]
                if ahead:
                    return ahead[-1]
            if not definite and roles & {"stationary", "parked", "slow", "turning", "fast"}:
                return None
            if roles & {"oncoming", "crossing", "lead", "following", "cut_in", "adjacent"} or not candidates:
                if roles & {"following"} and not self.ego_named and kind == "vehicle":
                    return None
                return None
        if kind == "vehicle" and noun == "vehicle" and not self.ego_named and not bare and not other:
            generic = [e for e in candidates if e.noun == "vehicle"]
            plain = [e for e in candidates if e.noun != "vehicle" and not e.roles]
            if not generic and (len(candidates) != 1 or not plain):
                return None
        if bare and not roles and self._distinguished(word):
            return None
        if bare and not roles:
            return next((e for e in reversed(candidates) if e.noun == noun), None)
        if other:
            vehicles = [e for e in candidates if not e.ego]
            group = [e for e in vehicles if e.count == 2]
            if group and self.ego_named and len(vehicles) == 1 and count == 1:
                group[0].roles.add("group")
                return None
            single = [e for e in vehicles if e.count == 1 and "group" not in e.roles]
            return single[-1] if single else None
        if ordinal is not None and len(candidates) > 1 and ordinal < len(candidates):
            return candidates[ordinal]
        if self._distinguished(word) and not any(e.noun == noun or e.type == kind for e in candidates):
            return None
        if self._distinguished(word) and kind in ("vehicle", "car") and not self._matching_relation(word, candidates):
            return None if candidates or self._relative_to_ego(word) else None
        if count > 1:
            many = [e for e in candidates if e.count > 1]
            if many:
                return many[-1]
            return None
        scored = []
        never = noun in (
            "target",
            "adversary",
            "opponent",
            "challenger",
            "npc",
            "pov",
            "principal other vehicle",
            "challenging vehicle",
            "target vehicle",
            "vehicle target",
            "traffic",
        )
        for entity in [
            *candidates,
            *(
                [self.ego]
                if self.ego_named and not never and (kind == "vehicle" or kind == self.ego.type and self._ego_by(noun))
                else []
            ),
        ]:
            score = entity.mentions[-1].word / 1000 if entity.mentions else 0
            score += 2 if entity.noun == noun else 0
            score += 1.5 if entity.ego and self._ego_by(noun) else 0
            score += 1 if entity.type == kind and not entity.ego else 0
            score -= 0.5 if entity.count > 1 else 0
            scored.append((score, id(entity), entity))
        if not scored and kind == self.ego.type and self.ego.typed:
            return self.ego
        return max(scored)[2] if scored else None

    def _ego_by(self, noun: str) -> bool:
        """Whether ego was called by that noun ("the DCAS vehicle" makes "the vehicle" ego)."""
        return any(
            noun and self.words[m.word].norm.split(" ")[-1].split("-")[-1] == noun for m in self.ego.mentions
        ) or (noun == "vehicle" and self.strong_ego and not any(e.type == "vehicle" for e in self.entities))

    def _distinguished(self, word: Word) -> bool:
        """Whether the noun phrase goes on to say which one: "the car in front of it", "the van that ..."."""
        for child in word.children:
            other = self.words[child]
            if child > word.i and other.dep in ("prep", "acl", "relcl", "advmod") and other.norm not in ("of",):
                return True
        return False

    def _relative_to_ego(self, word: Word) -> bool:
        return True

    def _matching_relation(self, word: Word, candidates: list[Entity]) -> bool:
        text = " ".join(w.norm for w in self.words[word.i : word.i + 8] if w.sentence == word.sentence)
        ahead = re.search(r"ahead|in front", text)
        return any(ahead and "ahead" in self._hints(e) for e in candidates)

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

"""Whom something happens to, who else takes part, and who is meant where nobody is named."""

from __future__ import annotations

import re

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.rendering import CLAUSAL, Rendering
from c2s_engine.interpret.who.mentions import Cast, Entity

OFF_ROAD = re.compile(
    r"parked|parking|lay-?by|driveway|bus stop|(?:on|in|at) the (?:\w+ ){0,2}(?:shoulder|verge|emergency lane)"
)


class Patients(Rendering):
    """The part of Clauses that finds the other parties of a verb or noun."""

    cast: Cast
    events: list[Event]
    words: list[Word]

    def _inherited(self, word: Word, depth: int) -> tuple[Entity | None, int | None, bool]:
        raise NotImplementedError

    def _subject(self, word: Word, depth: int = 0) -> tuple[Entity | None, int | None, bool]:
        raise NotImplementedError

    def _everything(self, i: int) -> list[int]:
        """All words below a word, in order."""
        found = [i]
        for child in self.words[i].children:
            found += self._everything(child)
        return sorted(found)

    def _also(self, at: int | None, verb: int) -> list[Entity]:
        """The others of a joint subject ("V1 and V3 met"), but not who is joined behind the verb."""
        if at is None:
            return []
        found = list(self.cast.both.get(at, []))  # "both", "the two"
        for child in self.words[at].children:
            listed = self.words[child].dep == "conj" or self._listed(at, child)
            other = self.cast.referent(child) if listed and not at < verb < child else None
            if other is not None:
                found.append(other)
                found += self._also(child, verb)
        return found

    def _listed(self, at: int, child: int) -> bool:
        """Whether an apposition is another of a list: "a motorbike, a van and a lorry"."""
        goes_on = any(self.words[c].dep == "conj" for c in self.words[child].children)
        return self.words[child].dep == "appos" and goes_on and self.cast.referent(child) is not self.cast.referent(at)

    def _of_both(self, own: list[int]) -> bool:
        """Whether one of those words means ego and another ("both")."""
        return any(self.cast.ego in (self.cast.of.get(i), *self.cast.both[i]) for i in own if i in self.cast.both)

    def _patient(self, word: Word, own: list[int], agent: Entity | None, passive: bool) -> Entity | None:
        if passive:
            for child in word.children:
                if self.words[child].dep == "nsubjpass":
                    found = self.cast.referent(child)
                    if found is not None and found is not agent:
                        return found
            if word.dep in ("acl", "relcl"):
                found = self.cast.referent(word.head)
                if found is not None and found is not agent:
                    return found
            own_subject = any(self.words[c].dep == "nsubjpass" for c in word.children)
            inherited = None if own_subject else self._inherited(word, 0)[0]
            if inherited is not None and inherited is not agent:
                return inherited
        direct = [c for c in word.children if self.words[c].dep in ("dobj", "dative", "oprd")]
        for child in direct:
            found = self.cast.referent(child)
            if found is not None and found is not agent:
                return found
        for child in direct:
            if self.words[child].tag in ("WDT", "WP"):
                continue
            for i in self._below(child):
                found = self.cast.of.get(i)
                if found is not None and found is not agent:
                    return found
        if word.dep == "relcl" and any(self.words[c].dep in ("nsubj",) for c in word.children):
            head = self.cast.of.get(word.head)
            if head is not None and head is not agent:
                return head
        for i in own:
            if (
                i > word.i
                and i in self.cast.of
                and self.cast.of[i] is not agent
                and (self.cast.of[i].mover or self.cast.of[i].type not in ("construction_zone",))
            ):
                return self.cast.of[i]
        for child in word.children:
            if (
                self.words[child].dep in ("ccomp", "advcl")
                and self._is_verb(self.words[child])
                and word.lemma in ("let", "allow", "wait", "permit", "lets")
            ):
                found = self._subject(self.words[child])[0]
                if found is not None and found is not agent:
                    return found
        return None

    def _below(self, i: int) -> list[int]:
        found = [i]
        for child in self.words[i].children:
            if self.words[child].dep not in CLAUSAL:
                found += self._below(child)
        return sorted(found)

    def _default_agent(self, word: Word, act: str) -> Entity | None:
        """An imperative, or a passive without an agent: what is asked for is asked of ego."""
        subjects = [c for c in word.children if self.words[c].dep in ("nsubj", "nsubjpass")]
        if subjects and self.words[subjects[0]].lemma not in (
            "braking",
            "brake",
            "brakes",
            "manoeuvre",
            "maneuver",
            "movement",
            "speed",
            "turn",
            "turning",
            "driver",
            "system",
            "response",
            "pedal",
            "merging",
            "crossing",
        ):
            return None
        if not subjects and word.dep not in ("ROOT", "conj", "csubj", "xcomp", "advcl", "ccomp", "pcomp"):
            return None
        if act in (
            "brake",
            "stop",
            "brake_stop",
            "turn",
            "lane_change",
            "overtake",
            "yield",
            "keep_lane",
            "follow",
            "go_straight",
            "reverse",
            "u_turn",
            "swerve",
            "accelerate",
            "evade",
            "start",
        ):
            return self.cast.ego
        return None

    def _up_to_next(self, i: int, many: int) -> list[Word]:
        """The words from a mention on, up to the next one who is spoken of."""
        found = [self.words[i]]
        for word in self.words[i + 1 : i + many]:
            other = self.cast.of.get(word.i)
            if other is not None and other is not self.cast.of.get(i):
                break
            found.append(word)
        return found

    def _at_rest(self, actor: Entity) -> bool:
        """Whether one is said to stand."""
        stands = any(e.agent is actor and e.act in ("stationary", "reverse") for e in self.events)
        return stands or bool(actor.roles & {"parked", "stationary"})

    def _was_off_road(self, actor: Entity) -> bool:
        if "parked" in actor.roles:
            return True
        near = " ".join(w.norm for m in actor.mentions for w in self._up_to_next(m.word, 8))
        if OFF_ROAD.search(near):
            return True
        return any(
            e.agent is actor and re.search(r"park|kerb|curb|driveway|shoulder|bay|lay-by|side of the road", e.whole)
            for e in self.events
        )

    def _noun_agent(self, word: Word, verb: Word | None) -> tuple[Entity | None, Entity | None]:
        patient = None
        for child in word.children:
            other = self.words[child]
            if other.dep == "poss" or other.tag == "PRP$":
                return self.cast.referent(child), None
            if other.dep in ("prep", "agent") and other.norm in ("of", "by", "from"):
                for target in other.children:
                    found = self.cast.referent(target)
                    if found:
                        return found, None
            if other.dep == "prep" and other.norm in ("with", "between"):
                for target in other.children:
                    patient = patient or self.cast.referent(target)
        for i in range(word.i - 1, max(-1, word.i - 4), -1):
            other = self.words[i]
            if (
                other.sentence != word.sentence
                or other.norm in (",", ";", ".", ":")
                or other.verb
                and other.dep != "amod"
            ):
                break
        if verb is not None:
            agent, at, passive = self._subject(verb)
            answered = self._lemma(verb) in ("respond", "react", "answer") and self.words[word.head].norm == "to"
            if (
                agent is not None
                and not passive
                and not answered
                and self._lemma(verb)
                in (
                    "make",
                    "perform",
                    "execute",
                    "do",
                    "begin",
                    "start",
                    "initiate",
                    "carry",
                    "take",
                    "undertake",
                    "complete",
                    "attempt",
                    "apply",
                    "have",
                    "be",
                    "need",
                    "require",
                    "respond",
                    "react",
                    "manage",
                    "come",
                    "go",
                    "answer",
                    "result",
                    "end",
                    "use",
                )
            ):
                return agent, patient
        return None, patient

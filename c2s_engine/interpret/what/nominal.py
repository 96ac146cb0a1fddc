"""Events that nouns and participles tell: a sudden deceleration, a swerving van."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import rules
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.timing import Timing
from c2s_engine.interpret.who.mentions import Entity

ATTRIBUTIVE = frozenset(
    ("brake", "stop", "accelerate", "reverse", "swerve", "lose_control", "drift", "u_turn", "cross_road", "overtake")
)

HAPPENS = frozenset(("occur", "happen", "result", "ensue", "take", "follow", "come", "be", "arise", "involve"))
OTHERS = frozenset(("cut_in", "cut_out", "lane_change", "brake", "stop"))
STANDS = language.words("stands")
HALTS = frozenset(("stop", "brake", "brake_stop", "stationary"))


class Nominal(Timing):
    """The part of Clauses that reads nouns of motion and verbs before nouns."""

    def _attributive(self, word: Word) -> None:
        """A verb that stands before the noun of its agent: "a decelerating lead vehicle", "the swerving van"."""
        agent = self.cast.of.get(word.head)
        if (
            agent is None
            or not word.norm.endswith("ing")
            or word.span is not None
            or word.dep not in ("amod", "compound")
            or word.head < word.i
            or any(e.agent is agent and e.word > word.i and e.word in self.by_word for e in self.events)
            and agent.ego
        ):
            return
        lemma = self._lemma(word)
        text = f"{lemma} " + " ".join(w.norm for w in self.words[word.i + 1 : word.head])
        event = self._event(lemma, word, text, text, agent, None)
        if (
            event is None
            or event.act not in ATTRIBUTIVE
            or any(e.act == event.act and e.agent is agent for e in self.events)
        ):
            return
        before = self.words[word.i - 1].norm if word.i else ""
        event.hard = event.hard or before in ("hard", "suddenly", "sharply", "abruptly", "heavily", "strongly")
        event.words, event.start, event.end = [word.i], word.start, word.end
        self.by_word[word.i] = event


    def _named_by_deed(self, word: Word) -> None:
        """What the name of a road user tells of it: "an overtaking truck" overtakes ego."""
        agent = self.cast.of.get(word.i)
        named = word.span is not None and word.norm.startswith("overtaking ")
        if (
            not named
            or agent is None
            or agent.ego
            or any(e.act == "overtake" and e.agent is agent for e in self.events)
        ):
            return
        self.events.append(Event(
            "overtake", agent, word.i, "overtake", "overtake", self.cast.ego, order=float(word.i),
            start=word.start, end=word.end, words=[word.i],
        ))  # fmt: skip

    def _striking(self, word: Word) -> None:
        """A participle of contact taken for an adjective of whom it hits: "did not slow down, striking V1"."""
        patient = self.cast.of.get(word.head)
        comma = word.i > 0 and self.words[word.i - 1].norm == ","
        if patient is None or not comma or word.tag != "VBG" or word.dep not in ("amod", "compound"):
            return
        verb = self._governor(self.words[word.head])
        agent = self._subject(verb)[0] if verb is not None else None
        own = [w.i for w in self.words[word.i :] if w.sentence == word.sentence]
        text = self.render(own, word.i)
        if agent is None or agent is patient:
            return
        event = self._event(self._lemma(word), word, text, text, agent, patient)
        if event is None or event.act != "collide":
            return
        event.words, event.start, event.end = [word.i], word.start, word.end
        self.by_word[word.i] = event

    def _struck_each_other(self, word: Word, verb: Word | None) -> tuple[Entity, Entity] | None:
        """Who strikes whom in a collision "between" two: the one named first, unless its rear or side is told of."""
        heads = [word, verb] if verb is not None and self._lemma(verb) in HAPPENS else [word]
        between = [c for w in heads for c in w.children if self.words[c].norm in ("between", "involving", "of")]
        for at in between:
            inside = self._below(at)
            told = list(dict.fromkeys(self.cast.of[i] for i in inside if i in self.cast.of and self.cast.of[i].mover))
            if len(told) != 2:
                continue
            return (told[0], told[1])
        return None

    def _noun(self, word: Word) -> None:
        if word.i in self.by_word or word.span is not None:
            return
        window = [w.i for w in self.words[max(0, word.i - 5) : word.i + 4] if w.sentence == word.sentence]
        for rule, nouns, patterns in rules("nouns"):
            if word.norm not in nouns and word.lemma not in nouns:
                continue
            near = " ".join(self.words[i].norm for i in window)
            if (
                "any" in patterns
                and not patterns["any"].search(near)
                or "not" in patterns
                and patterns["not"].search(near)
            ):
                continue
            verb = self._governor(word)
            if verb is not None and verb.i in self.by_word and self.by_word[verb.i].act == rule["act"]:
                return
            if word.dep in ("compound", "amod", "nmod") and self.words[word.head].norm not in (
                "manoeuvre",
                "maneuver",
                "movement",
            ):
                return
            agent, patient = self._noun_agent(word, verb)
            if rule["act"] == "collide" and (parties := self._struck_each_other(word, verb)) is not None:
                agent, patient = parties
            if patient is agent:
                patient = None
            if agent is None and rule["act"] in OTHERS:
                agent = None
            if agent is None:
                if rule["act"] == "collide":
                    others = [self.cast.of[i] for i in sorted(self.cast.of) if i < word.i and not self.cast.of[i].ego]
                    patient = patient or (others[-1] if others else None)
                elif rule["act"] not in (
                    "brake",
                    "stop",
                    "lose_control",
                    "lane_change",
                    "turn",
                    "u_turn",
                    "reverse",
                    "overtake",
                ):
                    return
                agent = agent or self.cast.ego
            moment = re.search(
                r"(until|at|before|on|upon) (the )?(moment|point|time|instant)? ?(of )?(the )?impact", near
            )
            if "agent" in rule and rule["agent"] not in agent.roles:
                continue
            mode = (
                self._mode(verb)
                if verb is not None and not moment and verb.lemma not in ("prevent", "avoid")
                else "fact"
            )
            before = " ".join(w.norm for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence)
            if re.search(
                (
                    r"(suppress\w*|prevent\w*|block(?:s|ing)?|hinder(?:s|ing)?|den(?:y|ies|ied)|forbid\w*"
                    r"|abort\w*|refrain\w*|inhibit\w*|prohibit\w*|instead) (of "
                    r"|from )?(\w+ |[\w-]+ ){0,3}$"
                ),
                before + " ",
            ):
                mode = "negated"
            if (
                any(self.words[c].norm in ("no", "not", "without") for c in word.children)
                or self.words[word.head].norm in ("without", "of")
                and "avoid" in near
            ):
                mode = "negated"
            own = sorted(set(self._below(word.i)) | (set(self.own(verb)) if verb is not None else set()))
            text = " ".join(self.words[i].norm if i not in self.cast.of else "@" + self.cast.of[i].key for i in own)
            event = Event(rule["act"], agent, word.i, text, text, patient, mode, bool(rule.get("hard")), float(word.i))
            event.words, event.start, event.end = own, word.start, word.end
            event.quantities = self._quantities(self._below(word.i))
            if (
                event.agent.ego
                and event.act == "collide"
                and (event.patient is None or any(e.act == "collide" and e.mode == "fact" for e in self.events))
            ):
                return
            self.events.append(event)
            self.by_word[word.i] = event
            return

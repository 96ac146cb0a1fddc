"""Fourth stage: what happens. Each verb (and noun) of motion becomes an event with agent, patient and circumstances."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.agents import CLAUSAL
from c2s_engine.interpret.mentions import Cast, Entity
from c2s_engine.interpret.syntax import Word
from c2s_engine.interpret.timing import Timing

PLACES = {"speed": "#speed", "distance": "#dist", "time": "#time", "acceleration": "#acc", "percent": "#percent"}


ATTRIBUTIVE = frozenset(
    ("brake", "stop", "accelerate", "reverse", "swerve", "lose_control", "drift", "u_turn", "cross_road")
)


@dataclass(eq=False)
class Event:
    """Something that an entity does, with the words that say so."""

    act: str
    agent: Entity
    word: int
    text: str  # the clause from the verb on
    whole: str  # the clause with what stands before the verb
    patient: Entity | None = None
    mode: str = "fact"  # fact, intended, negated, hypothetical, purpose
    hard: bool = False
    order: float = 0.0
    start: int = 0
    end: int = 0
    words: list[int] = field(default_factory=list)
    quantities: list[dict[str, Any]] = field(default_factory=list)
    trigger: dict[str, Any] | None = None
    side: str | None = None
    passive: bool = False
    adverbial: str = ""  # the word that joins its clause to the main one (when, after, before...)
    also: list[Entity] = field(default_factory=list)

    @property
    def done(self) -> bool:
        return self.mode in ("fact", "intended", "purpose")


@cache
def _rules(section: str) -> list[tuple[dict[str, Any], frozenset[str], dict[str, re.Pattern[str]]]]:
    found = []
    for rule in language.table("motions")[section]:
        patterns = {k: re.compile(rule[k]) for k in ("after", "any", "not") if k in rule}
        found.append((rule, frozenset(rule.get("verbs", rule.get("nouns", ()))), patterns))
    return found


@cache
def _irregular() -> dict[str, str]:
    return {
        "strike": "strike", "struck": "strike", "ran": "run", "cut": "cut", "cuts": "cut", "hit": "hit", "swung": "swing", "slid": "slide", "spun": "spin",
        "stood": "stand", "sat": "sit", "lay": "lie", "lies": "lie", "lying": "lie", "laid": "lay", "brakes": "brake", "stops": "stop", "turns": "turn", "crosses": "cross",
        "overtakes": "overtake", "rear-ends": "rear-end", "rear-ended": "rear-end", "yields": "yield", "parked": "park", "pulls": "pull", "u-turns": "turn", "cutting": "cut",
        "swerves": "swerve", "travelling": "travel", "travelled": "travel", "merges": "merge", "drifts": "drift", "skids": "skid", "accelerates": "accelerate", "decelerates": "decelerate",
        "slammed": "slam", "slams": "slam", "drove": "drive", "driven": "drive", "drives": "drive", "fell": "fall", "led": "lead", "sped": "speed", "crept": "creep", "swept": "sweep", "shot": "shoot",
        "overtaken": "overtake", "overtook": "overtake", "ridden": "ride", "rode": "ride", "went": "go", "gone": "go", "came": "come", "stuck": "stick", "threw": "throw", "shown": "show",
        "swerved": "swerve", "lost": "lose", "left": "leave", "kept": "keep", "held": "hold", "met": "meet", "made": "make", "took": "take", "taken": "take", "began": "begin", "begun": "begin", "hid": "hide", "hidden": "hide",
        "decel": "decelerate", "accel": "accelerate", "oncoming": "oncome", "t-boned": "t-bone", "sideswiped": "sideswipe", "stationary": "stand",
    }  # fmt: skip


class Clauses(Timing):
    """The events of a text."""

    def __init__(self, words: list[Word], cast: Cast) -> None:
        self.words, self.cast = words, cast
        self.events: list[Event] = []
        self.by_word: dict[int, Event] = {}
        self.light: set[int] = set()
        for word in words:
            if self._is_verb(word):
                self._verb(word)
        for word in words:
            if word.tag.startswith("NN") or word.tag == "VBG":
                self._noun(word)
        for word in words:
            self._attributive(word)
        self._order()
        self._triggers()
        self.events.sort(key=lambda e: e.order)

    def fragment(self, i: int) -> bool:
        """Whether a road user heads a sentence without a verb: "SUV, right lane, 15 m ahead"."""
        word = self.words[i]
        if word.span is None or word.span.kind not in ("actor", "label") or word.dep in ("pobj", "poss"):
            return False
        sentence = [w for w in self.words if w.sentence == word.sentence]
        first = next((w.i for w in sentence if w.i in self.cast.of and w.span is not None), None)
        return first == i and not any(w.i in self.by_word or w.tag in ("VBZ", "VBD", "VBP", "MD") for w in sentence)

    def about(self, i: int) -> list[int]:
        """The words of a fragment from its head up to the next road user of its own."""
        found: list[int] = []
        for word in self.words[i + 1 :]:
            other = self.cast.of.get(word.i)
            if (
                word.sentence != self.words[i].sentence
                or other is not None
                and not other.ego
                and word.dep not in ("pobj", "poss")
            ):
                break
            found.append(word.i)
        return found

    # -- verbs ---------------------------------------------------------------------------------------------------
    def _is_verb(self, word: Word) -> bool:
        if word.span is not None or word.dep in ("aux", "auxpass") or word.tag == "MD":
            return False
        if word.norm in ("slow", "near", "clear") and word.tag != "VB":
            return False
        if word.norm == "slow" and not any(self.words[c].dep in ("aux", "prt", "advmod") for c in word.children):
            return False
        if word.tag.startswith("VB"):
            return not (word.dep in ("amod", "compound") and word.tag in ("VBG", "VBN"))
        if (
            word.dep in ("ROOT", "conj", "ccomp", "advcl", "relcl", "acl")
            and word.tag in ("NNS", "NN", "JJ", "NNP", "NNPS", "IN", "RB")
            and self._lemma(word) in VERB_LEMMAS()
        ):
            return word.norm != self._lemma(word) or word.tag not in ("NN", "JJ") or word.dep == "ROOT"
        return False

    def _lemma(self, word: Word) -> str:
        known = _irregular().get(word.norm)
        if known:
            return known
        lemma = word.lemma
        if lemma in VERB_LEMMAS():
            return lemma
        for ending, replacement in (
            ("ies", "y"),
            ("es", "e"),
            ("es", ""),
            ("s", ""),
            ("ing", ""),
            ("ing", "e"),
            ("ed", ""),
            ("ed", "e"),
            ("d", ""),
        ):
            if word.norm.endswith(ending) and word.norm[: -len(ending)] + replacement in VERB_LEMMAS():
                return word.norm[: -len(ending)] + replacement
        for ending in ("ing", "ed"):
            stem = word.norm[: -len(ending)]
            if word.norm.endswith(ending) and len(stem) > 2 and stem[-1] == stem[-2] and stem[:-1] in VERB_LEMMAS():
                return stem[:-1]
        return lemma

    def own(self, word: Word) -> list[int]:
        """The words of a verb's clause, without the clauses inside it."""
        found = [word.i]
        stack = list(word.children)
        while stack:
            i = stack.pop()
            other = self.words[i]
            if other.dep in CLAUSAL and (self._is_verb(other)) or (other.dep == "conj" and self._is_verb(other)):
                continue
            found.append(i)
            stack += other.children
        return sorted(found)

    def render(self, indices: list[int], verb: int | None = None) -> str:
        """Words as patterns see them: lemmas of verbs, @names of road users, #kinds of quantities."""
        parts: list[str] = []
        for i in indices:
            word = self.words[i]
            if i == verb:
                parts.append(self._lemma(word))
            elif word.span and word.span.kind == "quantity":
                mark = PLACES[word.span.data["dimension"]]
                if not parts or parts[-1] != mark:
                    parts.append(mark)
            elif i in self.cast.of:
                parts.append("@" + self.cast.of[i].key + (" 's" if word.tag == "PRP$" else ""))
            elif (word.tag.startswith("VB") and word.dep not in ("amod", "compound")) or word.tag == "MD":
                parts.append(self._lemma(word))
            else:
                parts.append(word.norm)
        return " ".join(parts)

    def _verb(self, word: Word) -> None:
        lemma = self._lemma(word)
        own = self.own(word)
        after = [i for i in own if i >= word.i]
        text, whole = self.render(after, word.i), self.render(own, word.i)
        shades = language.table("motions")["modality"]
        complements = [
            c
            for c in word.children
            if c > word.i and self.words[c].dep in ("xcomp", "ccomp") and self._is_verb(self.words[c])
        ]
        if lemma in ("let", "allow", "wait", "permit") and complements:
            text = f"{text} {self.render(self.own(self.words[complements[0]]))}"
        if lemma == "wait" and (
            later := [
                c
                for c in word.children
                if self.words[c].dep == "advcl" and self._mark(self.words[c]) in ("until", "till")
            ]
        ):
            text = f"wait until {self.render(self.own(self.words[later[0]]))}"
        if lemma == "be":
            complements = [c for c in complements if self.words[c].dep == "xcomp"]
        if (
            complements
            and lemma in (*shades["light"], *shades["intended"], *shades["failed"])
            and not re.search(r"^(stop|start|be|see|observe|detect|ensure|decide|remain) .*@", text)
        ) and lemma not in ("let", "allow", "permit", "wait"):
            self.light.add(word.i)
            return
        agent, at, passive = self._subject(word)
        if agent is None and word.tag.startswith("NN"):
            agent = next((self.cast.of[c] for c in word.children if c < word.i and c in self.cast.of), None)
        if (
            agent is None
            and word.dep == "conj"
            and word.head in self.by_word
            and not any(self.words[c].dep in ("nsubj", "nsubjpass") for c in word.children)
        ):
            head = self.words[word.head]
            above = (
                self._governor(head)
                if head.tag == "VB" and head.dep in ("ccomp", "xcomp") and word.tag in ("VBZ", "VBD")
                else None
            )
            agent = (
                self.by_word[above.i].agent
                if above is not None and above.i in self.by_word
                else self.by_word[word.head].agent
            )
        if (
            agent is None
            and word.tag == "VBG"
            and word.dep in ("advcl", "pcomp", "xcomp")
            and word.head in self.by_word
            and word.head < word.i
        ):
            agent = self.by_word[word.head].agent
        if agent is None:
            agent = self.topic(word)
        if agent is None:
            agent = self._nearest(word, at) or (self._continued(word) if at is None else None)
        patient = self._patient(word, own, agent, passive)
        event = self._event(lemma, word, text, whole, agent, patient)
        if event is None:
            return
        if event.act == "start_straight":
            event.act = "start"
            then = Event(
                "go_straight",
                event.agent,
                word.i,
                text,
                whole,
                order=word.i + 0.1,
                mode=self._mode(word),
                words=[word.i],
            )
            self.events.append(then)
        if event.act in ("brake", "brake_stop", "stop") and not event.hard:
            following = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 5] if w.sentence == word.sentence)
            event.hard = bool(
                re.match(
                    r"((very|quite|rather|so|pretty|really) )?(hard|harder|sharply|abruptly|heavily|strongly|violently)\b",
                    following,
                )
            )
        event.words, event.mode, event.passive = own, self._mode(word), passive
        if (
            event.act == "stop"
            and passive
            and lemma != "bring"
            and event.agent is agent
            and not re.search(r"\bby @", whole)
        ):
            event.act = "stationary"
        if (
            event.act == "follow"
            and passive
            and event.agent is agent
            and not event.agent.ego
            and not re.search(r"\bby @", whole)
        ):
            event.agent, event.patient = self.cast.ego, agent
        late: Event | None = None
        into = (
            re.search(
                r"into (the |a |an )?(side|rear|back|front|rear end|path)? ?(of )?(the |a |an )?@(\w+)(?! 's (lane|path|way|view))\b",
                text,
            )
            if event.act in ("run_red", "run_stop", "lose_control", "oncoming", "swerve", "drift", "leave_road")
            else None
        )
        if into and into[2] != "path":
            struck = next((e for e in (self.cast.ego, *self.cast.entities) if e.key == into[5]), None)
            if (
                struck is not None
                and struck is not event.agent
                and not re.search(rf"into (the )?(lane|path) of (the )?@{into[5]}|@{into[5]} 's", text)
            ):
                late = Event(
                    "collide",
                    event.agent,
                    word.i,
                    text,
                    whole,
                    struck,
                    order=word.i + 0.2,
                    mode=event.mode,
                    words=[word.i],
                    start=word.start,
                    end=word.end,
                )
        if event.act == "collide" and lemma in ("reverse", "back"):
            self.events.append(
                Event(
                    "reverse",
                    event.agent,
                    word.i,
                    text,
                    whole,
                    order=word.i - 0.1,
                    mode=event.mode,
                    words=[word.i],
                    start=word.start,
                    end=word.end,
                    adverbial=self._mark(word),
                )
            )
        event.start, event.end = self.words[own[0]].start, self.words[own[-1]].end
        event.quantities = self._quantities(own)
        if word.dep in ("advcl", "relcl", "pcomp", "ccomp") or word.dep == "conj":
            event.adverbial = self._mark(word)
        event.also = self._also(at)
        self.events.append(event)
        if late is not None:
            late.adverbial = event.adverbial
            self.events.append(late)
        self.by_word[word.i] = event

    def _event(
        self, lemma: str, word: Word, text: str, whole: str, agent: Entity | None, patient: Entity | None
    ) -> Event | None:
        said, said_whole = text, whole
        if agent is not None:
            text, whole = (re.sub(rf"@{agent.key} 's\b", "its", t) for t in (text, whole))
        for rule, lemmas, patterns in _rules("verbs"):
            if lemma not in lemmas:
                continue
            if "after" in patterns and not patterns["after"].search(text):
                continue
            if "any" in patterns and not patterns["any"].search(whole):
                continue
            if "not" in patterns and patterns["not"].search(whole if rule["act"] != "reverse" else text):
                continue
            actor = patient if rule.get("swap") else agent
            if rule["act"] in ("none", "stop_none"):
                return None
            if rule.get("swap_passive"):
                if patient is None and agent is not None and not agent.ego:
                    patient, agent = agent, None
                if patient is None or not re.search(r"past|pass|through|by|go", whole + text):
                    continue
                actor = agent if agent is not None and agent is not patient else self.cast.ego
            if actor is None:
                actor = self._default_agent(word, rule["act"])
                if actor is None:
                    return None
                if rule["act"] == "collide":
                    others = [
                        self.cast.of[i]
                        for i in sorted(self.cast.of)
                        if i < word.i and not self.cast.of[i].ego and self.cast.of[i].mover
                    ]
                    patient = patient or (others[-1] if others else None)
            if not self._agrees(rule, actor):
                continue
            if (
                rule["act"] == "cross_road"
                and actor.type == "bicycle"
                and re.search(
                    r"straight|(over|through|across) (the|an) (\w+ )?(junction|intersection|crossroads)|(?<!pedestrian )crossing(?! the)",
                    text,
                )
            ):
                continue
            if (
                rule.get("target") == "ego"
                and actor.ego
                or rule.get("of") == "ego_lane"
                and (actor.ego and not re.search(r"@a\d", text))
            ):
                continue
            if rule.get("of") == "parked" and not self._was_off_road(actor):
                continue
            return Event(
                rule["act"],
                actor,
                word.i,
                said,
                said_whole,
                patient if not rule.get("swap") else None,
                hard=bool(rule.get("hard")),
                order=float(word.i),
                side=rule.get("side"),
            )
        return None

    @staticmethod
    def _agrees(rule: dict[str, Any], actor: Entity) -> bool:
        who = rule.get("who")
        if who == "person":
            return (
                actor.person
                or actor.type == "bicycle"
                and rule["act"] == "cross_road"
                or actor.type in ("bicycle",)
                and rule["act"] == "move_along"
            )
        if who == "vehicle":
            return not actor.person and (actor.mover or actor.ego)
        return True

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
        self.events.append(event)
        self.by_word[word.i] = event

    # -- nouns ---------------------------------------------------------------------------------------------------
    def _noun(self, word: Word) -> None:
        if word.i in self.by_word or word.span is not None:
            return
        window = [w.i for w in self.words[max(0, word.i - 5) : word.i + 4] if w.sentence == word.sentence]
        for rule, nouns, patterns in _rules("nouns"):
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
            if (
                word.dep in ("compound", "amod", "nmod")
                and self.words[word.head].tag.startswith("NN")
                and self.words[word.head].norm not in ("manoeuvre", "maneuver", "movement")
            ):
                return
            agent, patient = self._noun_agent(word, verb)
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
                agent = self.cast.ego
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
                r"(suppress\w*|prevent\w*|abort\w*|refrain\w*|inhibit\w*|prohibit\w*|instead) (of |from )?(\w+ |[\w-]+ ){0,3}$",
                before + " ",
            ):
                mode = "negated"
            if (
                any(self.words[c].norm in ("no", "not", "without") for c in word.children)
                or self.words[word.head].norm in ("without", "of")
                and "avoid" in near
            ):
                mode = "negated"
            if word.dep == "conj" and any(self.words[c].norm == "or" for c in self.words[word.head].children):
                mode = "alternative"
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


@cache
def VERB_LEMMAS() -> frozenset[str]:  # noqa: N802
    return frozenset(v for rule in language.table("motions")["verbs"] for v in rule["verbs"])

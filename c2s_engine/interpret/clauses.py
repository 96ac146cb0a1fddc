"""Fourth stage: what happens. Each verb (and noun) of motion becomes an event with agent, patient and circumstances."""

import re
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.mentions import Cast, Entity
from c2s_engine.interpret.syntax import Word

CLAUSAL = frozenset(("advcl", "relcl", "ccomp", "acl", "csubj", "csubjpass", "parataxis", "pcomp", "xcomp"))
CONTACT = frozenset(("hit", "strike", "collide", "crash", "rear-end", "run"))
PLACES = {"speed": "#speed", "distance": "#dist", "time": "#time", "acceleration": "#acc", "percent": "#percent"}


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


class Clauses:
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
        self._order()
        self._triggers()
        self.events.sort(key=lambda e: e.order)

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
        if word.dep in ("ROOT", "conj", "ccomp", "advcl", "relcl", "acl") and word.tag in ("NNS", "NN", "JJ", "NNP", "NNPS", "IN", "RB") and self._lemma(word) in VERB_LEMMAS():
            return word.norm != self._lemma(word) or word.tag not in ("NN", "JJ") or word.dep == "ROOT"
        return False

    def _lemma(self, word: Word) -> str:
        known = _irregular().get(word.norm)
        if known:
            return known
        lemma = word.lemma
        if lemma in VERB_LEMMAS():
            return lemma
        for ending, replacement in (("ies", "y"), ("es", "e"), ("es", ""), ("s", ""), ("ing", ""), ("ing", "e"), ("ed", ""), ("ed", "e"), ("d", "")):
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
        stack = [c for c in word.children]
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

    def _subject(self, word: Word, depth: int = 0) -> tuple[Entity | None, int | None, bool]:
        """(agent, its word, whether the verb is passive)."""
        passive = any(self.words[c].dep in ("auxpass",) for c in word.children) or any(self.words[c].dep == "nsubjpass" for c in word.children)
        subjects = [c for c in word.children if self.words[c].dep in ("nsubj", "nsubjpass", "csubj")]
        subjects.sort(key=lambda c: (c > word.i, -c))
        if passive:
            for child in word.children:
                if self.words[child].dep == "agent" or self.words[child].norm == "by" and self.words[child].dep == "prep":
                    for target in self.words[child].children:
                        found = self.cast.referent(target)
                        if found:
                            return found, target, True
            target = next((self.cast.referent(c) for c in subjects), None)
            if target is None:
                target = self._inherited(word, depth)[0]
            return (None, None, True) if target is None else (target, subjects[0] if subjects else None, True)
        for child in subjects:
            other = self.words[child]
            found = self.cast.referent(child)
            if found:
                return found, child, False
            if other.lemma in ("there",) or other.dep == "expl":
                continue
            return None, child, False
        if any(self.words[c].dep == "expl" for c in word.children):
            for child in word.children:
                if self.words[child].dep in ("attr", "dobj"):
                    return self.cast.referent(child), child, False
        return self._inherited(word, depth)

    def _inherited(self, word: Word, depth: int) -> tuple[Entity | None, int | None, bool]:
        head = self.words[word.head]
        if head.i == word.i and depth <= 6:
            inverted = self._inverted(word)
            if inverted[0] is not None:
                return inverted
            for child in word.children:
                if child < word.i and self.words[child].dep == "ccomp" and self._is_verb(self.words[child]) and any(self.words[c].dep == "nsubj" for c in self.words[child].children):
                    return self._subject(self.words[child], depth + 1)
            return None, None, False
        if depth > 6:
            return self._inverted(word)
        if word.dep in ("acl", "relcl"):
            found = self.cast.referent(head.i)
            if found is not None:
                if word.tag == "VBN" and word.dep == "acl":
                    for child in word.children:
                        if self.words[child].dep == "agent":
                            for target in self.words[child].children:
                                actor = self.cast.referent(target)
                                if actor:
                                    return actor, target, True
                return found, head.i, word.dep == "acl" and word.tag == "VBN"
            if word.dep == "acl" and head.tag.startswith("NN"):
                above = self._governor(head)
                if above is not None and above.i != word.i and word.tag in ("VB", "VBG"):
                    return self._subject(above, depth + 1)
            return None, head.i, False
        if word.dep == "xcomp" or word.dep == "ccomp":
            for child in head.children:
                other = self.words[child]
                if other.dep in ("dobj",) and child < word.i:
                    found = self.cast.referent(child)
                    if found:
                        return found, child, False
            if head.verb:
                agent, at, passive = self._subject(head, depth + 1)
                if passive and head.verb:
                    subjects = [c for c in head.children if self.words[c].dep == "nsubjpass"]
                    if subjects and self.cast.referent(subjects[0]):
                        return self.cast.referent(subjects[0]), subjects[0], False
                return agent, at, False
        if word.dep in ("pcomp", "advcl", "conj", "parataxis", "dep", "csubj", "prep", "amod", "appos", "punct"):
            above = head if head.verb or self._is_verb(head) else self._governor(head)
            if word.dep == "conj" and above is not None and word.tag in ("VBZ", "VBD", "VBP"):
                comma = self.words[word.i - 1].norm == ","
                if above.tag == "VB" and above.dep in ("ccomp", "xcomp") or above.dep == "advcl" and comma and not any(self.words[c].dep == "cc" and above.i < c < word.i for c in above.children):
                    above = self._governor(above) or above
            if above is not None and above.i != word.i:
                if word.dep == "csubj":
                    found = next((self.cast.referent(c) for c in above.children if self.words[c].dep in ("attr", "nsubj") and c > word.i), None)
                    if found is not None:
                        return found, above.i, False
                if word.dep == "csubj" and not any(self.words[c].dep in ("nsubj", "attr") for c in above.children):
                    return self._inverted(word)
                inverted = self._inverted(word) if word.dep in ("conj",) and word.tag in ("VBZ", "VBD") and word.i > above.i else (None, None, False)
                if inverted[0] is not None:
                    return inverted
                agent, at, passive = self._subject(above, depth + 1)
                if passive:
                    target = [c for c in above.children if self.words[c].dep == "nsubjpass"]
                    if target and self.cast.referent(target[0]):
                        return self.cast.referent(target[0]), target[0], False
                return agent, at, False
        return self._inverted(word)

    def _inverted(self, word: Word) -> tuple[Entity | None, int | None, bool]:
        """ "Up from behind comes a motorcyclist"; "standing in the lane is a car"."""
        for child in word.children:
            other = self.words[child]
            if child > word.i and other.dep in ("attr", "nsubj", "dobj") and self._lemma(word) in ("come", "be", "stand", "lie", "sit", "follow", "appear", "emerge", "approach", "drive", "ride", "run", "walk", "go"):
                found = self.cast.referent(child)
                if found and (self._lemma(word) not in ("approach", "follow", "drive", "ride") or any(c < word.i for c in word.children)):
                    return found, child, False
        head = self.words[word.head]
        if word.dep in ("csubj", "advcl") and head.i != word.i:
            for child in head.children:
                if self.words[child].dep in ("attr", "nsubj") and child > word.i:
                    found = self.cast.referent(child)
                    if found:
                        return found, child, False
        return None, None, False

    def _governor(self, word: Word) -> Word | None:
        current = word
        while current.head != current.i:
            current = self.words[current.head]
            if current.verb or self._is_verb(current):
                return current
        return None

    def _mode(self, word: Word) -> str:
        """Whether it is said to happen."""
        mode = "fact"
        shades = language.table("motions")["modality"]
        for child in word.children:
            other = self.words[child]
            if other.dep == "neg" or other.norm in ("never", "neither", "nor", "hardly", "cannot", "not"):
                if other.norm == "not" and child > word.i and other.dep != "neg":
                    continue
                mode = "negated"
            if other.dep == "aux" and other.norm in ("would", "could", "might"):
                mode = "hypothetical"
            if other.dep == "mark" and other.norm in ("if", "unless", "whether", "lest") and not self._criterion(word):
                mode = "hypothetical"
            if other.dep in ("nsubj", "nsubjpass") and (other.norm in ("none", "neither", "nobody", "nothing") or any(self.words[c].norm in ("no", "neither") for c in other.children)):
                mode = "negated"
            if other.dep in ("nsubj",) and other.norm == "driver" and False:
                mode = "negated"
        head = self.words[word.head]
        if word.dep == "pcomp" and head.norm in ("without", "of") and (head.norm == "without" or self.words[head.head].norm in ("instead", "rather")):
            return "negated"
        if word.dep in ("xcomp", "ccomp", "advcl", "acl", "conj", "pcomp", "relcl") and head.i != word.i:
            lemma = head.lemma
            if word.dep in ("pcomp", "prep"):
                lemma = self.words[head.head].lemma
            to = any(self.words[c].norm == "to" and self.words[c].dep == "aux" for c in word.children)
            if word.dep in ("xcomp", "ccomp", "pcomp", "advcl") and lemma in ("fail", "forget", "neglect", "refuse", "omit", "unable", "avoid", "prevent", "refrain", "decline", "impossible", "inability", "keep") and (lemma != "keep" or word.dep == "pcomp"):
                return "negated" if mode != "negated" else "fact"
            if word.dep in ("xcomp", "advcl", "acl") and lemma in shades["intended"] and (to or lemma == "about"):
                mode = "intended" if mode == "fact" else mode
                if self._mode(head) in ("negated", "hypothetical") and head.verb:
                    mode = "negated"
            elif word.dep == "xcomp" and head.verb and self._is_verb(head):
                above = self._mode(head)
                if above in ("negated", "hypothetical") and mode == "fact":
                    mode = above
                elif above in ("negated",) and mode == "negated":
                    mode = "fact"
            elif word.dep == "advcl" and to and mode == "fact":
                so_not = any(self.words[c].norm in ("not",) for c in word.children)
                mode = "negated" if so_not else "purpose"
            elif word.dep == "conj" and head.verb:
                above = self._mode(head)
                own_subject = any(self.words[c].dep in ("nsubj", "nsubjpass", "aux") for c in word.children)
                if above in ("hypothetical", "negated", "purpose") and not own_subject and word.tag in ("VB", "VBN") and self._lemma(word) not in CONTACT:
                    mode = above
                if above == "intended" and not own_subject and word.tag == "VB":
                    mode = above
            elif word.dep == "pcomp" and self.words[head.head].lemma in ("instead", "rather"):
                mode = "negated"
        if word.dep in ("advcl",) and self.words[word.i - 1].norm in ("than",):
            mode = "negated"
        if word.dep == "csubj" and head.verb and self._mode(head) in ("negated", "hypothetical"):
            mode = self._mode(head)
        if word.dep == "pcomp" and (noun := self.words[head.head]).tag.startswith("NN") and any(self.words[c].norm == "no" for c in noun.children):
            mode = "negated"
        if word.dep == "conj" and mode in ("fact", "intended") and any(self.words[c].norm == "or" and c < word.i for c in head.children) and self._mode(head) != "negated":
            mode = "alternative"
        before = [w.norm for w in self.words[max(0, word.i - 3) : word.i] if w.sentence == word.sentence]
        if before[-2:] in (["rather", "than"], ["instead", "of"]) or before[-1:] == ["nor"] or before[-1:] == ["without"]:
            mode = "negated"
        return mode

    def _criterion(self, word: Word) -> bool:
        """Whether an if-clause states what a test demands: "passed if the system brakes"."""
        return self.words[word.head].lemma in ("pass", "succeed", "accept", "fulfil", "satisfy", "meet", "deem", "consider", "successful", "fulfill")

    def _verb(self, word: Word) -> None:
        lemma = self._lemma(word)
        own = self.own(word)
        after = [i for i in own if i >= word.i]
        text, whole = self.render(after, word.i), self.render(own, word.i)
        shades = language.table("motions")["modality"]
        complements = [c for c in word.children if c > word.i and self.words[c].dep in ("xcomp", "ccomp") and self._is_verb(self.words[c])]
        if lemma in ("let", "allow", "wait", "permit") and complements:
            text = f"{text} {self.render(self.own(self.words[complements[0]]))}"
        if lemma == "wait" and (later := [c for c in word.children if self.words[c].dep == "advcl" and self._mark(self.words[c]) in ("until", "till")]):
            text = f"wait until {self.render(self.own(self.words[later[0]]))}"
        if lemma == "be":
            complements = [c for c in complements if self.words[c].dep == "xcomp"]
        if complements and lemma in (*shades["light"], *shades["intended"], *shades["failed"]) and not re.search(r"^(stop|start|be|see|observe|detect|ensure|decide|remain) .*@", text):
            if lemma not in ("let", "allow", "permit", "wait"):
                self.light.add(word.i)
                return
        agent, at, passive = self._subject(word)
        if agent is None and word.dep == "conj" and word.head in self.by_word and not any(self.words[c].dep in ("nsubj", "nsubjpass") for c in word.children):
            head = self.words[word.head]
            above = self._governor(head) if head.tag == "VB" and head.dep in ("ccomp", "xcomp") and word.tag in ("VBZ", "VBD") else None
            agent = self.by_word[above.i].agent if above is not None and above.i in self.by_word else self.by_word[word.head].agent
        if agent is None:
            agent = self.topic(word)
        if agent is None:
            agent = self._nearest(word, at)
        patient = self._patient(word, own, agent, passive)
        event = self._event(lemma, word, text, whole, agent, patient)
        if event is None:
            return
        if event.act == "start_straight":
            event.act = "start"
            then = Event("go_straight", event.agent, word.i, text, whole, order=word.i + 0.1, mode=self._mode(word), words=[word.i])
            self.events.append(then)
        event.words, event.mode, event.passive = own, self._mode(word), passive
        if event.act == "stop" and passive and event.agent is agent and not re.search(r"\bby @", whole):
            event.act = "stationary"
        late: Event | None = None
        into = re.search(r"into (the |a |an )?(side|rear|back|front|rear end|path)? ?(of )?(the |a |an )?@(\w+)(?! 's (lane|path|way|view))\b", text) if event.act in ("run_red", "run_stop", "lose_control", "oncoming", "swerve", "drift", "leave_road") else None
        if into and into[2] != "path":
            struck = next((e for e in (self.cast.ego, *self.cast.entities) if e.key == into[5]), None)
            if struck is not None and struck is not event.agent and not re.search(rf"into (the )?(lane|path) of (the )?@{into[5]}|@{into[5]} 's", text):
                late = Event("collide", event.agent, word.i, text, whole, struck, order=word.i + 0.2, mode=event.mode, words=[word.i], start=word.start, end=word.end)
        if event.act == "collide" and lemma in ("reverse", "back"):
            self.events.append(Event("reverse", event.agent, word.i, text, whole, order=word.i - 0.1, mode=event.mode, words=[word.i], start=word.start, end=word.end, adverbial=self._mark(word)))
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

    def topic(self, word: Word) -> Entity | None:
        """The one that a sentence is headed with: "Challenger: left lane, 90 km/h, cuts in"."""
        sentence = [w for w in self.words[max(0, word.i - 60) : word.i] if w.sentence == word.sentence]
        for first, second in zip(sentence, sentence[1:], strict=False):
            if second.norm == ":" and first.i in self.cast.of and first.span is not None:
                return self.cast.of[first.i]
        return None

    def _nearest(self, word: Word, at: int | None) -> Entity | None:
        """The nearest noun before the verb that no preposition governs, where the tree gives no agent."""
        if any(self.words[c].dep in ("nsubj", "nsubjpass") and not self.words[c].span and self.words[c].norm not in ("traffic", "one", "which", "that", "who") for c in word.children) and at is not None:
            return None
        if word.tag not in ("VBZ", "VBD", "VBP"):
            return None
        for i in range(word.i - 1, max(-1, word.i - 16), -1):
            other = self.words[i]
            if other.sentence != word.sentence or other.norm in (";", ":"):
                return None
            if i in self.cast.of and other.dep not in ("pobj", "poss", "dobj") and other.tag != "PRP$":
                return self.cast.of[i]
        return None

    def _also(self, at: int | None) -> list[Entity]:
        """The others of a joint subject ("V1 and V3 met")."""
        if at is None:
            return []
        found = []
        for child in self.words[at].children:
            if self.words[child].dep == "conj":
                other = self.cast.referent(child)
                if other is not None:
                    found.append(other)
                    found += self._also(child)
        return found

    def _mark(self, word: Word) -> str:
        for child in sorted(word.children):
            other = self.words[child]
            if child < word.i and (other.dep == "mark" or other.norm in ("when", "while", "as", "after", "before", "until", "once", "where", "till")):
                return other.norm
        head = self.words[word.head]
        if word.dep == "pcomp":
            return head.norm
        first = [w for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence and w.norm in ("as", "once")]
        return "as" if first and word.dep == "advcl" else ""

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
            inherited = self._inherited(word, 0)[0]
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
            if i > word.i and i in self.cast.of and self.cast.of[i] is not agent and (self.cast.of[i].mover or self.cast.of[i].type not in ("construction_zone",)):
                return self.cast.of[i]
        for child in word.children:
            if self.words[child].dep in ("ccomp", "advcl") and self._is_verb(self.words[child]) and word.lemma in ("let", "allow", "wait", "permit", "lets"):
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

    def _event(self, lemma: str, word: Word, text: str, whole: str, agent: Entity | None, patient: Entity | None) -> Event | None:
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
                    others = [self.cast.of[i] for i in sorted(self.cast.of) if i < word.i and not self.cast.of[i].ego and self.cast.of[i].mover]
                    patient = patient or (others[-1] if others else None)
            if not self._agrees(rule, actor):
                continue
            if rule["act"] == "cross_road" and actor.type == "bicycle" and re.search(r"straight|(over|through|across) (the|an) (\w+ )?(junction|intersection|crossroads)|(?<!pedestrian )crossing(?! the)", text):
                continue
            if rule.get("target") == "ego" and actor.ego or rule.get("of") == "ego_lane" and (actor.ego and not re.search(r"@a\d", text)):
                continue
            if rule.get("of") == "parked" and not self._was_off_road(actor):
                continue
            return Event(rule["act"], actor, word.i, text, whole, patient if not rule.get("swap") else None, hard=bool(rule.get("hard")), order=float(word.i), side=rule.get("side"))
        return None

    def _default_agent(self, word: Word, act: str) -> Entity | None:
        """An imperative, or a passive without an agent: what is asked for is asked of ego."""
        subjects = [c for c in word.children if self.words[c].dep in ("nsubj", "nsubjpass")]
        if subjects and act == "collide" and self.words[subjects[0]].norm in ("two", "both", "they", "vehicles", "cars", "all"):
            return self.cast.ego
        if subjects and self.words[subjects[0]].lemma not in ("braking", "brake", "brakes", "manoeuvre", "maneuver", "movement", "speed", "turn", "turning", "driver", "system", "response", "pedal", "merging", "crossing"):
            return None
        if not subjects and word.dep not in ("ROOT", "conj", "csubj", "xcomp", "advcl", "ccomp", "pcomp"):
            return None
        if act == "follow" and word.tag == "VBN":
            return None
        if act in ("brake", "stop", "brake_stop", "turn", "lane_change", "overtake", "yield", "keep_lane", "follow", "go_straight", "reverse", "u_turn", "swerve", "accelerate", "evade", "start"):
            return self.cast.ego
        return None

    def _was_off_road(self, actor: Entity) -> bool:
        if "parked" in actor.roles:
            return True
        near = " ".join(w.norm for m in actor.mentions for w in self.words[m.word : m.word + 8])
        if re.search(r"parked|parking|lay-?by|driveway|bus stop", near):
            return True
        return any(e.agent is actor and re.search(r"park|kerb|curb|driveway|shoulder|bay|lay-by|side of the road", e.whole) for e in self.events)

    @staticmethod
    def _agrees(rule: dict[str, Any], actor: Entity) -> bool:
        who = rule.get("who")
        if who == "person":
            return actor.person or actor.type == "bicycle" and rule["act"] == "cross_road" or actor.type in ("bicycle",) and rule["act"] == "move_along"
        if who == "vehicle":
            return not actor.person and (actor.mover or actor.ego)
        return True

    # -- nouns ---------------------------------------------------------------------------------------------------
    def _noun(self, word: Word) -> None:
        if word.i in self.by_word or word.span is not None:
            return
        window = [w.i for w in self.words[max(0, word.i - 5) : word.i + 4] if w.sentence == word.sentence]
        for rule, nouns, patterns in _rules("nouns"):
            if word.norm not in nouns and word.lemma not in nouns:
                continue
            near = " ".join(self.words[i].norm for i in window)
            if "any" in patterns and not patterns["any"].search(near) or "not" in patterns and patterns["not"].search(near):
                continue
            verb = self._governor(word)
            if verb is not None and verb.i in self.by_word and self.by_word[verb.i].act == rule["act"]:
                return
            if word.dep in ("compound", "amod", "nmod") and self.words[word.head].tag.startswith("NN") and self.words[word.head].norm not in ("manoeuvre", "maneuver", "movement"):
                return
            agent, patient = self._noun_agent(word, verb)
            if agent is None:
                if rule["act"] == "collide":
                    others = [self.cast.of[i] for i in sorted(self.cast.of) if i < word.i and not self.cast.of[i].ego]
                    patient = patient or (others[-1] if others else None)
                elif rule["act"] not in ("brake", "stop", "lose_control", "lane_change", "turn", "u_turn", "reverse", "overtake"):
                    return
                agent = self.cast.ego
            moment = re.search(r"(until|at|before|on|upon) (the )?(moment|point|time|instant)? ?(of )?(the )?impact", near)
            mode = self._mode(verb) if verb is not None and not moment and verb.lemma not in ("prevent", "avoid") else "fact"
            before = " ".join(w.norm for w in self.words[max(0, word.i - 6) : word.i] if w.sentence == word.sentence)
            if re.search(r"(suppress\w*|prevent\w*|abort\w*|refrain\w*|inhibit\w*|prohibit\w*|instead) (of |from )?(\w+ |[\w-]+ ){0,3}$", before + " "):
                mode = "negated"
            if any(self.words[c].norm in ("no", "not", "without") for c in word.children) or self.words[word.head].norm in ("without", "of") and "avoid" in near:
                mode = "negated"
            if word.dep == "conj" and any(self.words[c].norm == "or" for c in self.words[word.head].children):
                mode = "alternative"
            own = sorted(set(self._below(word.i)) | ({i for i in self.own(verb)} if verb is not None else set()))
            text = " ".join(self.words[i].norm if i not in self.cast.of else "@" + self.cast.of[i].key for i in own)
            event = Event(rule["act"], agent, word.i, text, text, patient, mode, bool(rule.get("hard")), float(word.i))
            event.words, event.start, event.end = own, word.start, word.end
            event.quantities = self._quantities(self._below(word.i))
            if event.agent.ego and event.act == "collide" and (event.patient is None or any(e.act == "collide" and e.mode == "fact" for e in self.events)):
                return
            self.events.append(event)
            self.by_word[word.i] = event
            return

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
            if other.dep == "compound" and child in self.cast.of:
                return self.cast.of[child], None
        for i in range(word.i - 1, max(-1, word.i - 4), -1):
            other = self.words[i]
            if other.sentence != word.sentence or other.norm in (",", ";", ".", ":") or other.verb and other.dep != "amod":
                break
            if i in self.cast.of and other.span is not None and other.dep not in ("pobj",):
                return self.cast.of[i], patient
        if verb is not None:
            agent, at, passive = self._subject(verb)
            if agent is not None and not passive and self._lemma(verb) in ("make", "perform", "execute", "do", "begin", "start", "initiate", "carry", "take", "undertake", "complete", "attempt", "apply", "have", "be", "need", "require", "respond", "react", "manage", "come", "go", "answer", "result", "end", "use"):
                return agent, patient
        return None, patient

    # -- circumstances -------------------------------------------------------------------------------------------
    def _quantities(self, indices: list[int]) -> list[dict[str, Any]]:
        found = []
        seen: set[int] = set()
        for i in indices:
            span = self.words[i].span
            if span is not None and span.kind == "quantity" and id(span) not in seen:
                seen.add(id(span))
                found.append({**span.data, "start": span.start, "end": span.end, "word": i})
        return found

    def _order(self) -> None:
        for event in self.events:
            word = self.words[event.word]
            main = self._main(word)
            if main is None:
                continue
            mark = event.adverbial
            if mark in ("after", "once", "when", "as", "having") and event.word > main.word:
                event.order = main.order - 0.4
            elif mark == "before" and event.word < main.word:
                event.order = main.order + 0.4
            elif mark in ("until", "till") and event.word > main.word:
                event.order = main.order + 0.2
            elif self.words[event.word].tag == "VBN" and any(self.words[c].norm in ("had", "having") for c in word.children) and event.word > main.word:
                event.order = main.order - 0.4

    def _main(self, word: Word) -> Event | None:
        current = word
        for _ in range(4):
            if current.head == current.i:
                return None
            current = self.words[current.head]
            if current.i in self.by_word:
                return self.by_word[current.i]
        return None

    def _triggers(self) -> None:
        """ "when ego is 20 m away", "once the TTC falls to 2 s", "after 5 s": for the event they stand with."""
        for event in self.events:
            word = self.words[event.word]
            candidates = [event.word, *(c for c in word.children if self.words[c].dep in ("advcl", "prep", "npadvmod"))]
            for i in candidates[1:]:
                inside = self._deep(i)
                text = self.render(inside)
                marks = self.words[inside[0]].norm if inside else ""
                quantities = self._quantities(inside)
                for quantity in quantities:
                    if quantity["dimension"] == "time" and re.search(r"\bttc\b|time[- ]to[- ](collision|contact)", text):
                        event.trigger = {"kind": "ttc", "value": quantity["low"]}
                    elif quantity["dimension"] == "distance" and self.words[i].dep == "advcl" and marks in ("when", "once", "as", "after", "until", "while") and re.search(r"when|once|as soon as|after|until", text):
                        place = "intersection" if re.search(r"intersection|junction", text) else "crosswalk" if "cross" in text else None
                        event.trigger = {"kind": "place", "value": quantity["low"], "place": place} if place else {"kind": "distance", "value": quantity["low"]}
                    elif quantity["dimension"] == "time" and (re.match(r"(after|at) (about |around |roughly |t = )?#time$", text) or re.search(r"#time (into|later|after the start|in)", text)):
                        event.trigger = {"kind": "time", "value": quantity["low"]}
            own = self.render(event.words)
            if event.trigger is None:
                for quantity in event.quantities:
                    if quantity["dimension"] == "time" and re.search(r"#time (later|into|in\b|after the start|after start)|(^|, )(after|at) (about |around |roughly |t ?= ?)?#time", own):
                        event.trigger = {"kind": "time", "value": quantity["low"]}
                    elif quantity["dimension"] == "time" and re.search(r"\bttc\b|time[- ]to[- ](collision|contact)", own):
                        event.trigger = {"kind": "ttc", "value": quantity["low"]}

    def _deep(self, i: int) -> list[int]:
        found = [i]
        for child in self.words[i].children:
            found += self._deep(child)
        return sorted(found)


@cache
def VERB_LEMMAS() -> frozenset[str]:  # noqa: N802
    return frozenset(v for rule in language.table("motions")["verbs"] for v in rule["verbs"])

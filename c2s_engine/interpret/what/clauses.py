"""Fourth stage: what happens. Each verb (and noun) of motion becomes an event with agent, patient and circumstances."""

import re
from dataclasses import replace

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.deverbal import Deverbal
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast, Entity

OUT_OF = re.compile(
    r"\b(out|from|off)\b.*\b(drive|driveway|parking|space|bay|garage|yard|gate|alley|lot|property)\b"
    r"|\b(on|in)to (the |a )?(\w+ )?(road|street|carriageway|highway|roadway)\b|out in front of"
)
FORCEFUL = language.words("forceful")


PUSHES = language.words("pushes")
PUTS = language.words("puts")
STEERED = frozenset(("driven", "operated", "steered", "ridden", "piloted"))
LETS, PASSES = frozenset(("let", "allow", "permit")), frozenset(("pass", "go", "by"))
FASTER = re.compile(r"\b(?:behind|rear|overtak\w*|tailgat\w*|catch\w*|caught|faster|closing)\b")
NEARLY = language.words("nearly")
SHORT_OF = {"collide": "approach", "stop": "brake", "brake_stop": "brake"}
"""What one does that nearly does something."""
AS_GOOD_AS = frozenset(("stationary", "travel", "approach", "brake"))
BACKWARDS = re.compile(
    r"(?:roll|drive|move|slide|drift|go|come) (?:\w+ )?(?:back|backwards?|rearwards?) (?:and |into )"
)
GOING_BEGUN = re.compile(
    r"(?:start|begin|commence|resume|get) (?:to )?(?:move|drive|roll|go)"
    r"(?: (?:off|again|forwards?|slowly|gently))*[ .,;]*$"
)
BY = re.compile(r"\bby (?:(?:the|an?|another|\w+) ){0,2}@")


class Clauses(Deverbal):
    """The events of a text."""

    def __init__(self, words: list[Word], cast: Cast) -> None:
        self.words, self.cast = words, cast
        self.events: list[Event] = []
        self.by_word: dict[int, Event] = {}
        self.light: set[int] = set()
        self.deeds: set[int] = set()  # who does what a noun tells
        self.dangling: set[int] = set()
        for word in words:
            if not self._reads_motion_noun(word) and not cast.tows(word) and self._is_verb(word):
                self._verb(word)
        for word in words:
            if word.tag.startswith("NN") or word.tag == "VBG":
                self._noun(word)
        for word in words:
            self._attributive(word)
            self._striking(word)
            self._named_by_deed(word)
        self._order()
        self._triggers()
        self._held_back()
        self._ended_waits()
        self.events.sort(key=lambda e: e.order)

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
        if (told := self._going_begun_or_ended(word, text)) is not None:
            lemma, text = told
        if lemma == "stop" and any(self.words[c].dep == "auxpass" for c in word.children):
            complements = []  # "was stopped facing west"
        if lemma in ("let", "allow", "wait", "permit") and complements:
            text = f"{text} {self.render(self.own(self.words[complements[0]]))}"
        awaited: Entity | None = None
        if lemma == "wait" and (
            later := [
                c
                for c in word.children
                if self.words[c].dep == "advcl" and self._mark(self.words[c]) in ("until", "till")
            ]
        ):
            text = f"wait until {self.render(self.own(self.words[later[0]]))}"
            awaited = self._subject(self.words[later[0]])[0]
        if lemma == "follow" and word.tag == "VBN" and word.head != word.i:  # "a ball rolls onto the road, followed by"
            led = self.words[word.head] if word.head in self.cast.of else self._governor(self.words[word.head])
            whole = f"{whole} {self.render(self.own(led or self.words[word.head]))}"
        if lemma == "be":
            complements = [c for c in complements if self.words[c].dep == "xcomp"]
        if (
            complements
            and lemma in (*shades["light"], *shades["intended"], *shades["failed"])
            and not re.search(r"^(stop|start|be|see|observe|detect|ensure|decide|remain) .*@", text)
            and not (lemma == "stop" and any(self.words[c].tag == "VB" for c in complements))
        ) and lemma not in ("let", "allow", "permit", "wait"):
            self.light.add(word.i)
            return
        agent, at, passive = self._subject(word)
        if word.norm in STEERED and word.tag == "VBN" and self.words[min(word.i, len(self.words) - 2) + 1].norm == "by":
            return  # "a van driven by Mr Tan"
        if self._let_by(word, agent):
            return
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
        if agent is None and self._of_its_writer(word):
            agent = self.cast.ego
        having = word.tag == "VBN" and any(self.words[c].norm == "having" for c in word.children)
        if agent is not None and (word.tag == "VBG" or having) and not passive and self._dangles(word, agent):
            self.dangling.add(word.i)
        if word.i in self.dangling or word.dep == "xcomp" and word.head in self.dangling:
            agent = self.cast.ego
        patient = awaited if awaited is not None and not awaited.ego else self._patient(word, own, agent, passive)
        if ("each other" in text or "one another" in text) and (others := self._also(at, word.i)):
            patient = others[0]  # "V2 and V3 crashed into each other in front of V1"
        whom = agent if passive and at in word.children and self.words[at].dep == "nsubjpass" else None
        if passive and lemma in PUSHES and (pushed := whom or patient or agent) is not None:
            text = re.sub(r"^(\w+)", rf"\1 @{pushed.key}", text)  # "was forced off the road": whom it is about
            patient = patient or pushed
        event = self._event(lemma, word, text, whole, agent, patient)
        if event is None or event.act == "stationary" and lemma in PUTS and not passive and self._has_object(word):
            return
        if event.act == "stationary" and lemma == "lie" and event.agent.ego:
            return  # "her phone, which was lying in the footwell"
        if event.act == "start_straight":
            event.act = "start"
            mode, i = self._mode(word), word.i
            self.events.append(Event("go_straight", event.agent, i, text, whole, mode=mode, order=i + 0.1, words=[i]))
        if event.act in ("brake", "brake_stop", "stop") and not event.hard:
            following = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 5] if w.sentence == word.sentence)
            forceful = word.i > 0 and self.words[word.i - 1].norm in FORCEFUL  # "harsh braking by the VUT"
            event.hard = forceful or bool(
                re.match(
                    (
                        r"((very|quite|rather|so|pretty|really) )?(hard|harder|sharply|abruptly|heavily|strongly"
                        r"|violently)\b"
                    ),
                    following,
                )
            )
        if event.act == "follow" and event.patient is None and not passive and text.strip(" .,;") == "follow":
            movers = [e.agent for e in self.events if self.words[e.word].sentence == word.sentence and e.agent.mover]
            event.patient = next((e for e in reversed(movers) if e is not event.agent), None)
        event.words, event.mode, event.passive = own, self._mode(word), passive
        if any(self.words[c].norm in NEARLY for c in word.children):
            event.mode = event.mode if event.act in AS_GOOD_AS or event.act in SHORT_OF else "hypothetical"
            event.act = SHORT_OF.get(event.act, event.act)
        if event.act == "stop" and passive and lemma != "bring" and event.agent is agent:
            event.act = "stationary"
        struck = event.act == "collide" and passive and event.agent is agent and event.patient in (None, agent)
        if struck and not event.agent.ego:
            event.agent, event.patient = self.cast.ego, agent  # "the deer was hit"
        late: Event | None = None
        once = {"words": [word.i], "start": word.start, "end": word.end, "mode": event.mode}
        if event.act == "collide" and (lemma in ("reverse", "back") or BACKWARDS.match(text)):
            back = Event.echo(event, act="reverse", order=word.i - 0.1, **once)
            self.events.append(replace(back, adverbial=self._mark(word)))
        if event.act == "reverse" and not event.agent.ego and OUT_OF.search(text):
            late = replace(event, act="enter_road", order=word.i + 0.2)
        event.start, event.end = self.words[own[0]].start, self.words[own[-1]].end
        event.quantities = self._quantities(own)
        if word.dep in ("advcl", "relcl", "pcomp", "ccomp") or word.dep == "conj":
            event.adverbial = self._mark(word)
        elif word.dep == "xcomp" and word.head in self.light:  # "when he attempted to overtake"
            event.adverbial = self._mark(self.words[word.head])
        event.also = self._also(at, word.i)
        if event.patient in event.also and event.act != "collide":
            event.patient = None  # "V2 and V3 were stopped, V3 in front of V2"
        if event.act == "overtake" and not event.agent.ego and self._of_both(own):
            event.patient = self.cast.ego  # "overtakes both"
        self.events.append(event)
        if late is not None:
            late.adverbial, late.start, late.end = event.adverbial, event.start, event.end
            self.events.append(late)
        self.by_word[word.i] = event

    def _going_begun_or_ended(self, word: Word, text: str) -> tuple[str, str] | None:
        """The verb and text that say plainly that one begins or ends going: "starts moving", "stops rolling"."""
        before = word.i - 2 if self.words[word.i - 1].norm == "to" else word.i - 1
        if word.dep == "xcomp" and word.head == before or before >= 0 and self.words[before].dep == "aux":
            text = f"{self._lemma(self.words[before])} {text}"
        return ("move", "move off") if GOING_BEGUN.match(text) else None

    def _has_object(self, word: Word) -> bool:
        return any(self.words[c].dep == "dobj" for c in word.children)

    def _let_by(self, word: Word, agent: Entity | None) -> bool:
        """Whether somebody only gets by because another waits ("we let him pass"), and was not behind."""
        letting = self.words[word.head]
        if word.dep not in ("ccomp", "xcomp") or self._lemma(letting) not in LETS or agent is None or agent.ego:
            return False
        own = (" ".join(w.norm for w in self.words[m.word : m.word + 9]) for m in agent.mentions)
        behind = "following" in agent.roles or any(FASTER.search(text) for text in own)
        return self._lemma(word) in PASSES and not behind and not self._has_object(word)

"""When it happens: the order of events and what triggers them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.afterwards import Afterwards
from c2s_engine.interpret.who.mentions import Entity

if TYPE_CHECKING:
    from c2s_engine.interpret.what.event import Event


AWAY = re.compile(
    r"(only )?(at (a |the )?(distance|range|gap) of (about |around |roughly |some )?#dist\b"
    r"|at (about |around )?#dist (distance|range|away|from)\b|with @ego #dist )"
)
ENDS_UP = frozenset(("end", "wind", "finish"))
CIRCUMSTANCES = frozenset(("advcl", "prep", "npadvmod", "advmod"))
COMES_OUT = ("cross_road", "enter_road")
BEFORE_THE_BLOW = frozenset(
    (
        "run_red",
        "run_stop",
        "lose_control",
        "oncoming",
        "cross_path",
        "turn",
        "cut_in",
        "drift",
        "lane_change",
        "enter_road",
        "reverse",
    )
)
BY_WHICH = BEFORE_THE_BLOW | {"overtake", "pass_by"}
AT_A_DISTANCE = (
    "brake",
    "brake_stop",
    "stop",
    "swerve",
    "cross_road",
    "enter_road",
    "cut_in",
    "lane_change",
    "turn",
    "start",
)


RIGHT = ("only", "just", "exactly", "right", "left", "even", "shortly")
"""What stands before the word that opens a clause: "swerved right when ..."."""
NEARNESS = re.compile(
    r"(?P<ttc>\bttc\b|time[- ]to[- ](?:collision|contact))|\b(?:time[- ]?)?(?:gap|headway)s?\b|\bthw\b"
)
"""Times that tell how near one is: to the collision, or behind another."""
CONDITIONS = ("when", "once", "as", "after", "until", "while", "where", "if", "whenever")
WHEN = re.compile(
    r"when|once|as soon as|after|until|^(?:if|where)\b.*\b(?:within|than|away|under|below)\b"
    r"|^as\b.*\b(?:away|closer|nearer|within|under|(?:close|drop|fall|shrink|narrow|decrease)s?)\b"
)
"""What tells from what distance on something happens."""


class Timing(Afterwards):
    """The part of Clauses that orders the events."""

    light: set[int]

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
            self._order_one(event)
        for event in self.events:  # "a lorry that had just passed him turned"
            word = self.words[event.word]
            main = self._main(word) if any(self.words[c].norm == "had" for c in word.children) else None
            if main is not None and main.agent is event.agent and word.dep == "relcl":
                event.order = min(event.order, main.order - 0.2)
            states = word.dep == "acl" and word.tag == "VBG" or word.dep == "relcl" and word.lemma == "be"
            beside = self._main(word) if states else None
            if beside is not None and beside.agent is event.agent and word.i < beside.word:
                event.order = min(event.order, beside.order - 0.2)  # "when a cyclist riding on the left swerved"

    def _order_one(self, event: Event) -> None:
        """Put what a subordinate clause tells before or after what the main one does."""
        word = self.words[event.word]
        main = self._main(word)
        if main is None:
            return
        mark = event.adverbial
        if word.dep in ("acl", "pobj") and word.tag == "VBG" and main.act == "collide" and event.word > main.word:
            event.order = main.order - 0.4  # "was hit by a car turning left"
        struck = self._in_relative(event)
        if struck is not None and struck.act == "collide":
            event.order = struck.order - 0.4
            return
        if mark == "when" and event.word > main.word and event.agent is main.agent and self.lasted(main.word):
            return  # "was turning left when it lost control"
        blow = mark in ("when", "as") and event.act == "collide" and event.agent is main.agent
        if blow and event.word > main.word:
            return  # "was turning left when it struck V2"
        stood = mark in ("while", "whilst") and word.tag == "VBG" and event.act in ("stationary", "wait")
        if (stood or mark in ("after", "once", "when", "as", "having", "because")) and event.word > main.word:
            event.order = main.order - 0.4
        elif mark in ("until", "till") and event.word > main.word:
            event.order = main.order + 0.2
        elif (
            self.words[event.word].tag == "VBN"
            and any(self.words[c].norm in ("had", "having") for c in word.children)
            and event.word > main.word
        ):
            event.order = main.order - 0.4

    def lasted(self, verb: int) -> bool:
        """Whether a verb tells what was going on: "was turning", "was trying to turn"."""
        told = [self.words[verb], *self._verbs_above(self.words[verb])]
        aux = (self.words[c].norm for w in told for c in w.children if self.words[c].dep == "aux")
        return any(w.tag == "VBG" for w in told) and any(a in ("was", "were", "is", "are") for a in aux)

    def _in_relative(self, event: Event) -> Event | None:
        """What a clause tells in whose relative clause something is told that leads to it: "was struck by V2, which
        was northbound and ran the light"."""
        word = self.words[event.word]
        while word.dep in ("conj", "acomp", "attr") and word.head < word.i:
            word = self.words[word.head]
        main = self._main(word) if word.dep == "relcl" and event.act in BY_WHICH else None
        return main if main is not None and event.word > main.word else None

    def joined_to(self, event: Event) -> Event | None:
        """What the clause tells to which an event's clause is joined."""
        return self._main(self.words[event.word])

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
            for i in self._circumstances(word):
                inside = self._deep(i)
                text = self.render(inside)
                told = [self.words[j].norm for j in inside if self.words[j].norm not in RIGHT]
                marks = told[0] if told else ""
                quantities, before = self._quantities(inside), event.trigger
                for quantity in quantities:
                    if event.trigger is not before:
                        break  # "once it is 50 m behind the van, and returns when it is 20 m past it"
                    nearness = NEARNESS.search(text) if quantity["dimension"] == "time" else None
                    if nearness is not None and (nearness["ttc"] or marks in CONDITIONS):
                        event.trigger = {
                            "kind": "ttc" if nearness["ttc"] else "headway",
                            "value": quantity["low"],
                            "of": self._to_whom(event, inside),
                            "at": quantity["start"],
                        }
                    elif (
                        quantity["dimension"] == "distance"
                        and self.words[i].dep in ("advcl", "advmod", "relcl")
                        and marks in CONDITIONS
                        and WHEN.search(
                            text,
                        )
                    ):
                        place = (
                            "intersection"
                            if re.search(r"intersection|junction|crossroads|stop line|stop sign|lights?\b", text)
                            else "crosswalk"
                            if re.search(r"\b(?:crosswalk|crossing|zebra)", text)
                            else None
                        )
                        event.trigger = (
                            {"kind": "place", "value": quantity["low"], "place": place}
                            if place and (not event.agent.person or event.agent.ego)
                            else {
                                "kind": "distance",
                                "value": quantity["low"],
                                "of": self._to_whom(event, inside),
                                "at": quantity["start"],
                            }
                        )
                    elif quantity["dimension"] == "distance" and event.act in AT_A_DISTANCE and AWAY.match(text):
                        event.trigger = {"kind": "distance", "value": quantity["low"]}
                    elif quantity["dimension"] == "time" and (
                        re.match(r"((only|right|left|hard|just|exactly|straight) )*(after|at) (\w+ |t = )?#time$", text)
                        or re.search(r"#time (into|later|after(wards| that| the start)|thereafter|in)", text)
                    ):
                        event.trigger = {"kind": "time", "value": quantity["low"]}
            above = [i for verb in self._verbs_above(word) for i in self.own(verb)]
            own = self.render(sorted({*event.words, *above}))
            if event.trigger is None and event.act in COMES_OUT and not event.agent.ego:
                event.trigger = self._where_it_comes_out(event, own)

    def _to_whom(self, event: Event, clause: list[int]) -> Entity | None:
        """To whom the distance of a trigger is, if not to ego: "when the cyclist is 10 m from the van, it ..."; for ego
        whom the clause names."""
        told = list(dict.fromkeys(self.cast.of[i] for i in clause if i in self.cast.of))
        others = [e for e in told if e is not event.agent]
        if event.agent.ego:
            return others[0] if len(others) == 1 else None
        return others[0] if event.agent in told and len(others) == 1 and not others[0].ego else None

    def _circumstances(self, word: Word) -> list[int]:
        """What stands with a verb, or with the verb that only begins it ("starts to cross when ...")."""
        found = [c for c in word.children if self.words[c].dep in CIRCUMSTANCES]
        for verb in self._verbs_above(word):
            found += [c for c in verb.children if self.words[c].dep in CIRCUMSTANCES]
        return found

    def _verbs_above(self, word: Word) -> list[Word]:
        """The verbs that only begin or bring about what a verb or a noun tells: "has to brake", "initiates braking"."""
        found: list[Word] = []
        while (above := self.words[word.head]) is not word and self._brings(above, word):
            found.append(above)
            word = above
        return found

    def _brings(self, above: Word, word: Word) -> bool:
        """Whether a verb, itself no deed, has one that tells the deed for its complement."""
        if above.i in self.by_word and self.by_word[above.i].act != "travel":
            return False
        ends_up = word.dep == "advcl" and word.tag == "VBG" and self._lemma(above) in ENDS_UP
        complement = word.dep in ("xcomp", "acomp") or word.dep in ("dobj", "npadvmod") and above.tag.startswith("VB")
        return complement or ends_up or word.dep == "ccomp" and above.i in self.light

    def _nouns_of(self, verb: Word) -> list[Word]:
        """The objects of a verb, its prepositions' too: a clause of time may hang on the last of them."""
        direct = [self.words[c] for c in verb.children if c > verb.i and self.words[c].dep in ("dobj", "prep")]
        inner = [self.words[c] for w in direct for c in w.children if self.words[c].dep in ("pobj", "prep")]
        return [w for w in (*direct, *inner) if w.noun]

    def _where_it_comes_out(self, event: Event, own: str) -> dict[str, Any] | None:
        """How far ego is when one comes out "20 m in front of it"."""
        match = re.search(r"#dist (?:right |directly )?(?:ahead|in front)\b(?! of (?:the |an? )?(?:\w+ )?@a)", own)
        told = [q for q in event.quantities if q["dimension"] == "distance"]
        return {"kind": "distance", "value": told[0]["low"]} if match and len(told) == 1 else None

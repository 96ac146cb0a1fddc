"""Road users that are named and are not there: denied, towed, only looked at, or long gone."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS, VEHICLES, ZONES, Entity
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.syntax import Word

CARRIES = language.words("carries")
HIDES = language.words("hides")
LADEN = language.words("laden")
LOST, SAYS = language.words("lost"), language.words("says")
ATTENDS = language.words("attends")
SEES = language.words("notices") | {"watch", "hear", "look", "help"}
WALKS_WITH = language.words("walks_with")
PUSHED = frozenset(("bicycle", "motorcycle", "box", "debris", "trash", "container", "obstacle"))
FILLS = re.compile(r"(?:full of|(?:filled|packed) with|(?:occupied|taken) by)(?: \w+)?$")
_LANE = (
    r"(?:in|on|along) (?:the|its|our|my|both|all|all the|the other) (?:(?:two|three|outer|inner) )?"
    r"(?:(?:left|right|adjacent|neighbou?ring|next|other|second|middle|cent(?:er|re)|fast|slow|passing|overtaking|through)"
    r"(?: ?- ?hand)?(?: hand)? )?lanes?(?: (?:to|on) (?:its|the|our|my) (?:left|right))?"
)
BUSY = re.compile(
    rf"{_LANE} (?:(?:is|was|are|remains?|keeps?|goes|continues|stays?) )(?:on |to )?(?:\w+ly |very |quite )?"
    r"(?:heavy|dense|busy|slow|steady|fast|constant|continuous|mov|flow|crawl|creep|roll|drive|driving|go)"
)
FIXED = frozenset(language.table("actors")["fixed"])
PLACED_BY = frozenset(("between", "at", "by", "near", "beside", "past", "outside", "opposite"))
HEADS = frozenset(("actors", "objects", "vehicles", "participants", "users", "agents", "npcs", "obstacles", "others"))
GROWS = frozenset(("trees", "bushes", "hedges", "shrubs", "shrubbery"))
TEACHES = SAYS | {"teach", "remind", "warn", "preach", "show"}
STILL_THERE = re.compile(r"(?:(?:driving|travelling|traveling|going|just|right|directly) )*(?:ahead|in front)\b")


class NotThere:
    """The part of Cast that tells what is only named."""

    words: list[Word]
    of: dict[int, Entity]
    onlooker: bool  # whether somebody off the road tells the text

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

    def _gone(self, word: Word, before: list[str]) -> bool:
        """Whether it is only who lost something on the road before: "a ladder, shed by an unknown vehicle"."""
        by = self.words[word.head]
        verb = self.words[by.head]
        if self._goods(word) or self._beside_onlooker(word):
            return True
        if word.dep == "dobj" and by.lemma in WALKS_WITH and self._done_on_foot(by):
            return word.span is not None and word.span.data["type"] in PUSHED
        if word.norm in GROWS and by.norm in ("from", "of", "between", "among", "through"):
            return True  # "a deer bounds out of the trees"
        if word.dep == "dobj" and (
            by.lemma in CARRIES or by.lemma == "drop" and "off" in [w.norm for w in self.words[by.i : word.i + 2]]
        ):
            return word.span is not None and word.span.data["type"] in ("box", "trash", "container")
        lost = by.norm in ("by", "from", "off") and verb.tag in ("VBN", "VBD") and verb.norm in LOST
        leads = word.span is not None and "lead" in word.span.data.get("roles", ())
        if leads or STILL_THERE.match(" ".join(w.norm for w in self.words[word.i + 1 : word.i + 4])):
            return False  # "a pallet dropped by the truck ahead"
        return lost and (verb.dep in ("acl", "relcl", "advcl", "amod", "conj"))

    def _goods(self, word: Word) -> bool:
        """Whether it is what a vehicle has on it: "a truck loaded with logs", "piled high with boxes"."""
        first = word
        while first.dep == "conj" and first.head != first.i:
            first = self.words[first.head]
        by = self.words[first.head]
        before = [w.norm for w in self.words[max(0, by.i - 2) : by.i] if w.norm != "high"]
        return first.dep == "pobj" and by.norm == "with" and before[-1:] != [] and before[-1] in LADEN

    def _beside_onlooker(self, word: Word) -> bool:
        """Whether it is only what somebody off the road had or stood at: "I was walking the dog when I saw ..."."""
        above = self.words[word.head]
        verb = self.words[above.head] if above.dep == "prep" else above
        if (
            not self.onlooker
            or word.span is None
            or not verb.verb
            or verb.lemma in SEES
            or word.dep.startswith("nsubj")
        ):
            return False
        subjects = [self.words[c].norm for c in verb.children if self.words[c].dep.startswith("nsubj")]
        fixed = word.span.data["type"] not in VEHICLES or word.span.data["type"] == "animal"
        return subjects in (["i"], ["we"]) and fixed

    def _done_on_foot(self, verb: Word) -> bool:
        """Whether somebody on foot does it."""
        who = (
            [verb.head] if verb.dep in ("acl", "relcl") else [c for c in verb.children if self.words[c].dep == "nsubj"]
        )
        return any(i in self.of and self.of[i].person for i in who)

    def _heads_list(self, word: Word) -> bool:
        """Whether a plural only heads what follows ("Actors: ego on the main road, a car ...")."""
        after = self.words[word.i + 1].norm if word.i + 1 < len(self.words) else ""
        before = [w for w in self.words[max(0, word.i - 2) : word.i] if w.sentence == word.sentence]
        return after == ":" and word.norm.split(" ")[-1] in HEADS and len(before) < 2

    def _halts(self, word: Word) -> bool:
        """Whether traffic is said to come to a stand or to slow down, or how it moves where it is told to be."""
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 16] if w.sentence == word.sentence)
        acts = re.match(language.table("actors")["traffic_acts"], after) is not None
        fills = FILLS.search(" ".join(self._near(word))) is not None
        return fills or acts and word.dep in ("nsubj", "nsubjpass", "ROOT")

    def _flows(self, word: Word) -> bool:
        """Whether traffic is said to be in a lane, or to move there: "in the left lane traffic goes on flowing"."""
        own = [w for w in self.words if w.sentence == word.sentence]
        after = " ".join(w.norm for w in own if w.i > word.i)
        return bool(BUSY.match(after))

    def _reports(self, word: Word) -> bool:
        """Whether police only say something or are told it, or come when all is over: "he told troopers", "according to
        officers", "cops came after 20 minutes"."""
        verb = self.words[word.head]
        if word.dep == "nsubj" and verb.lemma in ATTENDS:
            return True
        if self.words[verb.head].norm == "according":
            return True
        above = self.words[verb.head] if verb.norm in ("to", "by") else verb
        return (verb if verb.verb else above).lemma in SAYS

    def _carried(self, word: Word, following: Word) -> bool:
        """Whether a thing stands right before a vehicle that carries such things: "a timber lorry"."""
        spans = [w.span for w in (word, following) if w.span is not None and w.span.kind == "actor"]
        if len(spans) < 2 or spans[0].data["plural"] or following.sentence != word.sentence:
            return False
        return spans[0].data["type"] not in MOVERS | ZONES and spans[1].data["type"] in VEHICLES

    def _cab_of(self, word: Word, noun: str) -> bool:
        """Whether "the cab" is where the driver of a truck sits that was told of, and no taxi."""
        the = word.i > 0 and self.words[word.i - 1].norm in ("the", "its", "his")
        return noun == "cab" and the and any(e.type == "truck" for e in self.of.values())

    def _all_of_a_kind(self, word: Word) -> bool:
        """Whether all of a kind are spoken of, not who is there: "many tractors turn off without a warning", "I tell
        every learner", "assumption: children run no faster than 3 m/s"."""
        assert word.span is not None
        before = self.words[word.i - 1].norm
        if before in ("every", "each", "any") and word.dep in ("dobj", "dative", "pobj", "iobj"):
            above = self.words[word.head]
            return above.lemma in TEACHES or above.norm in ("for", "to") and not self.words[above.head].verb
        if word.dep != "nsubj" or self.words[word.head].tag != "VBP" or not word.span.data.get("plural"):
            return False
        if before not in ("many", "most", "some", "all"):
            return False
        kind = word.span.data["type"]
        return any(e.count == 1 and e.type == kind for e in self.of.values())

    def _only_a_place(self, word: Word, noun: str) -> bool:
        """Whether a thing that stands by the road only tells where somebody is: "a girl waits at the mailbox"."""
        by = self.words[word.head]
        hides = by.norm == "by" and irregular().get(self.words[by.head].norm, self.words[by.head].lemma) in HIDES
        return noun in FIXED and word.dep == "pobj" and by.norm in PLACED_BY and not hides

    def _house(self, word: Word) -> bool:
        """Whether an animal is the name of a house: "she left the Fox on foot", "outside the Red Lion"."""
        back = [w for w in self.words[max(0, word.i - 2) : word.i] if w.sentence == word.sentence]
        capital = [w for w in back if w.text[:1].isupper()]
        named = bool(back) and back[-1 if back[-1] not in capital else 0].norm == "the"
        others = (w for w in self.words if w.norm == word.norm and not w.text[:1].isupper())
        animal = word.span is not None and word.span.data["type"] == "animal"
        return named and animal and next(others, None) is None

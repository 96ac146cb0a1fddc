"""Whom a noun or "one" means by where it is: "the one on the left", "the vehicle behind", "the parked one"."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.parts import Parts

GOING = r"(?:(?:is|are|was|were|driving|drives?|travell?ing|travels?|going|coming|right|directly|just|then|\w+ly) )*"
OF_EGO = r"(?! of (?!@ego)| (?:the|an?|from|to|@o)\b)"
ITS = r"(?:the |@(?:ego|o) (?:'s )?)?"
SIDE = rf"(?:in|on|to|at|from|along) {ITS}(?:(?:lane|side) (?:to|on) {ITS})?(?:adjacent |next )?"
PLACES = {
    "ahead": rf"(?:further )?(?:ahead|in front)\b{OF_EGO}|before @ego",
    "behind": rf"behind\b(?: @ego|{OF_EGO})|at the (?:rear|back)\b|(?:follow|tail|trail)(?:s|ed|ing) @ego",
    "left": rf"{SIDE}left\b",
    "right": rf"{SIDE}right\b",
    "oncoming": r"(?:in|from) the (?:opposite|oncoming|other) (?:lane|direction)|towards? @ego",
    "parked": r"(?:parked|waiting|standing|stopped|double-parked|broken)\b",
}
AFTER = {place: re.compile(f"(?:, )?{GOING}(?:#q )?(?:{words})") for place, words in PLACES.items()}
THERE = r"(?: lane| side)?(?: of @ego)? ?,?(?: there)?(?: is| are| was| drives| stands| follows)?$"
BEFORE = {
    "ahead": re.compile(
        rf"(?:ahead|in front){THERE}|@ego (?:(?:\w+ly )?(?:follow|trail|tail)\w*|(?:\w+ ){{1,2}}behind)$"
    ),
    "behind": re.compile(r"behind(?: @ego)? ?,?(?: there)? (?:is|are|was|drives|stands|follows)$"),
    "left": re.compile(rf"{SIDE}left{THERE}"),
    "right": re.compile(rf"{SIDE}right{THERE}"),
}
NAMED = {
    "ahead": frozenset(("lead", "leading", "front", "preceding", "foremost")),
    "behind": frozenset(("rear", "following", "trailing", "tailing", "back", "rearmost")),
    "left": frozenset(("left", "left-hand")),
    "right": frozenset(("right", "right-hand")),
    "oncoming": frozenset(("oncoming", "opposing", "opposite")),
    "parked": frozenset(("parked", "stationary", "standing", "stopped", "waiting", "double-parked")),
    "moving": frozenset(("moving", "driving")),
    "beside": frozenset(("adjacent", "neighbouring", "neighboring")),
}
PARTS = {"ahead": "lead", "behind": "following", "oncoming": "oncoming"}
"""The part in the scene of who is at a place."""


class ByPlace(Parts):
    """The part of Cast that knows road users by where they are."""

    def _by_place(self, word: Word, among: list[Entity]) -> Entity | None:
        """Who of those is at the place by which a definite noun or "the one" is told apart."""
        place = self._told_place(word)
        single = [e for e in among if e.count == 1 and not e.ego and e.type in VEHICLES and e.mentions]
        found = [e for e in single if place and self._is_at(e, place)]
        return found[-1] if found else None

    def _told_place(self, word: Word) -> str:
        """The place by which a noun is told apart."""
        before = {self.words[c].norm for c in word.children if c < word.i} | set(word.norm.split(" ")[:-1])
        named = next((place for place, names in NAMED.items() if names & before), "")
        after = self._spelled(word, word.i + 1, word.i + 10, "@o")
        return named or next((place for place, told in AFTER.items() if told.match(after)), "")

    def _is_at(self, entity: Entity, place: str) -> bool:
        """Whether somebody was told to be there."""
        if place in ("parked", "moving"):
            rests = bool(entity.roles & {"parked", "stationary"}) or self._placed_at(entity, "parked")
            return rests == (place == "parked")
        return PARTS.get(place) in entity.roles or self._placed_at(entity, place)

    def _placed_at(self, entity: Entity, place: str) -> bool:
        """Whether the words around what an entity is called first say that it is there."""
        called = (self.words[m.word] for m in entity.mentions)
        for noun in [w for w in called if w.norm in ("one", "another") or not w.tag.startswith(("PRP", "W"))][:2]:
            first = min((noun.i, *(c for c in noun.children if c < noun.i)))
            if AFTER[place].match(self._spelled(noun, noun.i + 1, noun.i + 10, "@ego")):
                return True
            if place in BEFORE and BEFORE[place].search(self._spelled(noun, first - 9, first, "@ego")):
                return True
        return False

    def _spelled(self, near: Word, start: int, end: int, it: str) -> str:
        """A stretch of a word's sentence for the patterns: ego, others, quantities and plain words."""
        spelled: list[str] = []
        for word in self.words[max(0, start) : end]:
            kind = word.span.kind if word.span is not None else ""
            who = self.of.get(word.i)
            if word.sentence != near.sentence or kind == "quantity" and spelled[-1:] == ["#q"]:
                continue
            if word.norm == "it":
                spelled.append(it)
            elif word.norm in ("us", "me") or kind == "ego" or who is not None and who.ego:
                spelled.append("@ego")
            else:
                spelled.append("#q" if kind == "quantity" else "@o" if kind in ("actor", "label") else word.norm)
        return re.sub(r"\b(?:the|an?|our|my|its) (?=@)", "", " ".join(spelled))

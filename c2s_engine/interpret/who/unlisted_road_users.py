"""Road users that no table names: unknown nouns by what they do, drivers who get out."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word

WALKS = re.compile(r"(cross|walk|run|ran|dash|hurr|rush|stroll|emerge|step)\w* ")


AT_SPEED = re.compile(
    r"(?:run|ran|runs|running) (?:\w+ ){0,3}(?:off|onto|out of) (?:the |his |her )?(?:\w+ )?"
    r"(?:road|shoulder|lane|verge|grass)"
)
"""What a driver does without leaving the vehicle: "the driver ran off the road"."""


OCCUPANTS = language.words("occupants")


class UnlistedRoadUsers:
    """The part of Cast that knows road users by what they do."""

    entities: list[Entity]
    of: dict[int, Entity]
    words: list[Word]

    def _new(self, entity: Entity) -> Entity:
        raise NotImplementedError

    def _children(self, word: Word) -> list[Word]:
        return [self.words[c] for c in word.children]

    def _on_foot(self, word: Word) -> bool:
        """Whether a driver or passenger leaves the vehicle: then it is a person of its own."""
        if word.norm.split(" ")[-1] not in OCCUPANTS or word.dep not in ("nsubj", "nsubjpass"):
            return False
        verb = self.words[word.head]
        joined = [self.words[c] for c in verb.children if self.words[c].dep == "conj"]
        own = {w.i for w in joined if not any(self.words[c].dep.startswith("nsubj") for c in w.children)}
        told = [self.words[c] for c in word.children if self.words[c].dep == "relcl"]
        verbs = [verb, *(w for w in joined if w.i in own), *told]
        rides = "passenger" in word.norm or "occupant" in word.norm
        after = [" ".join(w.norm for w in self.words[v.i : v.i + 7]) for v in verbs]
        off_road = not rides and any(AT_SPEED.match(text) for text in after)
        return not off_road and any(rides and WALKS.match(text) for text in after)

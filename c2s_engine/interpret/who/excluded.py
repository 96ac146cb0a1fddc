"""Whom a pronoun cannot mean: what its own verb is done to, or by whom it is placed."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.place_words import PlaceWords

BY_EGO = re.compile(r"\b(?:in front of|ahead of|behind|towards?) (?:the )?(?:@ego|us|me)(?! 's)(?: [.,;]|$)")


class Excluded(PlaceWords):
    """The part of Cast that knows whom the subject of a verb is not."""

    ego: Entity

    def _object_nouns(self, verb: Word) -> set[str]:
        """What its definite object is called: who does it is another ("it pulls out and overtakes the bus")."""
        objects = self._objects(verb)
        the = [w for w in objects if w.span is not None and any(self.words[c].norm == "the" for c in w.children)]
        return {str(w.span.data["noun"]) for w in the if w.span is not None and w.span.data.get("noun")}

    def _objects(self, verb: Word) -> list[Word]:
        """The objects of a verb and of those that go on with its subject; who does it to that one."""
        joined = [self.words[c] for c in verb.children if self.words[c].dep == "conj" and self.words[c].verb]
        alike = [v for v in joined if not any(self.words[c].dep.startswith("nsubj") for c in v.children)]
        below = [self.words[c] for v in (verb, *alike) for c in v.children if c > v.i]
        by = [self.words[c] for w in below if w.dep == "agent" for c in w.children]
        return [w for w in below if w.dep == "dobj"] + by

    def _object_labels(self, verb: Word) -> set[str]:
        """The labels of whom somebody hits: it is another who does it ("he hit vehicle 2")."""
        objects = [w.span for w in self._objects(verb)]
        return {str(s.data["label"]) for s in objects if s is not None and s.kind == "label"}

    def _placed_by_ego(self, verb: Word) -> bool:
        """Whether somebody does something before or behind ego: it is another ("it pulls out in front of us")."""
        clause: list[str] = []
        for word in self.words[verb.i :]:
            if word.sentence != verb.sentence or word.norm in (",", ";", "."):
                break
            named = word.span is not None and word.span.kind == "ego"
            clause.append("@ego" if named else word.norm)
        return BY_EGO.search(" ".join(clause)) is not None

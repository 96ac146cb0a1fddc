"""How far apart two are at the start: the distances and time gaps among some words."""

from __future__ import annotations

import re

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast, Entity

SHORTEST = 0.5
"""Nobody starts so close to another (m) lengthwise: what is smaller is sideways."""


class Gaps:
    """The part of Places that reads distances."""

    cast: Cast
    clauses: Clauses
    words: list[Word]

    def _stops(self) -> set[int]:
        """Where distances stand by which ego stops short of somebody."""
        stops = [e for e in self.clauses.events if e.agent.ego and e.act in ("stop", "brake_stop")]
        return {q["start"] for e in stops for q in e.quantities}

    def _gap_owner(self, i: int) -> Entity | None:
        """Whose place a distance tells: the noun that it stands under, if it is one of the others."""
        word = self.words[i]
        for _ in range(4):
            if word.head == word.i or word.verb:
                return None
            word = self.words[word.head]
            if word.i in self.cast.of:
                return self.cast.of[word.i]
        return None

    def _gap(self, indices: list[int], where: Where, entity: Entity | None = None) -> None:
        if where.gap is not None:
            return
        text, stops = self.clauses.render(indices), self._stops()
        for quantity in self.clauses._quantities(indices):
            whose = self._gap_owner(quantity["word"]) if entity is not None else None
            if whose is not None and whose is not entity and not whose.ego:
                continue
            before = " ".join(w.norm for w in self.words[max(0, quantity["word"] - 5) : quantity["word"]])
            after = " ".join(w.norm for w in self.words[quantity["word"] + 1 : quantity["word"] + 8])
            if quantity["dimension"] == "distance" and quantity["start"] not in stops:
                if (
                    re.match(r"\s*(\S+ )?(away )?from the (\w+ )?(kerb|curb|edge|verge)", after)
                    or not SHORTEST <= quantity["low"] <= 800
                ):
                    continue  # a way travelled
                if re.search(
                    (
                        r"visib|wide|radius|\br =|beyond|sideways|lateral|by (more|less)|long|off the|width|height"
                        r"|past the (intersection|junction)|within (a|an)?"
                    ),
                    before + " " + after,
                ) and not re.search(r"ahead|in front|behind|back|away", after):
                    continue
                if re.search(
                    (
                        r"ahead|in front|behind|away|back|distance|apart|gap|headway|clearance|spacing|separation"
                        r"|room|up the|from|at"
                        r"|(?:follow|trail|lead)\w* [^;]*\bby #dist"
                        r"|further|beyond|short|before|#dist (to|of|off)|least|along|on\b|down"
                    ),
                    before + " " + after + " " + text,
                ):
                    if re.search(r"(after|for|every) (about |around )?$", before + " ") or re.search(
                        r"(turn|when|once|until)\b", before
                    ):
                        continue
                    low, high = quantity["low"], quantity["high"]
                    where.gap = (low, high)
                    return

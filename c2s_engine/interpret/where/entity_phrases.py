"""Which words around a noun tell of its place: without those of another, of a time, or of how it is hit or passed."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

ASIDE = re.compile(
    r"\b(?:on|in|via|by|over|using|through|into|across) (?:the |its )?(?:on-?coming|opposite|opposing|other|wrong"
    r"|left|right|next"
    r"|adjacent)(?:-hand)? (?:\w+ )?(?:lane|side)(?: of the (?:road|street))?"
    r"|\b(?:on|via|over|using|along) (?:the )?(?:(?:left|right|hard|paved|gravel|grass) )*"
    r"(?:shoulder|verge|inside|outside)\b"
)
DIRECTED = frozenset(("towards", "toward", "into", "onto"))
PLACING = language.words("placing")


class EntityPhrases:
    """The part of Places that keeps the words that are an entity's own."""

    cast: Cast
    clauses: Clauses
    words: list[Word]

    def _unhit(self, text: str, entity: Entity) -> str:
        """The words about one without those that say how it is hit or neared: who is hit from behind is not behind."""
        if any(e.act in ("collide", "approach") and e.patient is entity and e.done for e in self.clauses.events):
            return re.sub(r"\b(from behind|(from|in|at) the (rear|back))\b", "", text)
        return text

    def _following(self, i: int) -> list[int]:
        """The words right after a noun that may say where it is, up to the end of the phrase."""
        found: list[int] = []
        for other in self.words[i + 1 : i + 14]:
            if (
                other.sentence != self.words[i].sentence
                or other.norm in (",", ".", ";", "and", "(", ":", "-", "but", "while", "when", "that", "which", "who")
                or (other.verb and other.tag != "VBN" and other.norm not in PLACING)
                or (other.norm in DIRECTED and self.words[i].dep == "pobj")
            ):
                break
            found.append(other.i)
        return found

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


class OwnWords:
    """The part of Places that keeps the words that are an entity's own."""

    cast: Cast
    clauses: Clauses
    words: list[Word]

    def _unhit(self, text: str, entity: Entity) -> str:
        """The words about one without those that say how it is hit or neared: who is hit from behind is not behind."""
        if any(e.act in ("collide", "approach") and e.patient is entity and e.done for e in self.clauses.events):
            return re.sub(r"\b(from behind|(from|in|at) the (rear|back))\b", "", text)
        return text

    def _unpassed(self, text: str, i: int, entity: Entity) -> str:
        """The words about one whom ego passes without those that say where ego goes then."""
        passes = [e for e in self.clauses.events if e.agent.ego and e.act in ("overtake", "evade", "lane_change")]
        if any(e.patient is entity or i in e.words for e in passes if e.word < i and i in e.words):
            return ASIDE.sub("", text)
        return text

    def _of_time(self, phrase: list[int]) -> bool:
        """Whether "before" begins a clause, not a place: "overtakes the cyclist before the car arrives"."""
        after = max(phrase) + 1
        verb = after < len(self.words) and self.words[after].tag in ("VBZ", "VBP", "VBD", "MD")
        return self.words[min(phrase)].norm == "before" and verb

    def _with_another(self, child: int, entity: Entity) -> bool:
        """Whether a phrase tells who else is there ("a bus with a car 10 m behind it")."""
        whom = (self.cast.of.get(c) for c in self.words[child].children if self.words[c].dep == "pobj")
        return self.words[child].norm == "with" and any(e is not None and e.mover and e is not entity for e in whom)

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

    def _of_subject(self, word: Word) -> bool:
        """Whether a place before a noun is set off behind the subject: "ego, in the left lane, approaches a truck"."""
        verb = self.words[word.head]
        subjects = [c for c in verb.children if self.words[c].dep == "nsubj" and c < verb.i]
        return word.dep == "dobj" and bool(subjects) and self.words[subjects[0] + 1].norm == "," and verb.i < word.i

"""Who the title of a text names: the same one that the text tells of then."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.named import Named


class Titles(Named):
    """The part of Cast that reads titles."""

    told: set[int]  # the sentences with a finite verb
    headlined: bool  # whether the first sentence is a headline

    def _titled(self, word: Word, kind: str) -> Entity | None:
        """The driver whom a title named ("Ghost driver at 2 a.m.: ... a wrong-way car comes")."""
        if kind not in VEHICLES or word.i == 0:
            return None
        indefinite = self.words[word.i - 1].norm in ("a", "an") or {"a", "an"} & set(self._modifiers(word))
        for entity in self.entities:
            if entity.type not in ("vehicle", kind) or len(entity.mentions) != 1 or entity.count != 1:
                continue
            first = self.words[entity.mentions[0].word]
            told = not self._heading(0) and (not entity.roles or entity.roles & {"lead", "following"})
            if indefinite and not told and self._announced(first, word):
                return entity
            if entity.type != "vehicle" or not entity.noun.endswith("driver"):
                continue
            if not indefinite and any(e.type == kind and kind != "car" for e in self.entities):
                continue  # "Driver rams patrol car. The cruiser ..."
            between = [w.norm for w in self.words[first.i : word.i]]
            ends = next((w.i for w in self.words[first.i : word.i] if w.norm == ":"), None)
            title = first.sentence == 0 and (self._heading(0) or ends is not None)
            verbs = [w for w in self.words[: ends or first.i] if w.tag in ("VBZ", "VBD", "VBP", "MD")]
            if title and not verbs and (ends is not None or word.sentence > 0) and "another" not in between[-3:]:
                return entity
        return None

    def _parts(self, word: Word) -> set[str]:
        """The parts in the scene that the words of a noun phrase give."""
        own = set(word.span.data.get("roles", ())) if word.span is not None else set()
        return own | {language.roles()[b] for b in self._modifiers(word) if b in language.roles()}

    def _announced(self, first: Word, word: Word) -> bool:
        """Whether a noun stands without an article in a short title, so that a later "a pickup" is the same one:
        "Crossing vehicle does not stop. A pickup comes from the left"."""
        title = [w for w in self.words if w.sentence == 0]
        if first.sentence != 0 or word.sentence == 0 or len(title) > 12 or title[-1].norm not in (".", ":", "!"):
            return False
        if any(w.norm in ("a", "an", "the", "is", "are") or w.span and w.span.kind != "actor" for w in title):
            return False
        acts = any(w.tag == "VBG" and w.i > first.i for w in title)
        if acts:
            return False  # "Vehicle changing lanes. The host moves over although a car ..."
        return sum(w.i in self.of for w in title) == 1

    def _heading(self, sentence: int) -> bool:
        """Whether a sentence is a title: without a finite verb, or the headline of a report."""
        return sentence not in self.told or sentence == 0 and self.headlined

    def _modifiers(self, word: Word) -> list[str]:
        found = []
        for i in range(max(0, word.i - 5), word.i):
            other = self.words[i]
            if other.sentence == word.sentence and (
                i in word.children
                or other.head in word.children
                and other.i < word.i
                and other.tag in ("RB", "CD", "JJ", "DT", "PDT")
            ):
                found.append(other.norm)
        return found

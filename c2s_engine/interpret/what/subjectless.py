"""Who does it where no subject stands before the verb: headings, notes, participles, subjects behind it."""

from __future__ import annotations

from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.meanings import Meanings
from c2s_engine.interpret.who.mentions import Entity


class Subjectless(Meanings):
    """The part of Clauses that finds the parties of verbs without a subject before them."""

    def topic(self, word: Word) -> Entity | None:
        """The one that a sentence is headed with: "Challenger: left lane, 90 km/h, cuts in"."""
        sentence = [w for w in self.words[max(0, word.i - 60) : word.i] if w.sentence == word.sentence]
        for first, second in zip(sentence, sentence[1:], strict=False):
            if second.norm in (":", "-") and first.i in self.cast.of and first.span is not None:
                return self.cast.of[first.i]
        return None

    def _continued(self, word: Word) -> Entity | None:
        """The one spoken of in the sentence before, for a finite verb that opens a sentence: "Bus ahead. Brakes." """
        if word.tag not in ("VBZ", "VBD", "NNS") or word.dep != "ROOT" or word.i == 0:
            return None
        opening = [w for w in self.words[: word.i] if w.sentence == word.sentence]
        if any(w.noun or w.verb or w.span is not None for w in opening):
            return None
        subjects = {i for i, _ in self.cast.subjects}
        for number in (word.sentence - 1, word.sentence - 2):
            spoken = [
                i for i in sorted(self.cast.of) if self.words[i].sentence == number and self.words[i].tag != "PRP$"
            ]
            first = next((i for i in reversed(spoken) if i in subjects), spoken[0] if spoken else None)
            if first is not None:
                return self.cast.of[first]
        return None

    def _mark(self, word: Word) -> str:
        raise NotImplementedError

    def _governor(self, word: Word) -> Word | None:
        current = word
        while current.head != current.i:
            current = self.words[current.head]
            if current.verb or self._is_verb(current):
                return current
        return None

    def _after_bracket(self, word: Word) -> int | None:
        """Who stands before the participle between commas, for it and for the verb behind it: "the van, having lost
        control, crosses"."""
        first = min(self._everything(word.i)) if word.tag in ("VBG", "VBN") and word.dep == "advcl" else None
        if first is not None:
            closing = next((w.i for w in self.words[word.i + 1 :] if w.norm == ","), None)
            last = self.words[closing + 1] if closing is not None and closing + 1 < len(self.words) else None
            if last is None or last.sentence != word.sentence or last.tag not in ("VBZ", "VBD"):
                return None
        elif word.tag in ("VBZ", "VBD") and word.i and self.words[word.i - 1].norm == ",":
            opening = [w.i for w in self.words[max(0, word.i - 16) : word.i - 1] if w.norm == ","]
            first = opening[-1] + 1 if opening else None
            if first is None or self.words[first].tag not in ("VBG", "VBN"):
                return None
        if first is None or first < 2 or self.words[first - 1].norm != "," or self.words[first - 2].span is None:
            return None
        return first - 2 if first - 2 in self.cast.of and self.words[first - 2].sentence == word.sentence else None

    def _joined_verb(self, word: Word, above: Word | None) -> Word | None:
        """The verb that one after "and" goes on with, where the tree takes a clause inside it for that."""
        if word.dep != "conj" or above is None:
            return above
        if word.tag == "VB" and above.tag in ("VBG", "VBN") and above.dep in ("acl", "ccomp"):
            return self._governor(above) or above  # "shall detect a truck blocking its lane and pass it"
        return above

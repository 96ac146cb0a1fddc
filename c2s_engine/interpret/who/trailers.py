"""What is pulled and who pulls it: both are one road user, unless the trailer comes loose."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import DEFINITE, VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.spans import names_one
from c2s_engine.interpret.who.writers import Writers

TOWED = language.with_plurals("towed")
TOWS, UNHITCHED = language.words("tows"), language.words("unhitched")


class Trailers(Writers):
    """The part of Cast that takes a trailer and who pulls it for one."""

    wheels: dict[int, Entity]
    trailing: dict[str, Entity]  # the noun of what is pulled -> who pulls it

    def _actor(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _named(self, word: Word) -> Entity | None:
        raise NotImplementedError

    def _pulled(self, word: Word, noun: str) -> Entity | None:
        """Who pulls what a noun names: as said here, or said before of "the trailer"."""
        if noun not in TOWED:
            return None
        puller = self._puller(word)
        found = self.of.get(puller.i) if puller is not None else None
        if puller is not None and puller.i > word.i and puller.span is not None:
            found = self._named(puller)
            if found is not None:
                self.wheels[puller.i] = found
        the = DEFINITE & {self.words[c].norm for c in word.children}
        if found is None and puller is None and the:
            found = self.trailing.get(noun.split(" ")[-1])
        if found is not None:
            self.trailing[noun.split(" ")[-1]] = found
        return found

    def _puller(self, word: Word) -> Word | None:
        """The word for who pulls it; the verb where nobody is named who does."""
        above = self.words[word.head]
        if (before := self._participle(word)) is not None:
            return before
        if above.norm in ("with", "of") and word.dep == "pobj":
            return self._road_user(self.words[above.i - 1]) or self._road_user(self.words[above.head])
        verb = next((self.words[c] for c in word.children if self._tows(self.words[c])), above)
        agent = self._child(verb, "agent") if self._tows(verb) else None
        owner = next((c for c in self._children(word) if c.norm == "of"), None) if agent is None else agent
        if owner is not None:
            return self._road_user(self._child(owner, "pobj"))
        return self._child(word, "poss")

    def _participle(self, word: Word) -> Word | None:
        """Who stands before a participle that has the trailer as its object, also where the tree says otherwise: "a
        pickup pulling a boat trailer pulls out"."""
        for verb in reversed(self.words[max(0, word.i - 4) : word.i]):
            if verb.tag == "VBG" and verb.lemma in TOWS:
                before = reversed(self.words[max(0, verb.i - 4) : verb.i])
                return next((w for w in before if w.sentence == word.sentence and self._road_user(w)), None)
            if verb.sentence != word.sentence or verb.verb or verb.norm in (",", "and", "with"):
                return None
        return None

    def _tows(self, word: Word) -> bool:
        return word.verb and word.lemma in TOWS

    def _children(self, word: Word) -> list[Word]:
        return [self.words[c] for c in word.children]

    def _child(self, word: Word, relation: str) -> Word | None:
        """The first child in a grammatical relation."""
        return next((c for c in self._children(word) if c.dep == relation), None)

    def _road_user(self, word: Word | None) -> Word | None:
        return word if word is not None and names_one(word.span, VEHICLES) else None

    def tows(self, word: Word) -> bool:
        """Whether a verb only tells that somebody pulls a trailer."""
        if not self._tows(word):
            return False
        inside = [c for c in word.children if self.words[c].dep != "nsubj"]
        around = [word.head, *inside] if word.tag == "VBN" else inside
        nouns = (self.words[c] for c in around if self.words[c].span is not None)
        return any(n.span.data.get("noun") in TOWED for n in nouns if n.span is not None)

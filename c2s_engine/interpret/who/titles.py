"""Who the title of a text names: the same one that the text tells of then."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import PERSONS, VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.named import Named

HITS = language.words("strikes") | {"knock", "run", "kill", "injure", "collide"}


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

    def _in_headline(self, word: Word, kind: str) -> Entity | None:
        """The one on foot or the animal of a headline, which is told of as a new one then: "Boy runs out: a driver
        stopped when a seven-year-old ran out", "Dog escapes: ... a terrier"."""
        before = {*self._modifiers(word), *(w.norm for w in self.words[max(0, word.i - 1) : word.i])}
        if kind not in PERSONS or not before & {"a", "an"}:
            return None
        colon = next((w.i for w in self.words[:16] if w.norm == ":" and w.sentence == 0), None)
        if colon is None or word.i < colon or any(w.norm in ("a", "an") for w in self.words[:colon]):
            return None
        told = [e for e in self.entities if e.mentions and e.mentions[0].word < colon and e.type in PERSONS]
        if len(told) != 1 or told[0].count != 1 or any(m.word > colon for m in told[0].mentions):
            return None
        same = told[0].type == kind or {told[0].type, kind} == {"pedestrian", "child"}
        return told[0] if same else None

    def _told_again(self, word: Word, kind: str, noun: str, count: int) -> Entity | None:
        """Who was told of in short before: "a car hit a woman. According to the police, a grey estate car was ...";
        a bare plural that was counted before ("two donkeys stood there. ... Donkeys unbothered")."""
        before = set(self._modifiers(word)) | {w.norm for w in self.words[max(0, word.i - 1) : word.i]}
        after = self.words[word.i + 1] if word.i + 1 < len(self.words) else word
        described = after.tag in ("VBN", "VBG", "VBD", "IN") or after.norm == ","
        begun = self.of.get(0)
        counted = count > 1 and word.sentence > 0 and before & {*language.table("actors")["counts"]}
        if begun is not None and counted and begun.noun == noun and begun.count > 1 and len(begun.mentions) == 1:
            begun.count = count  # "Cyclists abreast. Ego catches up with three cyclists"
            return begun
        if (
            count > 1
            and kind in PERSONS
            and word.i
            and self.words[word.i - 1].sentence != word.sentence
            and not described
        ):
            return next((e for e in self.entities if e.noun == noun and e.count > 1), None)
        if count > 1 or kind not in VEHICLES or "a" not in before or before & {"another", "second", "third", "other"}:
            return None
        for entity in self.entities:
            first = self.words[entity.mentions[0].word] if entity.mentions else word
            verb = self.words[first.head]
            named = [m for m in entity.mentions if m.kind != "pronoun"]  # not "it happened at ten"
            briefly = entity.noun in ("car", "vehicle") and len(named) == 1 and first.sentence < word.sentence
            hits = verb.lemma in HITS and verb.tag in ("VBD", "VBN") or self.words[verb.head].lemma in HITS
            if briefly and hits and entity.count == 1:
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

    def _elsewhere(self, word: Word) -> bool:
        """Whether a noun behind another's place has a place of its own: "ego in the right lane, a van behind it"."""
        first = self.words[word.head]
        placed = any(self.words[c].dep == "prep" and first.i < c < word.i for c in first.children)
        return placed and any(self.words[c].dep in ("prep", "advmod") and c > word.i for c in word.children)

    def _heading(self, sentence: int) -> bool:
        """Whether a sentence is a title: without a finite verb, or the headline of a report."""
        return sentence not in self.told or sentence == 0 and self.headlined

    def _after_ego(self, word: Word, entity: Entity) -> bool:
        """Whether ego was told of between a title and "another": "Vehicle pulling out. Ego drives. Another ..."."""
        first = self.words[entity.mentions[0].word]
        after = self.words[min(first.i + 1, len(self.words) - 1)]
        if self._modifiers(first) or first.norm != "vehicle" or after.tag != "VBG":
            return False
        return any(entity.mentions[0].word < m.word < word.i for m in self.ego.mentions)

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

"""The words of clauses as patterns see them: what is a verb, its base form, what belongs to its clause."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.motions import base_form, verb_lemmas
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

PLACES = {"speed": "#speed", "distance": "#dist", "time": "#time", "acceleration": "#acc", "percent": "#percent"}


CLAUSAL = frozenset(("advcl", "relcl", "ccomp", "acl", "csubj", "csubjpass", "parataxis", "pcomp", "xcomp"))


COMES_TO = language.words("comes_to")
ENDS_IN = language.words("ends_in")
LOOKS = language.words("looks") | language.words("colours")


class Rendering:
    """The lowest part of Clauses: verbs, their clauses, and both as text."""

    by_word: dict[int, Event]
    cast: Cast
    words: list[Word]

    def fragment(self, i: int) -> bool:
        """Whether a road user heads a sentence without a verb: "SUV, right lane, 15 m ahead"."""
        word = self.words[i]
        if word.span is None or word.span.kind not in ("actor", "label") or word.dep in ("pobj", "poss"):
            return False
        sentence = [w for w in self.words if w.sentence == word.sentence]
        first = next((w.i for w in sentence if w.i in self.cast.of and w.span is not None), None)
        return first == i and not any(w.i in self.by_word or w.tag in ("VBZ", "VBD", "VBP", "MD") for w in sentence)

    def about(self, i: int) -> list[int]:
        """The words of a fragment from its head up to the next road user of its own."""
        found: list[int] = []
        for word in self.words[i + 1 :]:
            other = self.cast.of.get(word.i)
            if (
                word.sentence != self.words[i].sentence
                or other is not None
                and not other.ego
                and word.dep not in ("pobj", "poss")
            ):
                break
            found.append(word.i)
        return found

    def _is_verb(self, word: Word) -> bool:
        if word.span is not None or word.dep in ("aux", "auxpass") or word.tag == "MD":
            return False
        if word.norm in ("slow", "near", "clear") and word.tag != "VB":
            return False
        if word.norm == "back" and word.i and self.words[word.i - 1].norm in ("and", "then", "straight", "right"):
            return False
        if word.norm in COMES_TO and word.i > 1 and self.words[word.i - 1].norm == "to":
            return word.head == word.i or self._lemma(self.words[word.head]) not in ENDS_IN  # "came to rest"
        if word.norm == "slow" and not any(self.words[c].dep in ("aux", "prt", "advmod") for c in word.children):
            return False
        if word.tag.startswith("VB"):
            return not (word.dep in ("amod", "compound") and word.tag in ("VBG", "VBN"))
        if (
            word.dep in ("ROOT", "conj", "ccomp", "advcl", "relcl", "acl")
            and word.tag in ("NNS", "NN", "JJ", "NNP", "NNPS", "IN", "RB")
            and self._lemma(word) in verb_lemmas()
        ):
            return word.norm != self._lemma(word) or word.tag not in ("NN", "JJ") or word.dep == "ROOT"
        return False

    def _lemma(self, word: Word) -> str:
        return base_form(word.norm, word.lemma)

    def own(self, word: Word) -> list[int]:
        """The words of a verb's clause, without the clauses inside it."""
        found = [word.i]
        stack = list(word.children)
        while stack:
            i = stack.pop()
            other = self.words[i]
            loose = other.dep == "dep" and other.tag in ("VBZ", "VBD") and i > word.i
            if (loose or other.dep in CLAUSAL or other.dep == "conj") and self._is_verb(other):
                continue
            if other.dep == "conj" and other.head == word.i and i in self.cast.of:
                continue  # "a van, which brakes, and a car": another one, beside what the van does
            found.append(i)
            stack += other.children
        if word.i + 1 < len(self.words) and self.words[word.i + 1].norm in ("left", "right"):
            found.append(word.i + 1)  # a side that the tree gives to another word
        return sorted(set(found))

    def render(self, indices: list[int], verb: int | None = None) -> str:
        """Words as patterns see them: lemmas of verbs, @names of road users, #kinds of quantities."""
        parts: list[str] = []
        for i in indices:
            word = self.words[i]
            if i == verb:
                parts.append(self._lemma(word))
            elif self._looks(word):
                continue
            elif word.span and word.span.kind == "quantity":
                mark = PLACES[word.span.data["dimension"]]
                if not parts or parts[-1] != mark:
                    parts.append(mark)
            elif i in self.cast.of:
                parts.append("@" + self.cast.of[i].key + (" 's" if word.tag == "PRP$" else ""))
            elif (word.tag.startswith("VB") and word.dep not in ("amod", "compound")) or word.tag == "MD":
                parts.append(self._lemma(word))
            else:
                parts.append(word.norm)
        return " ".join(parts)

    def _looks(self, word: Word) -> bool:
        """Whether a word only says how a road user looks, who is named right behind it: "a small red car"."""
        if word.norm not in LOOKS or word.span is not None or word.i in self.cast.of:
            return False
        behind = (w for w in self.words[word.i + 1 : word.i + 5] if w.norm not in LOOKS)
        first = next(behind, None)
        return first is not None and first.i in self.cast.of and first.span is not None

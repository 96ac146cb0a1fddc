"""Who does it where no subject stands before the verb: headings, notes, participles, subjects behind it."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.meanings import Meanings
from c2s_engine.interpret.who.mentions import Entity

CONTACT = language.words("contact")
DRIVES = language.words("drives")
REACTS = language.words("reacts")
ON_FOOT = language.words("on_foot")
STANDS_STILL = language.words("stands_still")
STEERS = language.words("steers")


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
        if self._writers_reaction(word):
            return self.cast.ego
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

    def _writers_reaction(self, word: Word) -> bool:
        """Whether a first person's note tells without a subject how its writer reacted: "Stood on the brakes"."""
        denied = any(self.words[c].dep == "neg" for c in word.children)
        return word.tag == "VBD" and not denied and self._lemma(word) in REACTS and self.cast.driven_by_me

    def _of_its_writer(self, word: Word) -> bool:
        """Whether a note tells without a subject what its writer did: "Lost control and hit a tree"."""
        if word.tag not in ("VBD", "VBN", "VBG") or word.dep not in ("ROOT", "conj", "advcl", "ccomp", "dep", "xcomp"):
            return False
        opening = [w for w in self.words[: word.i] if w.sentence == word.sentence]
        told = [w for w in opening if w.i in self.cast.of and w.dep not in ("pobj", "dobj", "poss") or w.tag == "VBZ"]
        finite = word.tag == "VBD" or any(w.tag == "VBD" for w in self.words if w.sentence == word.sentence)
        return finite and not told and self._headless(word)

    def _mark(self, word: Word) -> str:
        raise NotImplementedError

    def _late_by(self, word: Word) -> int | None:
        """Who did it, named by a "by" that the tree hangs lower: "is overtaken on the right by a van"."""
        for at in self._below(word.i):
            if at < word.i or self.words[at].norm != "by" or self.words[at].dep not in ("prep", "agent"):
                continue
            near = [c for c in self.words[at].children if c in self.cast.of and self.words[c].dep == "pobj"]
            if near and self.cast.of[near[0]].mover:
                return near[0]
        return None

    def _headless(self, verb: Word) -> bool:
        """Whether a note tells without a subject what became of its writer: "Braked for a cat, was hit by a van"."""
        opening = [w for w in self.words[: verb.i] if w.sentence == verb.sentence]
        return not any(w.dep in ("nsubj", "nsubjpass", "csubj", "expl") for w in opening)

    def _dangles(self, word: Word, agent: Entity) -> bool:
        """Whether a participle's object is the one taken for its agent ("following a truck, it stops"), or its main
        clause tells of somebody who cannot do it ("while reversing, a child was struck"): ego does it."""
        if agent.ego or any(self.words[c].dep in ("nsubj", "nsubjpass", "expl") for c in word.children):
            return False
        before = [w.i for w in self.words[max(0, word.i - 3) : word.i] if w.sentence == word.sentence]
        told = word.norm in STEERS and any(self.cast.of.get(i) is agent for i in before)
        if told or None is agent:
            return False  # "a man, driving his van at 40 mph, came from the left"
        if self._fronted_drive(word, agent):
            return True
        return any(self.words[c].dep == "dobj" and self.cast.of.get(c) is agent for c in word.children)

    def _fronted_drive(self, word: Word, agent: Entity) -> bool:
        """Whether a participle that opens its sentence tells what ego did when the subject came or hit it."""
        main = self._governor(word)
        opens = not any(w.sentence == word.sentence and w.i in self.cast.of for w in self.words[: word.i])
        if main is None or main.i < word.i or not opens:
            return False
        if agent.person:
            return self._lemma(word) in DRIVES
        if agent.type == "bicycle" or self._lemma(word) not in STANDS_STILL:
            return self._lemma(word) in ("drive", "reverse") and agent.type == "bicycle"
        objects = [c for i in main.children if i > main.i for c in self._below(i)]
        return self._lemma(main) in CONTACT and any(self.cast.of.get(c) is self.cast.ego for c in objects)

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

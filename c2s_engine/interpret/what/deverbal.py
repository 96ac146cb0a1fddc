"""Nouns of motion read as the verbs that they come from: "the departure of a van", "its merging ahead of ego"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.nominal import Nominal

REACTS = frozenset(("react", "respond", "answer", "adapt", "adjust"))
GERUNDS = ("ROOT", "nsubj", "nsubjpass", "pobj", "attr", "dobj", "conj", "pcomp", "csubj")
OBJECTS = frozenset(("leave", "enter"))
SIDES = ("left", "right")
PLACES_TOO = frozenset(("stop", "halt", "exit", "entrance", "entry", "crossing", "start", "departure"))
NAMES_IT = frozenset(("manoeuvre", "maneuver", "movement", "attempt", "action"))


class Deverbal(Nominal):
    """The part of Clauses that reads a noun of motion with the words of its verb, where it is told whose deed it is."""

    deeds: set[int]

    def _reads_motion_noun(self, word: Word) -> bool:
        """Whether a noun of motion told what somebody does, as its verb would."""
        verb = self._its_verb(word)
        completes = word.dep == "dobj" and any(self.words[c].tag == "PRP$" for c in word.children)
        if verb is None or word.span is not None or completes:  # "it completes its turn"
            return False
        lemma, noun = verb
        of, by = self._named_by(noun, ("of",)), self._named_by(noun, ("by", "from"))
        whose = next((c for c in noun.children if self.words[c].dep == "poss" and c in self.cast.of), None)
        if word.norm in PLACES_TOO:  # "pulls out from its stop"
            whose = None
        doer = next((at for at in (by, whose) if at is not None), None)
        done_to = lemma in language.table("motions")["deeds"]["transitive"] and noun is word
        if doer is None and not done_to:
            doer, of = of, None
        agent = self.cast.of.get(doer) if doer is not None else None
        if agent is None or doer is None or not (agent.mover or agent.ego):
            return False
        patient = self.cast.of.get(of) if of is not None else None
        rest = [
            i
            for i in self._below(min(noun, word, key=self._depth).i)
            if i not in (doer, word.i) and self._told(i, doer)
        ]
        later = [i for i in rest if i > word.i]
        before = self.render([i for i in rest if i < word.i])
        own = [
            w for i in rest if i < word.i and ((w := self.words[i].norm) in SIDES or self.words[i].dep == "compound")
        ]
        after = re.sub(r"^(of|from) " if lemma in OBJECTS else "^of ", "", self.render(later))
        text = " ".join([lemma, *own, after]).strip()
        if patient is None or patient is agent:
            near = (self.cast.of[i] for i in later if i in self.cast.of)
            patient = next((e for e in near if e is not agent), None)
        event = self._event(lemma, word, text, f"{before} {text}", agent, patient)
        if event is None or event.act in ("travel", "none") or event.agent is not agent:
            return False
        if event.act == "turn" and not own or event.act == "start" and "lane" in own:  # "it is our turn"
            return False
        event.words = sorted({word.i, *rest, doer})
        event.start, event.end = word.start, self.words[event.words[-1]].end
        event.quantities, event.mode = self._quantities(event.words), self._denied(noun)
        self.events.append(event)
        self.by_word[word.i] = event
        self.deeds.add(doer)
        return True

    def _its_verb(self, word: Word) -> tuple[str, Word] | None:
        """The verb that a noun comes from, and the noun that its owner stands with ("the overtaking manoeuvre of")."""
        verbs = language.table("motions")["deeds"]["verbs"]
        above = self.words[word.head]
        noun = above if above.norm in NAMES_IT and word.dep in ("compound", "amod", "nmod") else word
        held = [c for c in word.children if self.words[c].norm == "of"] if word.norm == "loss" else []
        noun = next((self.words[c] for i in held for c in self.words[i].children), noun)  # "loss of control of the van"
        if word.norm in verbs:
            return (verbs[word.norm], noun) if word.tag.startswith(("NN", "VBG")) else None
        of = any(self.words[c].norm in ("of", "by") for c in noun.children)
        gerund = word.tag == "VBG" or word.tag == "NN" and word.norm.endswith("ing")
        if not gerund or not of or noun is word and word.dep not in GERUNDS:
            return None
        plain = not any(self.words[c].dep in ("nsubj", "aux", "dobj") for c in word.children)
        return (self._lemma(word), noun) if plain else None

    def _named_by(self, noun: Word, prepositions: tuple[str, ...]) -> int | None:
        """The road user that a preposition joins to a noun."""
        for child in noun.children:
            if child > noun.i and self.words[child].norm in prepositions:
                for target in self.words[child].children:
                    if self.words[target].dep == "pobj" and self.cast.referent(target) is not None:
                        return target if target in self.cast.of else None
        return None

    def _depth(self, word: Word) -> int:
        """How far a word is below the head of its sentence."""
        found = 0
        while word.head != word.i:
            word, found = self.words[word.head], found + 1
        return found

    def _told(self, i: int, doer: int) -> bool:
        """Whether a word belongs to the clause that the noun stands for, not to the name of who does it."""
        word, above = self.words[i], self.words[self.words[doer].head]
        own = above.i == i and above.norm in ("of", "by", "from")
        return not own and word.dep != "case" and not (word.head == doer and i < doer)

    def _denied(self, noun: Word) -> str:
        """Whether what a noun names happens."""
        text = " ".join(w.norm for w in self.words[max(0, noun.i - 5) : noun.i] if w.sentence == noun.sentence)
        apart = any(word in text.split() for word in ("no", "without", "avoid", "avoids", "prevent", "prevents"))
        verb = self.words[noun.head]
        apart = apart or noun.dep.startswith("nsubj") and any(self.words[c].dep == "neg" for c in verb.children)
        return "negated" if apart else "fact"

"""Who is spoken of most: whom a word without a noun of its own most likely means."""

from __future__ import annotations

from collections.abc import Callable

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.motions import irregular
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.excluded import Excluded
from c2s_engine.interpret.who.place_words import BESIDE

MINE = frozenset(language.table("actors")["pronouns"]["ego"])
STRIKES = language.words("strikes")
CONTACT = STRIKES | language.words("contact")
WAITS = language.words("waits")
GONE = ("go", "pass", "clear", "leave", "vanish", "disappear", "cross")


class Salience(Excluded):
    """The part of Cast that finds who is spoken of, by the grammar of the words before."""

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

    def _salient(self, word: Word, accept: Callable[[Entity], bool]) -> Entity | None:
        verb = self._governor(word)
        clash = None
        if (
            word.dep == "nsubj"
            and verb.dep in ("ccomp", "xcomp")
            and self.words[verb.head].lemma
            in ("let", "lets", "allow", "make", "force", "cause", "see", "help", "wait", "follows", "permit", "enable")
        ):
            clash = self._subject_of(self.words[verb.head])
        if word.dep in ("dobj", "pobj") and word.norm not in ("its", "itself"):
            clash = self._subject_of(verb)
        if word.dep == "nsubj" and (gone := self._gone_before(word, verb)) is not None:
            clash = gone
        if word.dep == "poss" and verb.lemma in STRIKES and self.words[word.head].dep in ("dobj", "pobj"):
            clash = self._subject_of(verb)
        above = self.words[word.head]
        if word.dep == "poss" and BESIDE.match(self._around(word.i)) and above.dep == "pobj":
            placed = self.words[self.words[above.head].head]
            clash = self.of.get(placed.i) or clash  # "a coach to its left": not the coach's own
        holder = self._placed(word)
        subject = clash
        if holder is not None and holder is not clash:
            inner, accept_all = holder, accept
            clash = None
            accept = lambda e: accept_all(e) and e is not inner  # noqa: E731
        same = [(i, e) for i, e in self.subjects if i < word.i and accept(e) and e is not clash]
        last = [i for i in sorted(self.of) if i < word.i and accept(self.of[i]) and self.of[i] is not clash]
        if word.norm in ("it", "its"):  # "a car in the lane to our left. Its driver": not ours
            last = [i for i in last if self.words[i].norm not in MINE and i not in self.both] or last
        if not last:
            beside = holder is not None and holder is not subject and subject is not None
            return (
                subject if beside and subject and accept(subject) else None
            )  # "the lorry hides a motorcycle behind it"
        sentence = [p for p in same if self.words[p[0]].sentence == word.sentence]
        if word.dep == "poss":
            own = self._subject_of(verb)
            beside = False
            if own is not None and accept(own) and own is not clash:
                return own
        told = [p for p in sentence if self._finite(self._governor(self.words[p[0]]))]
        told = [p for p in told if self._governor(self.words[p[0]]).dep != "pcomp"] or told
        sentence = told or sentence
        if word.dep in ("dobj", "pobj", "poss"):
            near = self._unplacing(word, clash, [i for i in last if self.words[i].sentence == word.sentence])
            if clash is not None and near:
                before = self._governor(self.words[sentence[-1][0]]) if sentence else word
                fronted = before.dep == "advcl" and before.i < word.i < verb.i  # "while V1 waited, a car behind it"
                struck = (
                    verb.dep == "advcl" and irregular().get(verb.norm, verb.lemma) in CONTACT and before.i == verb.head
                )
                if struck and any(self.words[c].norm == "when" for c in verb.children):
                    return sentence[-1][1]  # "V1 was stopped behind a bus when a van struck it"
                return sentence[-1][1] if fronted and before.head == verb.i else self.of[near[-1]]
            if sentence:
                return sentence[-1][1]
            return self.of[last[-1]]
        if sentence:
            return sentence[-1][1]
        earlier = [p for p in same if self.words[p[0]].sentence == word.sentence - 1]
        if earlier:
            mains = [p for p in earlier if self._main_subject(p[0])]
            return (
                (mains or earlier)[0][1]
                if len({id(e) for _, e in (mains or earlier)}) == 1
                else (mains or earlier)[-1][1]
            )
        return self.of[last[-1]]

    def _gone_before(self, word: Word, verb: Word) -> Entity | None:
        """Who is gone when another acts: "once the van has passed, it ...", "with the van gone it ..."."""
        for child in verb.children:
            other = self.words[child]
            if other.dep == "advcl" and child < word.i and other.tag == "VBN" and other.lemma in GONE:
                return self._subject_of(other)
        return None

    def _placed(self, word: Word) -> Entity | None:
        """Who is placed by a pronoun: the truck of "the truck ahead of it"."""
        above = self.words[word.head]
        if word.dep != "pobj":
            return None
        between = ("lane", "side", "space", "row", "bay")
        while above.head != above.i and above.head not in self.of:
            over = self.words[above.head]
            if not (
                above.norm in ("of", "to")
                and over.tag in ("RB", "IN", "NN")
                or {over.norm, above.norm} & set(between)
                or above.norm in ("front", "back", "rear")
                and over.tag == "IN"
            ):
                break
            above = over
        return self.of.get(above.head) if above.head < word.i and above.head != above.i else None

    def _finite(self, verb: Word) -> bool:
        """Whether a verb is no infinitive ("for the traffic to clear")."""
        return not any(self.words[c].norm == "to" and self.words[c].dep == "aux" for c in verb.children)

    def _main_subject(self, i: int) -> bool:
        return self.words[self.words[i].head].dep in ("ROOT", "conj", "ccomp")

    def _governor(self, word: Word) -> Word:
        current = word
        while current.head != current.i and not current.verb:
            current = self.words[current.head]
        return current

    def _subject_of(self, verb: Word) -> Entity | None:
        current = verb
        if any(self.words[c].dep == "expl" for c in verb.children):
            return None
        for _ in range(5):
            for child in current.children:
                if self.words[child].dep in ("nsubj", "nsubjpass"):
                    return self.referent(child)
            if current.dep in ("acl", "relcl") and current.head in self.of:
                return self.of[current.head]
            if current.head == current.i:
                return None
            current = self._governor(self.words[current.head])
        return None

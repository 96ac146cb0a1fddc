"""Who is spoken of most: whom a word without a noun of its own most likely means."""

from __future__ import annotations

import re
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
BOWS = language.words("bows")
WAITS = language.words("waits")
GONE = ("go", "pass", "clear", "leave", "vanish", "disappear", "cross")
STANDS = ("be", "stand", "sit", "wait", "appear")
GOES = ("drive", "run", "travel", "ride", "cruise", "keep", "stay", "hang", "move", "go", "come")
SHIFTS = frozenset(("move", "merge", "change", "pull", "drift", "swerve", "cut", "switch", "shift", "slide", "swing"))
PAST = frozenset(("around", "round", "past"))
LETS = ("let", "lets", "allow", "permit")
AT_TAIL = re.compile(r"(off|on|from|behind) (rear|back|bumper|tail)\b")


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
        if word.dep == "nsubj" and {"until", "till"} & {self.words[c].norm for c in verb.children if c < word.i}:
            main = self.words[verb.head]
            if irregular().get(main.norm, main.lemma) in WAITS or any(
                self.words[c].dep == "neg" for c in main.children
            ):
                clash = self._subject_of(main)  # one waits until another has passed; one slows until it stands itself
        if word.dep in ("dobj", "pobj") and word.norm not in ("its", "itself"):
            clash = self._subject_of(verb)
        if word.dep == "nsubj" and (gone := self._gone_before(word, verb)) is not None:
            clash = gone
        if word.dep == "nsubj" and self._enabled(word, verb):
            clash = self._subject_of(self.words[verb.head])  # "ego moves over so that it can get past"
        if word.dep == "poss" and verb.lemma in STRIKES and self.words[word.head].dep in ("dobj", "pobj"):
            clash = self._subject_of(verb)
        above = self.words[word.head]
        if word.dep == "poss" and above.norm in BOWS and self.words[max(0, word.i - 1)].norm == "across":
            clash = self._subject_of(verb)  # nobody goes across its own bows
        if word.dep == "poss" and BESIDE.match(self._around(word.i)) and above.dep == "pobj":
            placed = self.words[self.words[above.head].head]
            if placed.norm in ("lane", "side"):  # "five cars in the lane to its left"
                placed = self.words[self.words[placed.head].head]
            clash = self.of.get(placed.i) or clash  # "a coach to its left": not the coach's own
        if word.dep == "nsubj" and (polite := self._lets_before(word, verb)) is not None:
            return polite
        holder = self._placed(word)
        subject = clash
        if holder is not None and holder is not clash:
            inner, accept_all = holder, accept
            clash = None
            accept = lambda e: accept_all(e) and e is not inner  # noqa: E731
        if (word.dep == "nsubj" or self._whose_driver(word, verb)) and (whom := self._object_nouns(verb)):
            accept_any = accept
            accept = lambda e: accept_any(e) and e.noun not in whom  # noqa: E731
        if word.dep == "nsubj" and self._placed_by_ego(verb):
            accept_others = accept
            accept = lambda e: accept_others(e) and not e.ego  # noqa: E731
        if (word.dep == "nsubj" or self._whose_driver(word, verb)) and (labels := self._object_labels(verb)):
            accept_other = accept
            accept = lambda e: accept_other(e) and e.label not in labels and not (e.ego and "1" in labels)  # noqa: E731
        same = [(i, e) for i, e in self.subjects if i < word.i and accept(e) and e is not clash]
        last = [i for i in sorted(self.of) if i < word.i and accept(self.of[i]) and self.of[i] is not clash]
        if word.norm in ("it", "its"):  # "a car in the lane to our left. Its driver": not ours
            told = [i for i in last if self.words[i].norm not in MINE and i not in self.both]
            last = told or last
        if not last:
            subject = subject or self._ego_to_come(verb)
            beside = holder is not None and holder is not subject and subject is not None
            return (
                subject if beside and subject and accept(subject) else None
            )  # "the lorry hides a motorcycle behind it"
        sentence = [p for p in same if self.words[p[0]].sentence == word.sentence]
        if word.dep == "poss":
            twin = self._parallel(word)
            if twin is not None:
                return twin
            own = self._subject_of(verb)
            if self._whose_driver(word, verb):
                own = None  # "the coach was in the right lane when its driver saw": not the driver's own
            beside = self._on_its_side(word, verb)
            into = self._into_lane(word, verb)
            if beside or into:
                clash, own = own, None  # nobody is on its own left, or comes into its own lane
                last = [i for i in last if self.of[i] is not clash]
                if not last:
                    return None
                sentence = [p for p in sentence if p[1] is not clash]
                spoken = {self.of[i] for i in last if self.words[i].sentence == word.sentence}
                if (beside or into and clash is not self.ego) and self.ego in spoken:
                    return self.ego  # "ego follows a truck, with a car keeping pace on its left"
            its = [
                self.of[w.i]
                for w in self.words[: word.i]
                if w.sentence == word.sentence and w.norm == "it" and w.i in self.of
            ]
            if its and its[-1] is not own and "another" in self._near(word):
                return its[-1]
            if own is not None and accept(own) and own is not clash:
                return own
        told = [p for p in sentence if self._finite(self._governor(self.words[p[0]]))]
        told = [p for p in told if self._governor(self.words[p[0]]).dep != "pcomp"] or told
        sentence = told or sentence
        if word.dep in ("dobj", "pobj", "poss"):
            if self.words[word.head].norm in PAST and (led := self._object_of(verb, word.i)) is not None:
                last = [i for i in last if self.of[i] is not led] or last  # "follows the van around it"
            near = self._unplacing(word, clash, [i for i in last if self.words[i].sentence == word.sentence])
            if clash is not None and near:
                before = self._governor(self.words[sentence[-1][0]]) if sentence else word
                fronted = before.dep == "advcl" and before.i < word.i < verb.i  # "while V1 waited, a car behind it"
                if sentence and verb.dep == "advcl" and sentence[-1][0] < near[-1] < before.i == verb.head:
                    return sentence[-1][1]  # "a truck ahead of ego brakes because a car cuts in in front of it"
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

    def _enabled(self, word: Word, verb: Word) -> bool:
        """Whether one is whom another makes something possible for ("so that it can get past")."""
        before = [w.norm for w in self.words[max(0, word.i - 2) : word.i]]
        may = any(self.words[c].norm in ("can", "could", "may", "might") for c in verb.children)
        return verb.dep == "advcl" and may and (before == ["so", "that"] or before[-1:] == ["so"])

    def _gone_before(self, word: Word, verb: Word) -> Entity | None:
        """Who is gone when another acts: "once the van has passed, it ...", "with the van gone it ..."."""
        for child in verb.children:
            other = self.words[child]
            if other.dep == "advcl" and child < word.i and other.tag == "VBN" and other.lemma in GONE:
                return self._subject_of(other)
        return None

    def _lets_before(self, word: Word, verb: Word) -> Entity | None:
        """Who lets others go before it does something: "ego lets a cyclist and a car pass before it turns"."""
        if not {"before", "then", "afterwards"} & {self.words[c].norm for c in verb.children if c < word.i}:
            return None
        lets = [w for w in self.words[: word.i] if w.sentence == word.sentence and w.verb and w.lemma in LETS]
        return self._subject_of(lets[-1]) if lets else None

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
        if (held := self._held_before(self.words[above.head], above)) is not None:
            return held
        return self.of.get(above.head) if above.head < word.i and above.head != above.i else None

    def _ego_to_come(self, verb: Word) -> Entity | None:
        """Ego, where it is named only later, as the subject ("with a van in front of it, ego ...")."""
        spans = [self.words[c].span for c in verb.children if self.words[c].dep == "nsubj"]
        return self.ego if any(s is not None and s.kind == "ego" for s in spans) else None

    def _finite(self, verb: Word) -> bool:
        """Whether a verb is no infinitive ("for the traffic to clear")."""
        return not any(self.words[c].norm == "to" and self.words[c].dep == "aux" for c in verb.children)

    def _on_its_side(self, word: Word, verb: Word) -> bool:
        """Whether somebody stands or goes along on the side that a possessive names: it is not its own side."""
        if AT_TAIL.match(self._around(word.i)):
            if any(w.span is not None and w.i in self.of for w in self.words[verb.i + 1 : word.i]):
                return False  # "ego drives with a van on its tail"
            return verb.lemma in STANDS or verb.lemma in GOES
        if not BESIDE.match(self._around(word.i)):
            return False
        lane = [w.norm for w in self.words[max(0, word.i - 4) : word.i]][-3:-1] == ["the", "lane"]
        return verb.lemma in STANDS or verb.lemma in GOES and (lane or verb.lemma == "keep")

    def _whose_driver(self, word: Word, verb: Word) -> bool:
        """Whether a possessive belongs to the driver who is the subject of its clause."""
        held = self.words[word.head]
        return held.lemma in ("driver", "operator", "rider") and held.head == verb.i and held.dep.startswith("nsubj")

    def _into_lane(self, word: Word, verb: Word) -> bool:
        """Whether somebody comes from elsewhere into the lane that a possessive names."""
        after = [w.norm for w in self.words[word.i + 1 : word.i + 3]]
        clause = {w.norm for w in self.words[verb.i : word.i]}
        comes = verb.lemma in ("cross", "encroach", "intrude", "invade", "veer", "come", "stray")
        shifts = irregular().get(verb.norm, verb.lemma) in SHIFTS and self._subject_of(verb) is not self.ego
        return (
            (comes or shifts and "into" in clause)
            and bool({"lane", "path"} & set(after))
            and not {"back", "again", "own", "return", "then"} & (clause | set(after))
        )

    def _main_subject(self, i: int) -> bool:
        return self.words[self.words[i].head].dep in ("ROOT", "conj", "ccomp")

    def _governor(self, word: Word) -> Word:
        current = word
        while current.head != current.i and not current.verb:
            current = self.words[current.head]
        return current

    def _taken_for_conjunct(self, verb: Word) -> Entity | None:
        """The subject that the tree joins to the verb before: "ego goes straight and the van, skidding, hits it"."""
        joined = self.words[verb.head].children if verb.dep == "conj" and self.words[verb.head].verb else []
        nouns = [c for c in joined if c < verb.i and self.words[c].noun and c in self.of]
        nouns = [c for c in nouns if self.words[min((c, *self.words[c].children)) - 1].norm in ("and", "but")]
        return self.of[nouns[-1]] if nouns else None

    def _subject_of(self, verb: Word) -> Entity | None:
        current = verb
        if any(self.words[c].dep == "expl" for c in verb.children):
            return None
        for _ in range(5):
            for child in current.children:
                if self.words[child].dep in ("nsubj", "nsubjpass"):
                    return self.referent(child)
            if (taken := self._taken_for_conjunct(current)) is not None:
                return taken
            if current.dep in ("acl", "relcl") and current.head in self.of:
                return self.of[current.head]
            if current.head == current.i:
                return None
            current = self._governor(self.words[current.head])
        return None

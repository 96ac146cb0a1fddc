"""Whom pronouns, "another", "the latter" and parts ("its left front") mean."""

from __future__ import annotations

from collections.abc import Callable

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.possessives import Possessives

SIDES = frozenset(("left", "right", "rear", "front", "side", "nearside", "offside"))
LOOSE = frozenset(("debris", "box", "obstacle"))
THINGS = LOOSE | {"container", "trash", "barrier", "lane_closure"}
DOES = language.words("manoeuvres") | language.words("drives") | language.words("on_foot") | {"cross", "start", "do"}
BUMPED = language.words("bumped")
MOVES = language.word_list("motion") | {"leave"}
ROOTED = frozenset(language.table("actors")["fixed"]) | {"tree", "trees"}
"""What no "it" that moves can mean."""


class Pronouns(Possessives):
    """The part of Cast that resolves words without a noun of their own."""

    words: list[Word]
    entities: list[Entity]
    ego: Entity
    me: Entity
    of: dict[int, Entity]
    subjects: list[tuple[int, Entity]]
    asking: frozenset[int]

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

    def _new(self, entity: Entity) -> Entity:
        raise NotImplementedError

    def _pronoun(self, word: Word) -> Entity | None:
        data = language.table("actors")["pronouns"]
        norm = word.norm
        if self._on_foot(word):
            return self._new(Entity("", "pedestrian", noun=norm, typed=True))
        if norm in data["ego"]:
            mine = None if word.i in self.asking else self.me
            return self._we_all(word) if mine is self.ego and norm == "we" else mine
        taken = norm == "that" and word.dep == "nsubj" and self.words[word.head].dep == "relcl"  # for "that one"
        if norm in ("who", "which", "that", "whose", "whom") and (word.tag in ("WDT", "WP", "WP$") or taken):
            return self._somebody(word, self._antecedent(word))
        if norm in ("it", "its", "itself"):
            if word.dep == "expl":
                return None
            if (
                word.dep == "dobj"
                and self.words[word.head].lemma in ("enter", "exit", "join", "leave")
                and word.norm == "it"
            ):
                return None  # the roundabout
            return self._thing(word)
        if norm in ("himself", "herself", "itself") and word.dep in ("nsubj", "npadvmod", "appos"):
            return None  # "the driver himself moved out"
        if norm in data["person"]:
            return self._he(word)
        if norm in ("they", "them", "their", "themselves"):
            many = [e for e in self.entities if e.count > 1]
            last = max((i for i in self.of if i < word.i and self.words[i].span is not None), default=None)
            if last is not None and self.of[last].type in LOOSE and word.sentence - self.words[last].sentence <= 1:
                return self.of[last]  # "two sheets of plywood, and they were lying in our lane"
            if many:
                return many[-1]
            person = [e for e in self.entities if e.person]
            if person and norm in ("their", "they", "them"):
                return person[-1]
            return self._salient(word, lambda e: e.mover)
        return self._elliptic(word)

    def _we_all(self, word: Word) -> Entity:
        """Ego, with all others where "we all" stand for them."""
        others = [e for e in self.entities if e.mover and not e.person]
        if others and self.words[word.i + 1].norm in ("all", "both") and word.dep == "nsubj":
            self.both[word.i] = others
        return self.ego

    def _thing(self, word: Word) -> Entity | None:
        """The vehicle or thing that "it" means; an animal where it is hit or avoided."""
        bumped = word.i > 0 and self.words[word.i - 1].norm in BUMPED
        things = THINGS if bumped else LOOSE
        i = self._first_person() and not self._ego_is_thing()
        moves = word.dep == "nsubj" and self.words[word.head].lemma in MOVES
        joint = [
            e
            for at, others in self.both.items()
            if word.dep == "nsubj" and self.words[at].sentence == word.sentence
            for e in (self.of[at], *others)
            if at in self.of
        ]  # "after both have passed, it sets off"

        def fits(e: Entity) -> bool:
            alive = e.person and not e.noun.endswith(("target", "dummy"))
            if moves and e.noun in ROOTED or e in joint:
                return False
            return (not alive and e.sex != "i" and e.mover or e.type in things) and not (i and e.ego)

        apart = self._not_he(word, fits)
        vehicle = lambda e: fits(e) and e.count == 1  # noqa: E731
        if word.dep != "nsubj" and any(
            vehicle(e) for i, e in self.of.items() if self.words[i].sentence == word.sentence
        ):
            apart = apart or self._salient(word, vehicle)  # "a van was overtaking a cyclist when the car behind it"
        return apart or self._salient(word, lambda e: fits(e) and e.count == 1) or self._salient(word, fits)

    def _not_he(self, word: Word, accept: Callable[[Entity], bool]) -> Entity | None:
        """Whom "it" means beside a "he" of the same sentence: "while he came up on the bus, its driver moved out"."""
        before = [w for w in self.words[: word.i] if w.sentence == word.sentence and w.i in self.of]
        person = [w for w in before if w.norm in ("he", "she") or w.span is not None and w.span.data.get("person")]
        he = [self.of[w.i] for w in person]
        if not he or word.dep != "poss":
            return None
        others = [self.of[w.i] for w in before if self.of[w.i] not in he and accept(self.of[w.i])]
        things = [self.of[w.i] for w in before if w.span is not None and w not in person]
        return others[-1] if others and he[-1] not in things else None

    def _ego_is_thing(self) -> bool:
        """Whether ego was spoken of as a vehicle, too ("our test car")."""
        return any(m.kind in ("ego", "label", "actor") and self.words[m.word].norm != "i" for m in self.ego.mentions)

    def _antecedent(self, word: Word) -> Entity | None:
        verb = self.words[word.head]
        clause = verb
        for _ in range(4):
            if clause.dep == "relcl":
                break
            if clause.head == clause.i:
                break
            clause = self.words[clause.head]
        if clause.dep == "relcl" and clause.head in self.of and clause.head < word.i:
            return self.of[clause.head]
        previous = [
            i
            for i in sorted(self.of)
            if i < word.i and self.words[i].sentence == word.sentence and self.words[i].tag != "PRP$"
        ]
        if not previous:
            return None
        between = self.words[previous[-1] + 1 : word.i]
        if (
            any(w.noun and w.norm not in SIDES for w in between)
            and clause.dep == "relcl"
            and self.words[clause.head].span is None
        ):
            head = self.words[clause.head]
            if head.norm in ("lane", "road") and verb.lemma in DOES:  # "the van in the right lane, which drives at 80"
                return self.of[next((i for i in reversed(previous) if self.words[i].dep != "poss"), previous[-1])]
            return self.of.get(head.i) if head.i in self.of else None
        return self.of[previous[-1]]

    def _somebody(self, word: Word, found: Entity | None) -> Entity | None:
        """Whom "who" means where a person is placed by the vehicle before: "a child behind a van who runs across"."""
        if word.norm != "who" or found is None or found.person or found.ego:
            return found
        nouns = [
            w for w in self.words[: word.i] if w.sentence == word.sentence and w.i in self.of and w.span is not None
        ]
        last = next((w for w in reversed(nouns) if self.of[w.i] is found), None)
        above = self.words[self.words[last.head].head] if last is not None and last.dep == "pobj" else None
        held = self.of.get(above.i) if above is not None and above.noun else None
        return held if held is not None and held.person else found

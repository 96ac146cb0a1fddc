"""Whom pronouns, "another", "the latter" and parts ("its left front") mean."""

from __future__ import annotations

import re
from collections.abc import Callable

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import PERSONS, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.nearing import comes_near
from c2s_engine.interpret.who.taken_up import taken_up
from c2s_engine.interpret.who.theirs import Theirs

RIDDEN = frozenset(("bicycle", "motorcycle", "rider"))
SIDES = frozenset(("left", "right", "rear", "front", "side", "nearside", "offside"))
LOOSE = frozenset(("debris", "box", "obstacle"))
THINGS = LOOSE | {"container", "trash", "barrier", "lane_closure"}
DOES = language.words("manoeuvres") | language.words("drives") | language.words("on_foot") | {"cross", "start", "do"}
STANDS = frozenset(("parked", "stationary"))
HAS = frozenset(("on", "in", "with", "aboard", "astride", "behind"))
"""How one is told to have something with oneself."""
OWNERS = frozenset(language.table("actors")["with_animals"])
BUMPED = language.words("bumped")
MOVES = language.word_list("motion") | {"leave"}
ROOTED = frozenset(language.table("actors")["fixed"]) | {"tree", "trees"}
"""What no "it" that moves can mean."""


class Pronouns(Theirs):
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
            mine = None if word.i in self.asking or self._only_a_name(word) else self.me
            return self._we_all(word) if mine is self.ego and norm == "we" else mine
        taken = norm == "that" and word.dep == "nsubj" and self.words[word.head].dep == "relcl"  # for "that one"
        if norm in ("who", "which", "that", "whose", "whom") and (word.tag in ("WDT", "WP", "WP$") or taken):
            return self._somebody(word, self._antecedent(word))
        if norm in ("it", "its", "itself"):
            if word.dep == "expl" or self._weather_it(word) or self._after_a_toy(word):
                return None
            if (
                word.dep == "dobj"
                and self.words[word.head].lemma in ("enter", "exit", "join", "leave")
                and word.norm == "it"
            ):
                return None  # the roundabout
            if self._obliged(word):
                return self.ego
            return self._thing(word)
        if norm in ("himself", "herself", "itself") and word.dep in ("nsubj", "npadvmod", "appos"):
            return None  # "the driver himself moved out"
        if (owner := self._has_it(word)) is not None:
            return self.of.get(owner.i)
        if norm in data["person"]:
            return self._he(word)
        if norm == "them" and self.words[word.i + 1 : word.i + 2] and self.words[word.i + 1].norm == "both":
            return self._together(word)
        if norm in ("they", "them", "their", "themselves"):
            if (drives := self._theirs(word)) is not None:
                return drives
            if self.words[word.i - 1].norm in BUMPED and (lying := self._lies_before(word)) is not None:
                return lying  # "strips of tyre lie there. The van swerves around them"
            many = [e for e in self.entities if e.count > 1]
            last = max((i for i in self.of if i < word.i and self.words[i].span is not None), default=None)
            if last is not None and self.of[last].type in LOOSE and word.sentence - self.words[last].sentence <= 1:
                return self.of[last]  # "two sheets of plywood, and they were lying in our lane"
            if many:
                return many[-1]
            joint = self._joint(word)
            if joint is not None:
                return self._all_of(word, joint)
            person = [e for e in self.entities if e.person]
            if person and norm in ("their", "they", "them"):
                return person[-1]
            return self._salient(word, lambda e: e.mover)
        return self._elliptic(word) or self._unknown(word)

    def _we_all(self, word: Word) -> Entity:
        """Ego, with all others where "we all" stand for them."""
        others = [e for e in self.entities if e.mover and not e.person]
        if others and self.words[word.i + 1].norm in ("all", "both") and word.dep == "nsubj":
            self.both[word.i] = others
        return self.ego

    def _has_it(self, word: Word) -> Word | None:
        """The person whose it is: "a woman on her bike", "a farmer driving his tractor", "a man rides his bike"."""
        if word.norm not in ("his", "her", "their") or word.dep != "poss":
            return None
        noun = self.words[word.head]
        joint = self.words[noun.head]
        who = self.words[joint.head]
        if noun.dep == "dobj":
            subjects = [self.words[c] for c in joint.children if self.words[c].dep == "nsubj"]
            who = who if joint.dep == "acl" else subjects[0] if subjects else joint
        elif noun.dep != "pobj" or joint.norm not in HAS or joint.i - who.i > 2:
            return None
        person = who.span is not None and who.span.kind == "actor" and who.span.data.get("type") in PERSONS
        return who if person and who.i < joint.i < word.i else None

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

        if (owned := self._owned(word) or taken_up(self.words, self.of, self.subjects, word)) is not None:
            return owned
        if (struck := self._of_the_other(word)) is not None:
            return struck
        if word.dep == "nsubj" and (near := comes_near(self.words, self.of, word)) is not None:
            return near
        if word.dep == "nsubj" and (animal := self._animal_before(word)) is not None:
            return animal
        if bumped and word.dep in ("pobj", "dobj") and (lying := self._lies_before(word)) is not None:
            return lying
        apart = self._not_he(word, fits)
        led = {e for i, e in self.subjects if self.words[i].sentence == word.sentence}
        vehicle = lambda e: fits(e) and e.count == 1 and not (_rider(e) and e not in led)  # noqa: E731
        if word.dep != "nsubj" and any(
            vehicle(e) for i, e in self.of.items() if self.words[i].sentence == word.sentence
        ):
            apart = apart or self._salient(word, vehicle)  # "a van was overtaking a cyclist when the car behind it"
        found = apart or self._salient(word, lambda e: fits(e) and e.count == 1) or self._salient(word, fits)
        if found is None and bumped:
            found = self._salient(word, lambda e: e.type == "animal")
        return found

    def _owned(self, word: Word) -> Entity | None:
        """The animal whose owner is told of, or after which somebody runs: "its owner runs after it"."""
        head = self.words[word.head]
        runner = self._subject_of(self._governor(word)) if word.dep == "pobj" and head.norm == "after" else None
        runs = runner is not None and runner.person and runner.type != "animal"
        if not (word.dep == "poss" and head.norm in OWNERS or runs):
            return None
        return next((e for e in reversed(self.entities) if e.type == "animal"), None)

    def _animal_before(self, word: Word) -> Entity | None:
        """The animal that alone was the subject of the sentence before ("a deer stands on the verge. It leaps"), or
        that stands there beside nobody but people ("a woman walks her dog. It breaks free")."""
        if any(w.sentence == word.sentence and w.i in self.of for w in self.words[: word.i]):
            return None
        told = {e for i, e in self.subjects if self.words[i].sentence == word.sentence - 1}
        if len(told) != 1 or not next(iter(told)).person:
            return None
        there = {e for i, e in self.of.items() if self.words[i].sentence == word.sentence - 1} - told
        alone = next(iter(told)).type == "animal"
        return next(iter(told if alone else there)) if alone or [e.type for e in there] == ["animal"] else None

    def _lies_before(self, word: Word) -> Entity | None:
        """The thing that was the subject of the sentence before: "a mattress lies there. The car swerves around it"."""
        told = [e for i, e in self.subjects if self.words[i].sentence in (word.sentence - 1, word.sentence)]
        things = [e for e in told if e.type in THINGS]
        here = [self.of[w.i] for w in self.words[: word.i] if w.sentence == word.sentence and w.i in self.of]
        things += [e for e in here if e.roles & STANDS and not e.ego and e.count == 1]  # "swerves around it"
        return things[-1] if things else None

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

    def _only_a_name(self, word: Word) -> bool:
        """Whether letters are part of a road's name: "US Highway 60", "I 70"."""
        after = self.words[word.i + 1].norm if word.i + 1 < len(self.words) else ""
        if word.norm == "us":
            return word.text == "US" and not all(w.text.isupper() for w in self.words if w.text.isalpha())
        return word.norm == "i" and (after in ("-", "."))  # "I-70", "i.e."

    def _obliged(self, word: Word) -> bool:
        """Whether "it" is whom something is demanded of ("it must wait"): that is ego, where ego was spoken of."""
        if word.dep != "nsubj" or word.i == 0:
            return False
        text = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 5])
        if not re.match(
            (
                r"(therefore |then |now |thus |only )?(must|shall|should|has to|needs to|is to|is (obliged"
                r"|forced|required|expected|supposed|asked) to)\b"
            ),
            text,
        ):
            return False
        verb = self._governor(word)
        if any(self.words[c].norm in ("because", "since", "if", "that", "which") for c in verb.children if c < word.i):
            return False
        spoken = [e for i, e in self.subjects if self.words[i].sentence >= word.sentence - 1]
        return self.ego in spoken

    def _weather_it(self, word: Word) -> bool:
        head = self.words[word.head]
        text = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 6])
        return head.lemma in ("rain", "snow", "drizzle", "pour") or bool(
            re.match(
                (
                    r"(is|was|were|has been|'s|gets|got|becomes|became)( \w+)? (night|day|dark|dusk|dawn"
                    r"|raining|snowing|foggy|clear|sunny|daylight|daytime|daytime|rainy|cloudy|early|late"
                    r"|morning|evening|noon|midnight|wet|windy|for|up|necessary|not until|only"
                    r"|(safe|possible|clear|impossible|okay|ok|allowed|unsafe|time|too late) (enough )?(for|to))"
                ),
                text,
            )
        )

    def _antecedent(self, word: Word) -> Entity | None:
        verb = self.words[word.head]
        clause = verb
        for _ in range(4):
            if clause.dep == "relcl":
                break
            if clause.head == clause.i:
                break
            clause = self.words[clause.head]
        if (near := self._right_before(word, clause)) is not None:
            return near
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

    def _right_before(self, word: Word, clause: Word) -> Entity | None:
        """Who stands right before ", which" where the tree takes a noun before the verb: "drives towards the target,
        which is stationary"."""
        last = word.i - 2
        if self.words[word.i - 1].norm != "," or last not in self.of or clause.dep != "relcl" or clause.head == last:
            return None
        one = self.words[last].dep == "conj" and clause.tag in ("VBZ", "VBD")  # "a car and a van, which brakes"
        if self.words[last].span is None or not one and not any(w.verb for w in self.words[clause.head : last]):
            return None
        return self.of[last]


def _rider(entity: Entity) -> bool:
    """Whether one is named as a person, if on two wheels: "it" is rather another."""
    return language.actor_nouns().get(entity.noun, ("", False, False))[2] and entity.type in RIDDEN

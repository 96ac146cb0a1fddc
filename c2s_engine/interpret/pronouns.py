"""Whom pronouns, "another", "the latter" and parts ("its left front") mean."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.members import Members
from c2s_engine.interpret.syntax import Word

STRIKES = language.words("strikes")

RIDDEN = frozenset(("bicycle", "motorcycle"))
RESTS = language.words("rests")
BOWS = language.words("bows")

SIDES = frozenset(("left", "right", "rear", "front", "side", "nearside", "offside"))
LOOSE = frozenset(("debris", "box", "obstacle"))
THINGS = LOOSE | {"container", "trash", "barrier", "lane_closure"}
BUMPED = language.words("bumped")
BESIDE = re.compile(r"(to|on|in|at) (left|right|front|rear)\b")


class Pronouns(Members):
    """The part of Cast that resolves words without a noun of their own."""

    words: list[Word]
    entities: list[Entity]
    ego: Entity
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
            return None if word.i in self.asking or self._only_a_name(word) else self.ego
        if norm in ("who", "which", "that", "whose", "whom") and word.tag in ("WDT", "WP", "WP$"):
            return self._antecedent(word)
        if norm in ("it", "its", "itself"):
            if word.dep == "expl" or self._weather_it(word):
                return None
            if self._obliged(word):
                return self.ego
            return self._thing(word)
        if norm in ("himself", "herself", "itself") and word.dep in ("nsubj", "npadvmod", "appos"):
            return None  # "the driver himself moved out"
        if norm in data["person"]:
            found = self._salient(word, lambda e: e.person)
            if found is None and self._first_person():  # who says "I" is never "he"
                found = self._salient(word, lambda e: e.mover and not e.ego)
            if found is None or found.type not in RIDDEN and self._rests(found):
                found = self._salient(word, lambda e: e.type in RIDDEN) or found
            return found or self._salient(word, lambda e: e.mover)
        if norm in ("they", "them", "their", "themselves"):
            many = [e for e in self.entities if e.count > 1]
            last = max((i for i in self.of if i < word.i and self.words[i].span is not None), default=None)
            if last is not None and self.of[last].type in LOOSE and word.sentence - self.words[last].sentence <= 1:
                return self.of[last]  # "two sheets of plywood, and they were lying in our lane"
            if many:
                return many[-1]
            joint = self._joint(word) or self._subjects_before(word)
            if joint is not None:
                return self._all_of(word, joint)
            person = [e for e in self.entities if e.person]
            if person and norm in ("their", "they", "them"):
                return person[-1]
            return self._salient(word, lambda e: e.mover)
        return self._elliptic(word) or self._unknown(word)

    def _thing(self, word: Word) -> Entity | None:
        """The vehicle or thing that "it" means; an animal where it is hit or avoided."""
        bumped = word.i > 0 and self.words[word.i - 1].norm in BUMPED
        things = THINGS if bumped else LOOSE
        i = self._first_person() and not self._ego_is_thing()

        def fits(e: Entity) -> bool:
            return (not e.person and e.mover or e.type in things) and not (i and e.ego)

        found = self._salient(word, lambda e: fits(e) and e.count == 1) or self._salient(word, fits)
        if found is None and bumped:
            found = self._salient(word, lambda e: e.type == "animal")
        return found

    def _rests(self, entity: Entity) -> bool:
        """Whether a vehicle was told of as standing: nobody in it is "he"."""
        verbs = (self._governor(self.words[m.word]) for m in entity.mentions[:2])
        return bool(entity.roles & {"parked", "stationary"}) or any(v.lemma in RESTS for v in verbs)

    def _first_person(self) -> bool:
        """Whether ego speaks of itself: "I", "we", "our"."""
        first = ("i", "we", "me", "us", "my", "our")
        return any(self.words[m.word].norm in first for m in self.ego.mentions)

    def _ego_is_thing(self) -> bool:
        """Whether ego was spoken of as a vehicle, too ("our test car")."""
        return any(m.kind in ("ego", "label", "actor") and self.words[m.word].norm != "i" for m in self.ego.mentions)

    def _only_a_name(self, word: Word) -> bool:
        """Whether letters are part of a road's name: "US Highway 60", "I 70"."""
        after = self.words[word.i + 1].norm if word.i + 1 < len(self.words) else ""
        if word.norm == "us":
            return word.text == "US" and not all(w.text.isupper() for w in self.words if w.text.isalpha())
        return word.norm == "i" and (after == "-" or after[:1].isdigit())

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
        if clause.dep == "relcl" and clause.head in self.of and clause.head < word.i:
            return self._placed_beside(self.words[clause.head]) or self.of[clause.head]
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
            return self.of.get(head.i) if head.i in self.of else None
        return self.of[previous[-1]]

    def _placed_beside(self, noun: Word) -> Entity | None:
        """Who is placed by ego right before "which": "a truck in front of ego that brakes"."""
        above = self.words[noun.head]
        if self.of[noun.i] is not self.ego or noun.dep != "pobj":
            return None
        for _ in range(3):
            if above.i in self.of:
                return self.of[above.i] if self.of[above.i] is not self.ego else None
            if above.tag not in ("IN", "RB", "NN", "JJ", "RP"):
                return None
            above = self.words[above.head]
        return self.of.get(above.i)

    def _salient(self, word: Word, accept) -> Entity | None:  # noqa: ANN001
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
            clash = self._subject_of(self.words[verb.head])  # one waits until another has passed
        if word.dep in ("dobj", "pobj") and word.norm not in ("its", "itself"):
            clash = self._subject_of(verb)
        if word.dep == "poss" and verb.lemma in STRIKES and self.words[word.head].dep in ("dobj", "pobj"):
            clash = self._subject_of(verb)
        above = self.words[word.head]
        if word.dep == "poss" and above.norm in BOWS and self.words[max(0, word.i - 1)].norm == "across":
            clash = self._subject_of(verb)  # nobody goes across its own bows
        if word.dep == "poss" and BESIDE.match(self._around(word.i)) and above.dep == "pobj":
            clash = self.of.get(self.words[above.head].head) or clash  # "a coach to its left": not the coach's own
        holder = self.of.get(above.head) if word.dep == "pobj" and above.head != above.i else None
        if holder is not None and holder is not clash and above.head < word.i:
            inner, accept_all = holder, accept
            accept = lambda e: accept_all(e) and e is not inner  # noqa: E731
        same = [(i, e) for i, e in self.subjects if i < word.i and accept(e) and e is not clash]
        last = [i for i in sorted(self.of) if i < word.i and accept(self.of[i]) and self.of[i] is not clash]
        if not last:
            return None
        sentence = [p for p in same if self.words[p[0]].sentence == word.sentence]
        if word.dep == "poss":
            twin = self._parallel(word)
            if twin is not None and accept(twin):
                return twin
            own = self._subject_of(verb)
            if self._whose_driver(word, verb):
                own = None  # "the coach was in the right lane when its driver saw": not the driver's own
            beside = BESIDE.match(self._around(word.i)) and verb.lemma in ("be", "stand", "sit", "wait", "appear")
            if beside or self._into_lane(word, verb):
                clash, own = own, None  # nobody is on its own left, or comes into its own lane
                last = [i for i in last if self.of[i] is not clash]
                if not last:
                    return None
                sentence = [p for p in sentence if p[1] is not clash]
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
        sentence = told or sentence
        if word.dep in ("dobj", "pobj", "poss"):
            near = [i for i in last if self.words[i].sentence == word.sentence]
            if clash is not None and near:
                before = self._governor(self.words[sentence[-1][0]]) if sentence else word
                fronted = before.dep == "advcl" and before.i < word.i < verb.i  # "while V1 waited, a car behind it"
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

    def _finite(self, verb: Word) -> bool:
        """Whether a verb is no infinitive ("for the traffic to clear")."""
        return not any(self.words[c].norm == "to" and self.words[c].dep == "aux" for c in verb.children)

    def _parallel(self, word: Word) -> Entity | None:
        """Whom "its" meant just before in the same place: "a bus is on its right, a car on its left"."""
        if not BESIDE.match(self._around(word.i)):
            return None
        for earlier in reversed(self.words[: word.i]):
            if earlier.sentence != word.sentence:
                return None
            if earlier.norm == word.norm and BESIDE.match(self._around(earlier.i)):
                return self.of.get(earlier.i)
        return None

    def _whose_driver(self, word: Word, verb: Word) -> bool:
        """Whether a possessive belongs to the driver who is the subject of its clause."""
        held = self.words[word.head]
        return held.lemma in ("driver", "operator", "rider") and held.head == verb.i and held.dep.startswith("nsubj")

    def _into_lane(self, word: Word, verb: Word) -> bool:
        """Whether somebody comes from elsewhere into the lane that a possessive names."""
        after = [w.norm for w in self.words[word.i + 1 : word.i + 3]]
        clause = {w.norm for w in self.words[verb.i : word.i]}
        return (
            verb.lemma in ("cross", "encroach", "intrude", "invade", "veer", "come", "stray")
            and bool({"lane", "path"} & set(after))
            and not {"back", "again", "own", "return"} & (clause | set(after))
        )

    def _around(self, i: int) -> str:
        """The words before and after a word."""
        return " ".join(w.norm for w in self.words[max(0, i - 1) : i + 2 : 2])

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

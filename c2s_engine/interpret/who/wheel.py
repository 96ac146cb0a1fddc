"""Who sits in or on a vehicle: both are one road user."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.reference import Reference
from c2s_engine.interpret.who.unlisted_road_users import WALKS

DRIVES = language.words("at_the_wheel")
STEERS = language.words("steers")
ASIDE = language.words("besides_driving")
SITS = re.compile(
    r"(?:(?:ahead|in front|behind|beside|alongside|next to|to the (?:left|right))(?: of)? ?(?:@|\w+)? ?)?"
    r"(?:, ?)?(?:(?:who|that) (?:is|was) )?(?:(?:alone|sitting|seated|travelling|traveling|sat) )?"
    r"(?:in|on|with|driving|riding|operating|(?:at|behind) the wheel of|aboard|astride) (?:an?|his|her|the|their|my) "
    r"(?:[\w-]+ ){0,3}$"
)
DRIVEN = re.compile(
    r"@ ?,?(?: ?\(?(?:who )?(?:was|is|were|had been))?(?: at (?:all|the) (?:material|relevant) times?,?)? "
    r"(?:(?:operating|driving|riding)(?: (?:an?|his|her|the|their))?"
    r"|the (?:registered )?(?:driver|rider|operator) of (?:an?|the)"
    r"|(?P<how>drove|rode|drives?|rides?|operated|at the wheel of|in charge of|in|on) (?:an?|his|her|the|their|my))"
    r"(?: (?!behind|past|beside|towards?|after|along|around|ahead|before|near|into|with)[\w-]+){0,2} $"
)
VEHICULAR = language.words("vehicular")

LANE = re.compile(
    r"(?:who (?:is|was) )?in (?:the|my|our) (?:(?:left|right|next|other|adjacent|middle|fast|slow|inside|outside"
    r"|oncoming|opposite|neighbou?ring)(?:[- ]hand)? lane\b|lane (?:next to|beside|to (?:my|our|the) (?:left|right)))"
)


class Occupants(Reference):
    """The part of Cast that takes a driver or rider and the vehicle for one."""

    wheels: dict[int, Entity]  # the noun of a vehicle -> whom it carries, who was spoken of before

    def _drives_on(self, word: Word) -> Entity | None:
        """Who drives or cycles, in or on what is not told: "the couple drove home", "a boy was cycling to school"."""
        verb = self.words[word.head]
        if word.dep != "nsubj" or verb.lemma != "drive":
            return None
        return self._new(Entity("", "vehicle", manned=True, sex=self._sex(word)))

    def _at_wheel(self, word: Word, known: Entity | None = None) -> Entity | None:
        """A person of whom it is said later in the clause what is driven ("a woman in front of us in a red van",
        "a pensioner drove his Opel"): one spoken of before, else a new one."""
        for other in self.words[word.i + 1 : word.i + 12]:
            if other.sentence != word.sentence or other.norm in (";", ":", "but", "when", "while"):
                return None
            if other.norm == "and" and not self._goes_on(word, other):
                return None
            if (
                other.span is None
                or other.span.kind != "actor"
                or other.span.data["type"] not in VEHICLES - {"vehicle"}
            ):
                continue
            if other.span.data.get("plural"):
                return None
            between = self.words[word.i + 1 : other.i]
            text = " ".join("@" if w.span is not None and w.span.kind == "ego" else w.norm for w in between) + " "
            verb = self.words[other.head]
            own = self.words[other.i - 1].norm in ("his", "her") or self.words[other.i - 2].norm in ("his", "her")
            moves = verb.norm in STEERS or own and verb.lemma not in ASIDE and verb.tag in ("VBD", "VBZ", "VBG", "VBP")
            subject = (
                self.words[verb.head] if verb.dep == "conj" else verb
            )  # "a man mixed up the pedals and drove his Audi"
            drives = moves and verb.i > word.i and other.dep == "dobj" and self._heads(word, subject)
            if drives or SITS.fullmatch(text) or word.dep == "poss" and word.head == other.i:
                found = known or self._new(Entity("", "vehicle", manned=True, sex=self._sex(word)))
                self.wheels[other.i] = found
                return found
            return None
        return None

    def _goes_on(self, word: Word, joint: Word) -> bool:
        """Whether "and" joins what the same person does next."""
        verbs = [w for w in self.words[joint.i + 1 : joint.i + 4] if w.tag in ("VBD", "VBZ")]
        return bool(verbs) and verbs[0].head == word.head and verbs[0].dep == "conj"

    def _steering(self, word: Word) -> Entity | None:
        """A person who does what only vehicles do: "a lady reversed out of her drive", "this guy cut me off"."""
        verb = self.words[word.head]
        after = " ".join(w.norm for w in self.words[verb.i : verb.i + 5])
        steers = verb.lemma in VEHICULAR or self._in_a_lane(word) and not WALKS.match(after)
        nearer = any(self.words[c].dep == "nsubj" and word.i < c < verb.i for c in verb.children)
        if word.dep != "nsubj" or not steers or nearer:  # "a woman to cross, when a van ran into the rear"
            return None
        return self._new(Entity("", "vehicle", manned=True, sex=self._sex(word)))

    def _in_a_lane(self, word: Word) -> bool:
        """Whether a person is placed as only drivers are: "the guy in the left lane"."""
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 8])
        return LANE.match(after) is not None

    def _heads(self, word: Word, verb: Word) -> bool:
        """Whether a word is the subject of a verb, or what its participle describes."""
        return word.head == verb.i and word.dep == "nsubj" or verb.dep in ("acl", "relcl") and verb.head == word.i

    def _driven_by(self, word: Word) -> Entity | None:
        """Whose vehicle it is in "the defendant, operating a dump truck": the driver and the vehicle are one."""
        back = [w for w in self.words[max(0, word.i - 10) : word.i] if w.sentence == word.sentence]
        text = " ".join("@" if w.i in self.of and w.span is not None else w.norm for w in back)
        match = DRIVEN.search(text + " ")
        if match is None:
            return None
        owner = next(self.of[w.i] for w in reversed(back) if w.i in self.of and w.span is not None)
        if match["how"] in ("in", "on") and not re.search(
            r"driver|motorist|party|defendant|respondent|claimant|suspect|offender|rider|courier", owner.noun
        ):
            return None
        two = owner.type in ("bicycle", "motorcycle") and re.search(r"rider|courier", owner.noun)
        return owner if owner.type in ("vehicle", "rider") or owner.ego or two else None

    def _rides(self, word: Word) -> bool:
        """Whether a person is only the one inside a vehicle ("a man in a white van"), who stands for it."""
        following = [w for w in self.words[word.i + 1 : word.i + 6] if w.sentence == word.sentence]
        if not following or following[0].norm not in DRIVES:
            return False
        for other in following[1:]:
            if other.span is not None:
                return (
                    other.span.kind == "actor"
                    and other.span.data["type"] in VEHICLES - {"vehicle"}
                    and not other.span.data.get("person")
                )
            if other.tag in ("NN", "NNS", "IN") and other.norm not in language.makes() or other.verb:
                return False
        return False

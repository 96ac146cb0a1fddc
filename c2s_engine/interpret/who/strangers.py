"""Road users that no table names: unknown nouns by what they do, drivers who get out."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import VEHICLES, Entity
from c2s_engine.interpret.reading.syntax import Word

MANOEUVRES = language.words("manoeuvres")
WALKS = re.compile(r"(cross|walk|run|ran|dash|hurr|rush|stroll|emerge|step)\w* ")


AT_SPEED = re.compile(
    r"(?:run|ran|runs|running) (?:\w+ ){0,3}(?:off|onto|out of) (?:the |his |her )?(?:\w+ )?"
    r"(?:road|shoulder|lane|verge|grass)"
)
"""What a driver does without leaving the vehicle: "the driver ran off the road"."""


LOOSENS = frozenset(
    ("come", "fly", "break", "tear", "shear", "work", "fall", "drop", "detach", "slip", "slide", "blow")
)
ROLLS = frozenset(("bounce", "tumble"))
OCCUPANTS = language.words("occupants")


class Strangers:
    """The part of Cast that knows road users by what they do."""

    entities: list[Entity]
    of: dict[int, Entity]
    words: list[Word]

    def _new(self, entity: Entity) -> Entity:
        raise NotImplementedError

    def _unknown(self, word: Word) -> Entity | None:
        """A noun that no table knows: by what it is said to do it must be a road user or a thing on the road."""
        if word.tag not in ("NN", "NNP") or len(word.norm) < 3 or word.span is not None:
            return None
        data = language.table("actors")
        loose = word.norm in data["parts"] and self._off(word)
        if word.lemma in data["never"] or word.norm in data["parts"] and not loose:
            return None
        known = next((e for e in self.entities if "guessed" in e.roles and e.noun == word.norm), None)
        if known is not None:
            return known
        if self._of_several(word):
            return None  # "a group of pedestrians"
        told_by = {self.words[c].norm for c in word.children}
        if self._make_unknown(word, told_by):
            return self._new(Entity("", "vehicle", noun=word.norm, roles={"guessed"}))
        if not {"a", "an", "one", "another"} & told_by and not loose:
            return None
        told = next((w for w in self._children(word) if w.dep in ("acl", "relcl")), None)
        if told is not None and any(w.dep.startswith("nsubj") and w.noun for w in self._children(told)):
            return None  # "a street where a child crosses"
        verb = told if told is not None else self.words[word.head]
        if told is None and word.dep != "nsubj":
            return None
        rest = " ".join(
            "@" if w.span is not None else w.norm
            for w in self.words[verb.i + 1 : verb.i + 9]
            if w.sentence == word.sentence
        )
        for guess in data["guesses"]:
            if verb.lemma in guess["verbs"] and re.search(guess["with"], rest):
                return self._new(
                    Entity("", guess["type"], noun=word.norm, roles={"guessed"}, typed=guess["type"] != "vehicle")
                )
        return None

    def _off(self, word: Word) -> bool:
        """Whether a part comes off the vehicle: "a wheel comes off a trailer"."""
        verb = self.words[word.head]
        after = self.words[verb.i + 1].norm if verb.i + 1 < len(self.words) else ""
        comes = verb.lemma in LOOSENS and after in ("off", "loose", "away", "from") or verb.lemma in ROLLS
        return word.dep == "nsubj" and comes

    def _children(self, word: Word) -> list[Word]:
        return [self.words[c] for c in word.children]

    def _of_several(self, word: Word) -> bool:
        """Whether a noun only counts road users: "a crowd of children"."""
        of = [self.words[c] for c in word.children if self.words[c].norm == "of" and c == word.i + 1]
        nouns = [self.words[c].span for prep in of for c in prep.children]
        return any(s is not None and s.kind == "actor" and s.data.get("plural") for s in nouns)

    def _make_unknown(self, word: Word, before: set[str]) -> bool:
        """Whether a name with an article does what only vehicles do: "the Kluger braked"."""
        name = word.text[:1].isupper() and not word.text.isupper() and word.start > 0
        verb = self.words[word.head]
        subject = word.dep in ("nsubj", "nsubjpass") and verb.lemma in MANOEUVRES
        return name and subject and bool(before & {"a", "an", "the", "another"}) and self.words[word.i + 1].span is None

    def _on_foot(self, word: Word) -> bool:
        """Whether a driver or passenger leaves the vehicle: then it is a person of its own."""
        if word.norm.split(" ")[-1] not in OCCUPANTS or word.dep not in ("nsubj", "nsubjpass"):
            return False
        verb = self.words[word.head]
        joined = [self.words[c] for c in verb.children if self.words[c].dep == "conj"]
        own = {w.i for w in joined if not any(self.words[c].dep.startswith("nsubj") for c in w.children)}
        told = [self.words[c] for c in word.children if self.words[c].dep == "relcl"]
        verbs = [verb, *(w for w in joined if w.i in own), *told]
        rides = "passenger" in word.norm or "occupant" in word.norm
        after = [" ".join(w.norm for w in self.words[v.i : v.i + 7]) for v in verbs]
        off_road = not rides and any(AT_SPEED.match(text) for text in after)
        return not off_road and any(self._leaves_on_foot(text) or rides and WALKS.match(text) for text in after)

    @staticmethod
    def _leaves_on_foot(after: str) -> bool:
        return bool(
            re.match(
                (
                    r"(step|climb|get|got|jump|hop|walk|alight|run|ran)\w* (\w+ )?(out|off|down|from|across"
                    r"|into the (road|street|lane))\b"
                ),
                after,
            )
            or re.match(
                r"(?!.*\b(?:lights?|red|queue|signal)\b)(?:stand|stood)\w* (?:\w+ )?"
                r"(?:(?:behind|beside|next to|between|outside|by) (?:the|his|her|its|their|an?)\b"
                r"|at (?:the|his|her|its|their) (?:[\w']+ ){0,3}?(?:doors?|boot|tailgate|rear|back|hatch|trunk)\b)"
                r"|(?:unload|load|sort)\w* |kneeling |crouching ",
                after,
            )
            or re.match(r"(?:walk|stroll|limp|kneel|crouch)\w* |step\w* (?!on the (?:brake|gas|acc|pedal))", after)
            or re.match(
                r"(exit|leav|left|disembark)\w* (the|his|her|their|its) (?!\w*road|\w*lane|\w*way\b|street)",
                after,
            )
        )

    def _other_driver(self, word: Word) -> Entity | None:
        """ "The other driver, in a red van": that vehicle, else the one spoken of last."""
        near = [i for i in sorted(self.of) if self.of[i].type in VEHICLES and not self.of[i].ego]
        inside = [
            i
            for i in near
            if 0 < i - word.i <= 6 and {"in", "driving", "of"} & {w.norm for w in self.words[word.i + 1 : i]}
        ]
        before = [i for i in near if i < word.i]
        found = inside[:1] or before[-1:] or near[:1]
        return self.of[found[0]] if found else None

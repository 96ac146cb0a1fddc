"""Third stage: who is meant. Mentions of ego and of the others become entities, over sentences."""

import re
from collections.abc import Callable

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import (
    DEFINITE,
    MOTOR,
    MOVERS,
    ORDINALS,
    PERSONS,
    VEHICLES,
    ZONES,
    Entity,
    Mention,
    fits,
)
from c2s_engine.interpret.reading.narrators import asked, has_outside_narrator, narrator
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.labels import Labels

__all__ = [
    "DEFINITE",
    "MOTOR",
    "MOVERS",
    "ORDINALS",
    "PERSONS",
    "VEHICLES",
    "ZONES",
    "Cast",
    "Entity",
    "Mention",
    "fits",
]


class Cast(Labels):
    """The entities of a text, and who each word means."""

    def __init__(self, words: list[Word]) -> None:
        self.words = words
        self.asking = _asking(words)
        self.onlooker = False
        self.ego = Entity("ego", "car")
        self.entities: list[Entity] = []
        self.of: dict[int, Entity] = {}
        self.wheels: dict[int, Entity] = {}
        self.trailing: dict[str, Entity] = {}
        self.both: dict[int, list[Entity]] = {}  # whom else a word means that means several
        self.subjects: list[tuple[int, Entity]] = []  # grammatical subjects so far: (word, entity)
        self.told = {w.sentence for w in words if w.tag in ("VBZ", "VBD", "VBP", "MD")}
        self.headlined = False
        self.me = self._narrator()
        self.strong_ego = any(self._strong(w) for w in words)
        self.ego_named = self.strong_ego or any(
            w.span and w.span.kind == "label" and w.span.data["label"] == "1" for w in words
        )
        self.one_is_ego = self._label_is_ego()
        self._resolve()
        self._cataphoric_member()
        self._cataphoric_subject()
        self._cataphoric_pair()
        self._cataphoric_other()
        self._settle_riders()

    def _strong(self, word: Word) -> bool:
        """Whether a word is a name of ego: "I" is none where the first person does not drive."""
        return word.span is not None and word.span.kind == "ego" and (self.me is self.ego or word.norm != "i")

    def _narrator(self) -> Entity:
        """Who says "I": ego, or somebody on foot or on a bicycle whom one that drives meets."""
        kind = narrator(" ".join(w.norm for w in self.words))
        told = {w.span.data["type"] for w in self.words if w.span and w.span.kind == "actor"}
        named = any(w.span is not None and w.span.kind in ("ego", "label") and w.norm != "i" for w in self.words)
        if not kind or self.asking or not (named or told & MOTOR):
            return self.ego
        return self._new(Entity("", kind, typed=True, manned=True, sex="i"))

    # -- building ------------------------------------------------------------------------------------------------
    def _resolve(self) -> None:
        done: set[int] = set()
        for word in self.words:
            if word.i in done:
                continue
            span = word.span
            entity = None
            if span and span.kind in ("ego", "label", "actor"):
                if word.i + 1 < len(self.words) and self.words[word.i + 1].span is span and word.norm == "the":
                    continue
                entity = self._named(word)
            else:
                entity = self._pronoun(word)
            if entity is not None:
                self.of[word.i] = entity
                self._man(word, entity)
                entity.mentions.append(
                    Mention(
                        word.i, word.start, word.end, kind=span.kind if span and span.kind != "share" else "pronoun"
                    )
                )
                if word.dep in ("nsubj", "nsubjpass") or any(told(word) for told in (self._fronted, self._is_there)):
                    self.subjects.append((word.i, entity))

    def _cataphoric_subject(self) -> None:
        """ "As it was turning left, V1 was hit": a pronoun before anybody is named means who is named next."""
        for word in self.words:
            verb = self.words[word.head]
            main = self.words[verb.head]
            if word.norm not in ("it", "he", "she") or word.i in self.of or word.dep not in ("nsubj", "nsubjpass"):
                continue
            if verb.dep != "advcl" or main.i < verb.i:
                continue
            subjects = (c for c in main.children if self.words[c].dep in ("nsubj", "nsubjpass") and c > verb.i)
            known = (c for c in subjects if not {"a", "an"} & {self.words[i].norm for i in self.words[c].children})
            named = next((found for c in known if (found := self.referent(c)) is not None), None)
            if named is not None and (named.mover or named.ego):
                self.of[word.i] = named
                named.mentions.insert(0, Mention(word.i, word.start, word.end, kind="pronoun"))
                self.subjects.insert(0, (word.i, named))

    def _cataphoric_pair(self) -> None:
        """ "Both vehicles shall be driven at 50 km/h", before ego and the one other vehicle are named."""
        first = next((e for e in self.entities if e.mentions), None)
        if first is None or first.count != 2 or first.noun not in ("vehicles", "cars"):
            return
        if any(m.kind != "pronoun" for m in first.mentions[1:]):
            return
        at = first.mentions[0].word
        others = [
            e for e in self.entities if e is not first and e.type in VEHICLES and e.mentions and e.group is not first
        ]
        told = {w.norm for w in self.words[max(0, at - 2) : at]} & {"both", "the", "these"}
        if (
            not told
            or not self.ego.mentions
            or self.words[self.ego.mentions[0].word].sentence <= self.words[at].sentence
            or len(others) != 1
            or others[0].count > 1
        ):
            return
        self.of[at] = others[0]
        for mention in first.mentions[1:]:  # "from its own lane the VUT ..."
            self.of[mention.word] = self.ego
        self.subjects = [(i, others[0] if e is first else e) for i, e in self.subjects]

    def _cataphoric_other(self) -> None:
        """ "It hesitates when the other car was there first", before the one other vehicle is told of."""
        first = next((e for e in self.entities if e.mentions), None)
        if first is None or first.count != 1 or first.noun not in ("car", "vehicle") or first.roles or first.label:
            return
        at = first.mentions[0].word
        others = [e for e in self.entities if e is not first and e.type in MOTOR and e.count == 1 and e.mentions]
        told = [w.norm for w in self.words[max(0, at - 2) : at]]
        if told[-2:] != ["the", "other"] or len(others) != 1 or others[0].mentions[0].word < at:
            return
        later = others[0]
        if self.words[later.mentions[0].word].sentence == self.words[at].sentence:
            return  # "the other vehicle cuts out before a stationary vehicle"
        for i in [i for i, e in self.of.items() if e is first]:
            self.of[i] = later
        later.mentions = [*first.mentions, *later.mentions]
        self.subjects = [(i, later if e is first else e) for i, e in self.subjects]

    def _fronted(self, word: Word) -> bool:
        return word.dep == "ROOT" and not word.tag.startswith("VB")

    def _is_there(self, word: Word) -> bool:
        """Whether it is who there is ("there is a bus ahead")."""
        verb = self.words[word.head]
        return word.dep == "attr" and any(self.words[c].dep == "expl" for c in verb.children)

    def _named(self, word: Word) -> Entity | None:
        span = word.span
        assert span is not None
        if span.kind == "ego" and not self._strong(word):
            return self.me
        if span.kind == "ego":
            self._ego_type(word)
            return self.ego
        if span.kind == "label":
            return self._labelled(word)
        return self._actor(word)

    def _ego_type(self, word: Word) -> None:
        nouns = language.actor_nouns()
        for noun in re.findall(r"[a-z]+", word.norm):
            kind = nouns.get(noun, ("", False, False))[0]
            if kind in MOTOR - {"vehicle", "car"}:
                self.ego.type, self.ego.typed = kind, True


def _asking(words: list[Word]) -> frozenset[int]:
    """The words in which first persons are nobody on the road ("please write me a scene", "I saw it from here")."""
    whole = " ".join(w.norm for w in words)
    if has_outside_narrator(whole):
        return frozenset(w.i for w in words)
    found: set[int] = set()
    for number in {w.sentence for w in words}:
        found |= _within([w for w in words if w.sentence == number], asked)
    return frozenset(found)


def _within(words: list[Word], find: Callable[[str], list[tuple[int, int]]]) -> set[int]:
    """The words in the stretches that are found in their text."""
    starts, text = [], ""
    for word in words:
        starts.append(len(text))
        text += word.norm + " "
    return {w.i for first, last in find(text) for w, at in zip(words, starts, strict=True) if first <= at < last}

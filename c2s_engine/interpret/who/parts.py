"""The whole that a part means: the driver of V1, its left front, the end of the queue."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import PERSONS, VEHICLES, Entity
from c2s_engine.interpret.who.unlisted_road_users import UnlistedRoadUsers

DRIVING = language.words("driving")

AT_EGOS_WHEEL = language.words("systems") - {"stack"} | {"motorist", "driver", "operator"}
"""Who drives ego, where nobody else's is meant."""


class Parts(UnlistedRoadUsers):
    """The part of Cast that finds whom a part belongs to."""

    ego: Entity
    subjects: list[tuple[int, Entity]]

    def _first_person(self) -> bool:
        """Whether ego speaks of itself: "I", "we", "our"."""
        first = ("i", "we", "me", "us", "my", "our")
        return any(self.words[m.word].norm in first for m in self.ego.mentions)

    def referent(self, i: int, depth: int = 0) -> Entity | None:
        """Whom a noun means: itself, or the whole that it is a part of ("the driver of V1", "its left front")."""
        if i in self.of:
            return self.of[i]
        word = self.words[i]
        if depth > 3:
            return None
        if word.tag == "VBG" and word.dep in ("nsubj", "nsubjpass") and word.span is None:
            told = [c for c in word.children if c < i and self.words[c].dep == "nsubj"]
            return self.referent(told[0], depth + 1) if told else None  # "a van standing in a drive backs out"
        if (
            word.span is not None
            and word.span.kind == "actor"
            and (word.span.data["type"] in PERSONS or word.span.data.get("noun") in language.table("actors")["drivers"])
        ):
            for child in word.children:
                other = self.words[child]
                if other.norm in ("in", "on") or other.norm in DRIVING:
                    for target in other.children:
                        if target in self.of and self.of[target].type in VEHICLES:
                            return self.of[target]
        parts = language.table("actors")["parts"]
        if (
            word.lemma in parts
            or word.norm in parts
            or word.norm in ("left", "right")
            and self.words[i - 1].norm in ("front", "rear", "back")  # "the front right of V2"
            or word.lemma
            in (
                "side",
                "one",
                "group",
                "pair",
                "couple",
                "line",
                "row",
                "queue",
                "pile",
                "number",
                "first",
                "last",
                "two",
                "three",
                "none",
                "both",
                "each",
                "neither",
            )
        ):
            for child in word.children:
                other = self.words[child]
                if other.dep == "poss" or other.tag == "PRP$":
                    found = self.referent(child, depth + 1)
                    if found:
                        return found
            for child in word.children:
                other = self.words[child]
                if other.dep == "prep" and other.norm in ("of", "on", "in"):
                    for target in other.children:
                        if self.words[target].dep == "pobj":
                            found = self.referent(target, depth + 1)
                            if found:
                                return found
            if word.lemma in ("driver", "operator") and any(
                self.words[c].norm in ("other", "another") for c in word.children
            ):
                return None
            if word.lemma in ("driver", "operator", "system", "passenger", "feature") or word.norm == "brakes":
                return self.ego if word.lemma != "passenger" else None
        if word.tag.startswith("NN") and word.span is None:
            for child in word.children:  # "a Nimbus autonomous vehicle": the name before what it is
                other = self.words[child]
            for child in word.children:
                other = self.words[child]
                if other.dep == "prep" and other.norm in ("in", "on") or other.norm in DRIVING and other.dep == "acl":
                    for target in other.children:
                        if target in self.of and self.of[target].type in VEHICLES and self.words[target].tag != "PRP":
                            return self.of[target]
            for child in word.children:
                other = self.words[child]
                if other.dep == "prep" and other.norm == "of":
                    for target in other.children:
                        if target in self.of and self.of[target].count > 1:
                            return self.of[target]
        if word.lemma in AT_EGOS_WHEEL or word.norm in AT_EGOS_WHEEL:
            return self.ego
        return None

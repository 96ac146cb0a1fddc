"""What a verb means: the rules of data/language/motions.yaml, and for verbs that only tell in which manner one goes
("shoots out of a side street") those of going."""

from __future__ import annotations

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.motions import rules
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.patients import Patients

MANNERS = language.words("manners_of_going")
HOW = r"(?:(?:right|straight|directly|suddenly|slowly|quickly|fast|back|just|clean) )*"
DIRECTED = re.compile(
    rf"^\w+ {HOW}(?:in(?! front)|into|onto|out|off|past|across|over (?=the|an?\b|its|my|our|his|her)|through|towards?"
    r"|away|around|round|down|up|along|back|ahead|between|from|straight|behind)\b"
)
"""A complement that tells where one goes."""
TRAILING = re.compile(r"(?: (?:and|but|[.,;!]))+$")
"""What stands behind the last word of a clause."""
ALONG = re.compile(r"^\w+ (?:\w+ )?along\b")
ROUTED = re.compile(rf"^\w+ {HOW}(?:out (?:of|from)|from|through|over|across|past|along|around|round|up|off|into)\b")
"""A complement that tells a way, behind which verbs of losing one's line are verbs of going, too."""


class Meanings(Patients):
    """The part of Clauses that knows what verbs mean."""

    def _event(
        self, lemma: str, word: Word, text: str, whole: str, agent: Entity | None, patient: Entity | None
    ) -> Event | None:
        event, fits = self._ruled(lemma, word, text, whole, agent, patient)
        directed = ROUTED if fits == "alone" else DIRECTED
        if fits == "words" or lemma not in MANNERS or not directed.match(text):
            return event
        for verb in ("drive",) if ALONG.match(text) else ("drive", "come"):
            plainly = re.sub(rf"^{lemma}\b", verb, text)
            told, how = self._ruled(verb, word, plainly, re.sub(rf"\b{lemma}\b", verb, whole, count=1), agent, patient)
            if how == "words" and told is not None:
                return told
            if how == "alone" and (verb == "come" or ALONG.match(text)):
                return told
        return event

    def _ruled(
        self, lemma: str, word: Word, text: str, whole: str, agent: Entity | None, patient: Entity | None
    ) -> tuple[Event | None, str]:
        """What the first rule that fits a verb makes of it; how it fits: by its "words", by the verb "alone", or ""."""
        said, said_whole = text, whole
        text = TRAILING.sub("", text)
        if agent is not None:
            text, whole = (re.sub(rf"@{agent.key} 's\b", "its", t) for t in (text, whole))
        for rule, lemmas, patterns in rules("verbs"):
            if lemma not in lemmas:
                continue
            if "after" in patterns and not patterns["after"].search(text):
                continue
            if "any" in patterns and not patterns["any"].search(whole):
                continue
            if "not" in patterns and patterns["not"].search(whole if rule["act"] != "reverse" else text):
                continue
            if rule.get("whom") == "person" and (patient is None or not patient.person):
                continue
            actor = patient if rule.get("swap") else agent
            if rule["act"] in ("none", "stop_none"):
                if agent is not None and not self._agrees(rule, agent):
                    continue
                return None, "words"
            if rule.get("swap_passive"):
                if patient is None and agent is not None and not agent.ego:
                    patient, agent = agent, None
                if patient is None:
                    continue
                actor = agent if agent is not None and agent is not patient else self.cast.ego
            if actor is None:
                actor = self._default_agent(word, rule["act"])
                if actor is None and rule.get("who") == "person":
                    continue  # of whoever is not named no person is made
                if actor is None:
                    return None, "words"
            if not self._agrees(rule, actor):
                continue
            if (
                rule["act"] == "cross_road"
                and actor.type == "bicycle"
                and re.search(
                    (
                        r"straight|(over|through|across) (the|an) (\w+ )?(junction|intersection|crossroads)"
                        r"|(?<!pedestrian )(?<!zebra )crossing(?! the)"
                    ),
                    text,
                )
            ):
                continue
            if rule.get("target") == "ego" and actor.ego:
                continue
            if rule.get("moving") and self._at_rest(actor):
                continue
            if rule.get("of") == "parked" and not self._was_off_road(actor):
                continue
            event = Event(
                rule["act"],
                actor,
                word.i,
                said,
                said_whole,
                patient if not rule.get("swap") else None,
                hard=bool(rule.get("hard")),
                order=float(word.i),
                side=rule.get("side"),
            )
            return event, "words" if {"after", "any"} & patterns.keys() else "alone"
        return None, ""

    @staticmethod
    def _agrees(rule: dict[str, Any], actor: Entity) -> bool:
        who = rule.get("who")
        if who == "person":
            return actor.person or actor.type == "bicycle" and rule["act"] in ("cross_road", "move_along")
        if who == "rider":
            return actor.type in ("bicycle", "motorcycle")
        if who == "thing":
            return not (actor.ego or actor.mover)
        if who == "vehicle":
            return not actor.person and (actor.mover or actor.ego)
        return True

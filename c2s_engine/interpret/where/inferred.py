"""Places that follow from what is said elsewhere: lanes spoken of before, lane numbers, hiding, mutual relations."""

from __future__ import annotations

import re

from c2s_engine.interpret.surroundings.whereabouts import STATES
from c2s_engine.interpret.what.towards import OPPOSITE, side
from c2s_engine.interpret.where.concealed import Concealed

BEFORE_OR_BEHIND = re.compile(
    r"^(?:[^;]*?\b(?P<side>left|right)\b)?[^;]*?\b(?P<rel>behind|after|in front of|ahead of|before|between|path of) "
    r"(?:the |an? )?(?:\w+ )?@(?P<who>a\d+)(?! 's lane)"
)


HALTS = frozenset(("stop", "brake_stop", "brake", "evade"))


DODGES = frozenset(("swerve", "lane_change", "evade"))


class Inferred(Concealed):
    """The part of Places that looks beyond a single phrase."""

    ego_lane: str | None

    def _mutual(self) -> None:
        """What is said of ego (or of another) towards an entity says where that entity is, too."""
        turned = {"ahead": "behind", "behind": "ahead", "beside": "beside"}
        for event in self.clauses.events:
            if (
                event.agent.ego
                and event.mode == "fact"
                and re.search(r"#dist (behind|back)(?! (the |a )?@)", event.whole)
                and event.act in STATES
            ):
                ahead = [
                    e
                    for e in self.cast.entities
                    if self.of[e].rel in (None, "ahead") and self.of[e].lane in (None, "same") and e.mover
                ]
                if ahead and self.of[ahead[0]].gap is None:
                    self._gap(event.words, self.of[ahead[0]])
            if not event.agent.ego or event.mode == "hypothetical" or event.act not in STATES | {"keep_lane", "follow"}:
                continue
            for match in re.finditer(
                (
                    r"(?P<rel>behind|ahead of|in front of|alongside|beside|next to|to the rear of) (the |an? "
                    r"|another )?(\w+ )?@(?P<who>a\d+)"
                ),
                event.whole,
            ):
                other = next((e for e in self.cast.entities if e.key == match["who"]), None)
                if other is None:
                    continue
                where = self.of[other]
                rel = {"behind": "behind", "to the rear of": "behind"}.get(
                    match["rel"], "beside" if match["rel"] in ("alongside", "beside", "next to") else "ahead"
                )
                if where.rel is None:
                    where.rel = turned[rel]
                    if where.lane is None and rel != "beside" and not other.person:
                        where.lane = "same"
                if where.gap is None:
                    self._gap(event.words, where)

    def _joined(self) -> None:
        """Whom ego goes behind or before in the neighbouring lane is in that lane: "it merges right behind a truck"."""
        for event in self.clauses.events:
            if not event.agent.ego or event.act not in ("lane_change", "cut_in") or not event.done:
                continue
            match = BEFORE_OR_BEHIND.search(event.text)
            other = next((e for e in self.cast.entities if match and e.key == match["who"]), None)
            passed = any(e.agent.ego and e.act == "overtake" and e.patient is other for e in self.clauses.events)
            if match is None or other is None or passed or other.person or not other.mover:
                continue
            where, ahead = self.of[other], match["rel"] in ("behind", "after")
            told = side(event) or match["side"]
            fits = (None, "beside") if told is None else (None, "beside", "ahead" if ahead else "behind")
            if where.lane in (None, "same", "adjacent") and where.rel in fits:
                where.lane = told or "adjacent"
            if where.lane in ("left", "right", "adjacent"):
                where.rel = where.rel or ("ahead" if ahead else "behind")


    def _between(self) -> None:
        """ "It merges between a truck and a sedan": the first is ahead of the gap, the second behind it."""
        for event in self.clauses.events:
            if not event.agent.ego or not event.done or event.act in ("travel", "stationary", "cross_road"):
                continue
            match = re.search(
                r"between (?:the |an? |two )?(?:[\w-]+ ){0,2}@(?P<a>a\d+)"
                r"(?: and (?:the |an? |another )?(?:[\w-]+ ){0,2}@(?P<b>a\d+))?",
                self.clauses.render([w.i for w in self.words if w.sentence == self.words[event.word].sentence]),
            )
            pair = [e for key in ("a", "b") for e in self.cast.entities if match and e.key == match[key]]
            if len(pair) != 2:
                continue
            towards = side(event)
            for other, rel in zip(pair, ("ahead", "behind"), strict=True):
                where = self.of[other]
                if where.lane in (None, "same") and where.rel is None:
                    where.lane, where.rel, where.side = towards or "left", rel, towards or "left"

    def _shared(self) -> None:
        """ "Two cars and a truck standing across the lane": what is said of the last holds for those before it."""
        for entity in self.cast.entities:
            where = self.of[entity]
            told = where.rel or where.lane or where.side
            if told or any(e.agent is entity or entity in e.also for e in self.clauses.events):
                continue
            for mention in entity.mentions:
                for child in self.words[mention.word].children:
                    self.cast.of.get(child)

    def _in_the_way(self) -> None:
        """What stands in the lane that is named, and that ego goes round, is in ego's own lane."""
        own = [e for e in self.clauses.events if e.agent.ego and e.done]
        for entity in self.cast.entities:
            where = self.of[entity]
            if where.lane not in ("left", "right") or where.of is not None or self.ego_lane is not None:
                continue
            stands = not entity.mover or bool(entity.roles & {"stationary", "parked"})
            stands = stands or any(e.agent is entity and e.act == "stationary" for e in self.clauses.events)
            named = " ".join(t for _, t in where.phrases)
            if not stands or not re.search(r"(left|right)[\w-]* lane", named):
                continue
            round_it = re.compile(rf"\b(around|round|avoid|evade|block) (the )?@{entity.key}\b")
            met = any(round_it.search(e.text) for e in own)
            halts = re.search(r"\bblock\w*\b", named) and any(e.act in HALTS for e in own)
            aside = [e for e in own if e.act in DODGES and side(e) == OPPOSITE[where.lane]]
            dodges = bool(aside)
            named_so = {e.act for e in own if e not in aside and re.search(r"(left|right|middle)[\w-]* lane", e.whole)}
            if met or halts and not named_so or dodges and named_so <= {"collide"}:
                self.ego_lane = f"{where.lane}most"
                where.lane, where.rel, where.side = "same", "ahead", None

    def _overtaken(self) -> None:
        """One whom another (not ego) overtakes drives ahead of that other."""
        for event in self.clauses.events:
            other = event.patient
            if (
                event.act != "overtake"
                or other is None
                or other.ego
                or event.agent.ego
                or other not in self.of
                or event.agent not in self.of
            ):
                continue
            where, whose = self.of[other], self.of[event.agent]
            if (where.lane == "oncoming" or "oncoming" in other.roles) and whose.lane in (
                None,
                "same",
                "left",
                "right",
            ):
                whose.lane = "oncoming"
            if where.rel is None and where.lane is None:
                where.lane, where.rel, where.side = whose.lane, "ahead", whose.side
                if whose.lane in (None, "same", "left", "right"):
                    where.of, where.lane = event.agent, "same"

    def _referred(self) -> None:
        """ "In that lane", "there", "where", "the same queue": the lane that was spoken of last."""
        for entity in self.cast.entities:
            where = self.of[entity]
            if where.lane not in (None, "same", "adjacent") or not entity.mover:
                continue
            for event in self.clauses.events:
                if event.agent is not entity or event.mode == "hypothetical":
                    continue
                text = event.whole
                if (
                    re.search(
                        (
                            r"in (that|this|there|it)( very)? lane|\b(in )?there\b(?! (be|come|stand|appear|lie|sit"
                            r"|wait)\b)|in that lane|stand in (it\b|@\w+\b(?! 's))"
                        ),
                        text,
                    )
                    or event.adverbial == "where"
                    or re.match(r"where", text)
                ):
                    side = self._last_lane(self.words[event.word].start)
                    if side:
                        where.lane = side
                        break

    def _last_lane(self, before: int) -> str | None:
        plain = " ".join(w.norm for w in self.words if w.start < before)
        found = None
        for match in re.finditer(
            (
                r"(?:mov\w+|merg\w+|chang\w+|shift\w*|steer\w*|pull\w*)(?: lanes?)?(?: over| out)?(?: to the"
                r"| to)? (left|right)\b|\b(left|right)(?:-hand|most)?(?: hand)? lane|lane (?:immediately "
                r"|directly )?(?:to|on) (?:the|its|their) (left|right)|lane on the (left|right)"
                r"|second lane[^.;]*(left|right)"
            ),
            plain,
        ):
            found = next(g for g in match.groups() if g)
        return found

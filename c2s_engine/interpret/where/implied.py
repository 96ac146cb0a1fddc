"""Places that follow from what happens: whom ego meets or hits over the centre line, who comes the other way, who
crosses."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.where.implied_lanes import (
    STANDING_OR_LED,
    hit_beside,
    in_from,
    in_from_aside,
    into_ego_lane,
    sideswipes,
    unseen,
)
from c2s_engine.interpret.who.mentions import Cast

SWERVES = ("swerve", "veer", "steer", "dodge", "jink", "weave")
ANSWERS = frozenset(("yield", "brake", "brake_stop", "stop", "evade", "swerve"))


def implied_places(cast: Cast, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Fill the places that only what happens tells."""
    for event in list(clauses.events):
        if event.done and event.act in ("approach", "travel"):
            _comes(event, clauses, of)
        if event.done and event.act in ("cross_road", "go_after") and event.agent in of:
            _same_side(event, clauses, of)
        if event.done and event.act in ("lane_change", "overtake") and event.agent in of:
            _out_from_behind(event, of)
        if event.done and event.act == "evade" and event.agent in of and event.patient in of:
            _ahead_of_who_avoids(event, of)
        if (event.done or event.mode == "negated") and event.agent.ego and event.patient in of:
            _crosses(event, clauses, of[event.patient])
        if event.done and event.agent.ego and event.patient in of:
            hit_beside(event, clauses, of[event.patient])
        if event.done and event.act == "collide" and event.agent.ego and event.patient in of:
            _behind_or_beside_road(event, clauses, of)
        if event.done and event.act == "oncoming" and event.agent.ego:
            _over_the_line(event, clauses, of)
        elif event.done and event.act in ("lane_change", "drift") and event.agent.ego:
            unseen(event, cast, clauses, of)
        elif event.done and event.agent in of and (_comes_over(event, of) or _overtakes_oncoming(event, of)):
            event.act, event.side = "oncoming", "left"
        elif event.done and event.act == "overtake" and event.agent in of and event.patient is None:
            _past_another(event, clauses, of[event.agent])
        elif event.done and event.act in ("cut_in", "lane_change") and in_from(event, of):
            in_from_aside(clauses, of[event.agent])
        elif event.done and event.act == "collide" and event.agent in of:
            sideswipes(event, clauses, of)
        elif event.done and event.act in ("lane_change", "drift", "swerve") and event.agent in of:
            into_ego_lane(event, of)
        elif event.done and event.act == "follow" and event.patient in of:
            _behind_whom_it_follows(event, clauses, of)
        elif (
            event.done
            and event.act in ("approach", "travel", "oncoming")
            and (EACH_OTHER.search(event.text) or MEET_AT.match(event.text))
        ):
            _towards_each_other(event, clauses, of)


def _ahead_of_who_avoids(event: Event, of: dict[Entity, Where]) -> None:
    """Whom another than ego brakes or swerves for is ahead of that one."""
    agent, patient = event.agent, event.patient
    assert patient is not None
    if (
        of[patient].open
        and of[patient].lane is None
        and agent.mover
        and not agent.person
        and of[agent].of is not patient
    ):
        of[patient].rel, of[patient].of = "ahead", agent


AFTER = re.compile(r"(?:chase|\w+ (?:\w+ )?after) (?:it|him|her|(?:the |its |his |her )?(?:\w+ )?(?:ball|@a\d+))\b")
ROLLS = re.compile(r"\bball\b[^.;]*? from (?:the |its )?(?P<side>left|right)\b")


def _same_side(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Who runs after one that crosses, or after a ball, comes from the same side."""
    if not AFTER.match(event.text) or of[event.agent].side is not None or not event.agent.person:
        return
    before = [e for e in clauses.events if e.act == "cross_road" and e.order < event.order and e.agent in of]
    sides = [of[e.agent].side for e in before if e.agent is not event.agent]
    sentence = clauses.words[event.word].sentence
    near = clauses.render([w.i for w in clauses.words if w.sentence in (sentence - 1, sentence)])
    ball = ROLLS.search(near)
    of[event.agent].side = sides[-1] if sides else ball["side"] if ball else None


FROM_OPPOSITE = re.compile(
    r"\b(?:from the (?:opposite|other|opposing) (?:direction|way|side|end)|the other way)\b(?! of)"
)


def _comes(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Who comes while ego is in the lane of the other direction comes the other way."""
    if event.agent.ego and FROM_OPPOSITE.search(event.whole):
        for other, where in of.items():
            beside = where.rel is not None and (where.of is None or where.of.ego)
            if other.type in MOTOR and where.lane is None and not beside and not other.roles & STANDING_OR_LED:
                where.lane = "oncoming"


def _out_from_behind(event: Event, of: dict[Entity, Where]) -> None:
    """Who pulls out from behind one that comes the other way overtakes that one."""
    where = of[event.agent]
    if where.of in of and where.rel == "behind" and of[where.of].lane == "oncoming":
        event.act = "overtake" if event.act == "lane_change" else event.act
        event.patient = event.patient or where.of


def _behind_whom_it_follows(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Who follows another that is in a lane of its own is behind that one, where nothing else is told of it."""
    follower, leader = event.agent, event.patient
    if (
        leader is None
        or follower is leader
        or follower not in of
        or any(e.agent is leader and e.patient is follower for e in clauses.events)
    ):
        return
    where, ahead = of[follower], of[leader]
    if where.rel is None and where.of is None and where.lane in (None, ahead.lane) and ahead.lane is not None:
        where.rel, where.of, where.lane = "behind", leader, None


EACH_OTHER = re.compile(
    r"^(?:approach|near|meet|face|(?:come|drive|travel|head|move|ride|go|run) (?:\w+ ){0,2}(?:towards?|at|to))"
    r" (?:each other|one another)\b"
)


MEET_AT = re.compile(r"(?:meet|converge)\b.*\b(?:intersection|junction|crossroads?|crossing)\b|\w+ .*\bright angles\b")


ACROSS_PATH = re.compile(r"\bleft\b.*\b(?:across|in front of|path of)\b")


def _towards_each_other(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Of two that approach each other, of which ego is one, the other comes the other way; from the side where they
    meet at a junction."""
    both = [event.agent, *event.also, *([event.patient] if event.patient is not None else [])]
    if not any(e.ego for e in both):
        return
    for other in both:
        turns = any(
            e.agent is other and e.act == "turn" and ACROSS_PATH.search(e.text) for e in clauses.events if e.done
        )
        if other in of and other.mover and not other.person and of[other].open and not turns:
            of[other].lane = "crossing" if MEET_AT.match(event.text) else "oncoming"


ACROSS = frozenset(("lane_change", "drift", "swerve", "lose_control", "cross_path"))
OVER_LINE = re.compile(
    r"\b(?:over|across|onto|into|cross\w*) (?:the |a |an |its )?"
    r"(?:solid |white |yellow |double |middle |broken |centre |center |central |dividing )*"
    r"(?:lines?|markings?|middle)\b"
)


def _comes_over(event: Event, of: dict[Entity, Where]) -> bool:
    """Whether one who comes the other way gets over the line, and not little by little."""
    slowly = event.act == "drift" and re.search(r"\b(?:slowly|gradually|little by little)\b", event.whole)
    towards = event.act in ACROSS and of[event.agent].lane == "oncoming"
    return towards and OVER_LINE.search(event.text) is not None and not slowly


def _overtakes_oncoming(event: Event, of: dict[Entity, Where]) -> bool:
    """Whether one who comes the other way overtakes somebody who is not told of: it does so in ego's lane."""
    waited = event.adverbial in ("until", "till", "after", "once", "when", "before")
    where = of[event.agent]
    towards = event.act == "overtake" and where.lane == "oncoming" and where.rel != "behind" and not waited
    return towards and (event.patient is None or event.patient.ego)


def _crosses(event: Event, clauses: Clauses, where: Where) -> None:
    """A person for whom ego brakes or waits, and of whom nothing else is told, crosses the road."""
    who = event.patient
    assert who is not None
    answers = ANSWERS if who.type not in ("pedestrian", "child") or not event.done else ANSWERS | {"collide"}
    if event.act not in answers and not event.text.startswith(("react", "respond")):
        return
    told = any((e.agent is who or who in e.also) and e.act != "travel" for e in clauses.events)
    if who.person and not told and not who.roles and where.rel is None and where.lane is None:
        clauses.events.append(Event.echo(event, act="cross_road", agent=who, order=event.order - 0.3))


def _past_another(event: Event, clauses: Clauses, where: Where) -> None:
    """Who is ahead of ego and gets past somebody unnamed moves out of its lane; it does not overtake ego."""
    if where.rel == "ahead" and where.lane in (None, "same") and (where.of is None or where.of.ego):
        around = clauses._lemma(clauses.words[event.word]) in SWERVES
        event.act, event.side = ("swerve" if around else "lane_change"), event.side or "left"


def _behind_or_beside_road(hit: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """What ego hits while it reverses stands behind it; what it hits off the road stands beside the road."""
    other = hit.patient
    assert other is not None
    before = [e for e in clauses.events if e.agent.ego and e.done and e.order < hit.order]
    where, still = of[other], not other.mover
    backs = before and before[-1].act == "reverse"
    if backs and where.rel is None and (still or where.lane in (None, "same", "parked")):
        where.rel, where.lane = "behind", "same"
    elif still and any(e.act == "leave_road" for e in before) and where.lane in (None, "same"):
        where.lane = "roadside"


def _over_the_line(event: Event, clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Whom ego hits after it crossed the centre line comes towards it."""
    for hit in clauses.events:
        other = hit.patient if hit.agent.ego else hit.agent
        if hit.act != "collide" or not hit.done or hit.order < event.order or other is None or other not in of:
            continue
        still = other.roles & {"lead", "stationary", "parked"}
        passed = any(e.patient is other and e.act in ("overtake", "follow") for e in clauses.events)
        behind = re.search(r"rear|behind|back of", hit.whole)
        if other.mover and not other.person and of[other].open and not still and not passed and not behind:
            of[other].lane = "oncoming"

"""Who did it where a passive does not say so: "she is struck", "the ego is cut off", "the van is being overtaken"."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import MOTOR, Entity, Mention
from c2s_engine.interpret.what.clauses import BY, Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

FROM_BEHIND = re.compile(r"\bfrom (?:behind|the rear)\b|\brear-?end|\bin the (?:rear|back)\b")
BY_A_PART = re.compile(
    r"\bby (?:the |its )?(?:(?:front|rear|left|right|near|off|near-?side|off-?side|passenger|driver|wing|door) ?)*"
    r"(?:corner|bumper|wing|mirror|bonnet|hood|front|wheel|fender|side)\b(?! (?:of|and)\b)(?! @)"
)
SUFFERED = frozenset(("collide", "overtake", "cut_in", "approach"))


def unnamed_doers(cast: Cast, clauses: Clauses) -> None:
    """Turn the passives without an agent round: the one spoken of suffers it from ego, or ego from the one near it."""
    for event in clauses.events:
        if event.act == "collide" and event.passive and not cast.ego.mentions and _told_later(event, clauses):
            event.mode = "hypothetical"
            continue
        part = BY_A_PART.search(event.whole) is not None
        if event.act not in SUFFERED or not event.passive or not part and BY.search(event.whole) or event.also:
            continue
        suffers = event.agent
        if event.act == "approach" and (suffers.ego or not suffers.mover):
            continue
        doer = _last(cast, clauses, event) if suffers.ego else cast.ego
        if part and not cast.ego.mentions:  # "a bus braked, a pedestrian was hit by the front left corner"
            motors = [cast.of[i] for i in sorted(cast.of) if i < event.word and cast.of[i].type in MOTOR]
            doer = next((e for e in reversed(motors) if e is not suffers), doer)
        if event.patient is not None and event.patient is not suffers and not event.patient.ego:
            continue
        if event.act == "cut_in" and doer is cast.ego and any(e.act == "turn" and e.agent.ego for e in clauses.events):
            event.mode = "hypothetical"  # ego's turn is what cuts it off
        if (
            suffers.ego
            and event.act == "collide"
            and FROM_BEHIND.search(event.whole)
            and not _may_follow(doer, clauses)
        ):
            word = cast.words[event.word]
            doer = cast._new(Entity("", "vehicle", noun="vehicle"))
            doer.mentions.append(Mention(word.i, word.start, word.end, kind="unnamed"))
        if doer is not None:
            event.agent, event.patient = doer, suffers


def _told_later(event: Event, clauses: Clauses) -> bool:
    """Whether it is told later who did it: "he was hit as he crossed. The car that hit him ..."."""
    suffers = event.patient if event.agent.ego else event.agent
    later = (e for e in clauses.events if e.act == "collide" and not e.passive and e.done and e.word > event.word)
    unnamed = event.agent.ego and BY.search(event.whole) is None
    return unnamed and any(e.patient is suffers and not e.agent.ego for e in later)


def _may_follow(doer: Entity | None, clauses: Clauses) -> bool:
    """Whether one spoken of can be who hit ego from behind: a vehicle of which nothing is told but that."""
    if doer is None or doer.type not in MOTOR or doer.roles & {"lead", "oncoming", "parked", "stationary"}:
        return False
    ahead = ("brake", "stop", "brake_stop", "stationary", "cut_in", "turn", "cross_path")
    near = {w.norm for m in doer.mentions for w in clauses.words[max(0, m.word - 3) : m.word + 5]}
    if "behind" in near or any(e.act == "follow" and e.agent is doer for e in clauses.events):
        return True
    met = any(e.agent.ego and e.patient is doer for e in clauses.events)
    return not met and not any(e.agent is doer and e.act in ahead for e in clauses.events)


def _last(cast: Cast, clauses: Clauses, event: Event) -> Entity | None:
    """The one that does something to ego near a passive: spoken of before it, else right after it."""
    number = cast.words[event.word].sentence
    movers = [i for i in sorted(cast.of) if cast.of[i].mover and not cast.of[i].ego and cast.of[i] in cast.entities]
    before = [i for i in movers if i < event.word and cast.words[i].sentence >= number - 1]
    after = [i for i in movers if i > event.word and cast.words[i].sentence <= number + 1]
    near = before[-1:] or after[:1]
    if event.act == "overtake":
        passing = [i for i in before + after if "fast" in cast.of[i].roles]
        near = passing[:1] or near
    return cast.of[near[0]] if near else None

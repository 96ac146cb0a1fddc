"""Headlines and notes that name a collision and who was in it: "Rear-end, I-80, two semis", "Lorry hits cyclist"."""

import re

from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

KINDS: tuple[tuple[str, str | None, str | None], ...] = (
    (r"\brear[- ]?end(?:er|ing|ed)?\b|\bshunt\b|\bchain reaction\b|\bpile-?up\b", "ahead", "same"),
    (r"\bhead[- ]on\b", None, "oncoming"),
    (r"\bt-?bone[ds]?\b|\bbroadside[ds]?\b|\b(?:right )?angle (?:crash|collision)\b", None, "crossing"),
    (r"\bside[- ]?swipe[ds]?\b", "beside", "left"),
    (r"\b(?:collision|crash|wreck|prang|fender[- ]bender|smash)\b", "ahead", "same"),
)
"""What names a collision; relation and lane of whom it was with."""


def headline(cast: Cast, clauses: Clauses, of: dict[Entity, Where], road: Road) -> None:
    """Who hits whom, and where both were, where only a headline says that they collided."""
    if any(e.done and e.act != "travel" for e in clauses.events) or any(w.tag in ("VBZ", "VBD") for w in cast.words):
        return
    first = " ".join(w.norm for w in cast.words[:14])
    kind = next(((rel, lane) for pattern, rel, lane in KINDS if re.search(pattern, first)), None)
    parties = [e for e in cast.entities if e.mover and "parked" not in e.roles]
    if kind is None or not parties or len(parties) > 3:
        return
    if not cast.ego.mentions and len(parties) > 1:
        own = next((e for e in parties if e.type in MOTOR and e.count == 1), None)
        if own is not None:
            cast.become_ego(own)
            parties.remove(own)
            of.pop(own, None)
    elif not cast.ego.mentions and parties[0].count > 1:
        cast.ego.type, cast.ego.typed = (parties[0].type if parties[0].type in MOTOR else "car"), True
        parties[0].count -= 1
    struck = parties[0]
    word = cast.words[struck.mentions[0].word]
    where = of[struck]
    if where.open:
        where.rel, where.lane = kind
    if kind[1] == "crossing" and road.kind is None:
        road.kind = "intersection"
    at = {"order": float(word.i), "words": [word.i], "start": word.start, "end": word.end}
    clauses.events.append(Event("collide", cast.ego, word.i, first, first, struck, **at))


def story_first(cast: Cast, clauses: Clauses) -> None:
    """Put a blow that a headline tells behind what the story tells of: "Lorry hits cyclist. The lorry turned left"."""
    if not cast.headlined or not clauses.events:
        return
    last = max(e.order for e in clauses.events)
    for event in clauses.events:
        parties = {event.agent, event.patient}
        told = (e for e in clauses.events if e.act == "collide" and e.done and clauses.words[e.word].sentence > 0)
        if event.act == "collide" and event.done and clauses.words[event.word].sentence == 0:
            if any(None not in (e.agent, e.patient) and {e.agent, e.patient} == parties for e in told):
                event.mode = "hypothetical"
            event.order = last + 1

"""Headlines and notes that name a collision and who was in it: "Rear-end, I-80, two semis", "Lorry hits cyclist"."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
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


def story_first(cast: Cast, clauses: Clauses) -> None:
    """Put a blow that a headline tells behind what the story tells of: "Lorry hits cyclist. The lorry turned left"."""
    if not cast.headlined or not clauses.events:
        return
    last = max(e.order for e in clauses.events)
    for event in clauses.events:
        if event.act == "collide" and event.done and clauses.words[event.word].sentence == 0:
            event.order = last + 1

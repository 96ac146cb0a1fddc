"""What others do to a vehicle, or where they are seen from it, that makes it the one whom a text is about."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, Entity


def cut_off(entity: Entity, clauses: Clauses) -> bool:
    """Whether another vehicle cuts in in front of it: then it is whom the text is about, wherever it drives."""
    done = (v for v in clauses.events if v.patient is entity and v.agent is not entity and v.done)
    return any(v.act == "cut_in" and v.agent.type in MOTOR for v in done)


def crossed(entity: Entity, clauses: Clauses) -> bool:
    """Whether another turns across its path."""
    path = re.compile(rf"\b(?:path|way) of (?:a |an |the |another )?(?:\w+ )?@{entity.key}\b")
    return any(v.agent is not entity and v.done and path.search(v.whole) for v in clauses.events)


def who_is_led(leader: Entity, candidates: list[Entity], clauses: Clauses) -> Entity:
    """Who drives behind one that brakes, where it only follows: "a van, followed by a car, brakes"."""
    brakes = any(v.agent is leader and v.done and v.act in ("brake", "stop", "brake_stop") for v in clauses.events)
    done = [v for v in clauses.events if v.done]
    behind = [v.agent for v in done if v.act == "follow" and v.patient is leader]
    behind += [v.patient for v in done if v.act == "lead" and v.agent is leader and v.patient is not None]
    calm = {"follow", "travel", "brake", "stop", "keep_lane", "brake_stop"}
    found = [e for e in behind if e in candidates and {v.act for v in done if v.agent is e} <= calm]
    return found[0] if brakes and found else leader


def anchors(entity: Entity, clauses: Clauses) -> bool:
    """Whether others are placed by it ("ahead of the coach", "behind the coach"): it is who the text is about."""
    text = clauses.render(list(range(len(clauses.words))))
    placed = set(
        re.findall(rf"\b(ahead of|behind|in front of|alongside|beside|next to) (?:the )?@{entity.key}\b", text)
    )
    return len(placed) > 1


def who_met_it(passive: Entity, candidates: list[Entity], clauses: Clauses) -> Entity:
    """Who overtakes or follows one that does nothing itself, though that is told first ("while overtaking a tractor, a
    Golf hit a Corsa"), or hits another ("a child crossed behind a van. The car that hit him ...")."""
    met = (v for v in clauses.events if v.act in ("overtake", "follow", "approach") and v.patient is passive)
    hits = [v for v in clauses.events if v.act == "collide" and v.done]
    hits = [] if any(passive in (v.agent, v.patient, *v.also) for v in hits) else hits
    return next((v.agent for v in (*met, *hits) if v.agent in candidates), passive)

"""What others do to a vehicle, or where they are seen from it, that makes it the one whom a text is about."""

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Entity


def trailing_vehicle(leader: Entity, candidates: list[Entity], clauses: Clauses) -> Entity:
    """Who drives behind one that brakes, where it only follows: "a van, followed by a car, brakes"."""
    brakes = any(v.agent is leader and v.done and v.act in ("brake", "stop", "brake_stop") for v in clauses.events)
    done = [v for v in clauses.events if v.done]
    behind = [v.agent for v in done if v.act == "follow" and v.patient is leader]
    behind += [v.patient for v in done if v.act == "lead" and v.agent is leader and v.patient is not None]
    calm = {"follow", "travel", "brake", "stop", "keep_lane", "brake_stop"}
    found = [e for e in behind if e in candidates and {v.act for v in done if v.agent is e} <= calm]
    return found[0] if brakes and found else leader


def active_counterpart(passive: Entity, candidates: list[Entity], clauses: Clauses) -> Entity:
    """Who overtakes or follows one that does nothing itself, though that is told first ("while overtaking a tractor, a
    Golf hit a Corsa"), or hits another ("a child crossed behind a van. The car that hit him ...")."""
    met = (v for v in clauses.events if v.act in ("overtake", "follow", "approach") and v.patient is passive)
    hits = [v for v in clauses.events if v.act == "collide" and v.done]
    hits = [] if any(passive in (v.agent, v.patient, *v.also) for v in hits) else hits
    return next((v.agent for v in (*met, *hits) if v.agent in candidates), passive)

"""What follows a collision of ego's and is no part of the scene: where the wrecks came to rest, who got out, who was
charged with what."""

from __future__ import annotations

from c2s_engine.interpret.entities import URGENT, Entity
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast


def aftermath(cast: Cast, clauses: Clauses) -> None:
    """Leave out what became of the parties once they had hit each other, and what they were charged with."""
    hits = [e for e in clauses.events if e.act == "collide" and e.done]
    own = [e for e in hits if cast.ego in (e.agent, e.patient, *e.also)]
    if own:
        last = max(e.word for e in own)
        for entity in [e for e in cast.entities if _came_after(e, last, hits, clauses)]:
            cast.entities.remove(entity)
            clauses.events[:] = [e for e in clauses.events if e.agent is not entity]


def _came_after(entity: Entity, last: int, hits: list[Event], clauses: Clauses) -> bool:
    """Whether somebody is only told of after the last collision: who got out, who was hurt, who came to help."""
    first = entity.mentions[0].word if entity.mentions else 0
    if first <= last or any(entity in (e.agent, e.patient, *e.also) for e in hits):
        return False
    acts = any(entity in (e.agent, e.patient, *e.also) and e.done and e.act != "travel" for e in clauses.events)
    return entity.type in URGENT or entity.person and entity.type != "animal" and not acts

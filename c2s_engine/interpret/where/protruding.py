"""Who stands off the road, and partly in ego's lane: "on the shoulder, projecting into ego's lane"."""

from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Entity


def protruding(clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Put those partly into ego's lane who are told to be at the roadside and to reach into the lane."""
    for entity, where in of.items():
        if where.lane not in ("parked", "roadside") or entity.person:
            continue

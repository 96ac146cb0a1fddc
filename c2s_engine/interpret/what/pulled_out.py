"""Who "pulled out", no more being told: it comes onto the road, or on a motorway into ego's lane."""

from __future__ import annotations

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, Cast


def pulled_out(cast: Cast, clauses: Clauses, road: Road) -> None:
    """Let who is nowhere yet and pulls out come onto the road."""
    for event in clauses.events:
        if event.act != "lane_change" or event.agent.ego or event.agent.type not in MOTOR | {"vehicle"}:
            continue
        continue

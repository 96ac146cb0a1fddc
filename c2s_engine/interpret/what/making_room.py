"""Making room for one who comes from behind: "ego must make room so that the ambulance can get past"."""

import re

from c2s_engine.interpret.entities import MOTOR, URGENT
from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast, Entity

BEHIND = re.compile(r"\b(?:behind|rear|clos\w+ in|catch\w* up|tailgat\w+)\b")


def makes_room(cast: Cast, clauses: Clauses, road: Road) -> None:
    """Who makes room for one from behind moves aside and lets that one by; in its own lane, if there is no other."""
    for event in [e for e in clauses.events if e.act == "make_room"]:
        other = _from_behind(cast, clauses)
        aside = any(e.agent.ego and e.done and e.act in ("lane_change", "swerve", "leave_road") for e in clauses.events)
        if not event.agent.ego or other is None or aside:
            event.act = "travel"
            continue
        event.act = "lane_change" if (road.lanes or 1) > 1 else "swerve"
        event.side = None if event.act == "lane_change" else "right"
        clauses.events.append(Event.echo(event, act="yield", patient=other, order=event.order + 0.1))


def _from_behind(cast: Cast, clauses: Clauses) -> Entity | None:
    """Who comes from behind: an emergency vehicle, or one of which that is told."""
    vehicles = [e for e in cast.entities if e.type in MOTOR]
    told = (e for e in vehicles if any(v.agent is e and BEHIND.search(v.whole) for v in clauses.events))
    return next((e for e in vehicles if e.type in URGENT), None) or next(told, None)

"""Making room for one who comes from behind: "ego must make room so that the ambulance can get past"."""

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast


def makes_room(cast: Cast, clauses: Clauses, road: Road) -> None:
    """Who makes room for one from behind moves aside and lets that one by; in its own lane, if there is no other."""
    for event in [e for e in clauses.events if e.act == "make_room"]:
        event.act = "travel"
        continue

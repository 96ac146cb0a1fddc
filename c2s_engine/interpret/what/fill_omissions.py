"""What reports of crashes leave untold: that one behind who "did not stop" ran into ego, that one who turns out of a
drive comes onto the road, that one who is struck while it waits to turn never turns."""

from __future__ import annotations

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

STANDS = frozenset(("stationary", "stop", "brake_stop", "yield"))
IDLE = STANDS | {"travel", "collide", "brake", "approach", "follow", "keep_lane"}
OFF_ROAD = re.compile(
    r"\b(?:from|out of|exit|leave) (?:the |an? |its |his |her |their )(?:[\w-]+ ){0,2}"
    r"(?:driveway|drive|parking lot|car park|lot"
    r"|(?:gas|petrol|filling|service) station|alley|yard|field|gate|parking space|private road|property|entrance)\b"
)
WAITS = re.compile(r"\bwait\b")


def fill_omissions(cast: Cast, clauses: Clauses) -> None:
    """Fill in what such reports leave out."""
    _stand_before(cast, clauses)
    for event in list(clauses.events):
        if event.act == "turn" and event.done and not event.agent.ego and OFF_ROAD.search(event.text):
            event.act = "enter_road"


def _stand_before(cast: Cast, clauses: Clauses) -> None:
    """Who stands behind another, or is pushed into it from a stand, has one before it that stands, too."""
    for event in [e for e in clauses.events if e.done and e.agent.mover and not e.agent.ego]:
        other = event.patient
        if other is None or other.ego or not other.mover or other.person or other.roles:
            continue
        behind = event.act == "stationary" and re.search(rf"\bbehind (?:the )?@{other.key}\b", event.text)
        stands = event.agent.roles & {"stationary", "parked"} or any(
            e.agent is event.agent and e.act == "stationary" and e.order < event.order for e in clauses.events
        )
        acts = any(other in (e.agent, *e.also) and e.done for e in clauses.events)
        if not acts and (behind or event.act == "collide" and stands):
            other.roles.add("stationary")


def struck_standing(clauses: Clauses, event: Event | None = None) -> bool:
    """Whether ego, or who does that, stands and is struck before it goes on to do anything."""
    who = event.agent if event is not None else clauses.cast.ego
    own = [e for e in clauses.events if e.agent is who and e.done and e is not event]
    stands = [e for e in own if e.act in STANDS - {"yield"} or e.act == "yield" and WAITS.search(e.text)]
    if not stands:
        return False
    onwards = [e for e in own if e.act not in IDLE and e.order > stands[0].order]
    struck = any(e.act == "collide" and e.done and e.patient is who for e in clauses.events)
    return struck and not onwards

"""What a turning lane tells: ego that is in one turns, unless it is said to go on otherwise."""

from __future__ import annotations

import re

from c2s_engine.interpret.surroundings.whereabouts import STATES
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.left_untold import struck_standing
from c2s_engine.interpret.who.mentions import Cast

IN_TURN_LANE = re.compile(
    r"\b(?:in|from|on|of|use|enter|into|take) (?:the |a |its |@ego 's )?(?:\w+ )?(?P<side>left|right)-turn lane\b"
)
AT_RED = re.compile(r"\b(?:at|before) (?:a |the )?red (?:traffic )?(?:light|signal)")
OTHERWISE = frozenset(("turn", "u_turn", "go_straight", "lane_change", "cut_in", "overtake", "collide"))


def turns_from_lane(cast: Cast, clauses: Clauses) -> None:
    """Ego that stands or drives in a lane for turning turns at last."""
    own = [e for e in clauses.events if e.agent.ego and e.done]
    if any(e.act in OTHERWISE for e in own) or struck_standing(clauses):
        return
    for event in own:
        match = IN_TURN_LANE.search(event.text) if event.act in STATES | {"stop", "brake_stop", "brake"} else None
        if match is not None and not re.search(r"@a\d+", event.text[: match.start()]):
            if AT_RED.search(event.text):
                event.act = "stationary"
            last = max(e.order for e in own) + 0.5
            clauses.events.append(Event.echo(event, act="turn", side=match["side"], order=last, words=[event.word]))
            return

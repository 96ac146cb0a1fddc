"""What a turning lane tells: ego that is in one turns, unless it is said to go on otherwise."""

from __future__ import annotations

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.left_untold import struck_standing
from c2s_engine.interpret.who.mentions import Cast

OTHERWISE = frozenset(("turn", "u_turn", "go_straight", "lane_change", "cut_in", "overtake", "collide"))


def turns_from_lane(cast: Cast, clauses: Clauses) -> None:
    """Ego that stands or drives in a lane for turning turns at last."""
    own = [e for e in clauses.events if e.agent.ego and e.done]
    if any(e.act in OTHERWISE for e in own) or struck_standing(clauses):
        return

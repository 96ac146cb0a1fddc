"""Who goes on with what was begun: "After a motorcycle had passed, it completed its turn"; who turns that waited to."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side

GOES = frozenset(("start", "go_straight", "cross_path", "cut_in", "cut_out", "enter_road"))
STRAIGHT = re.compile(
    r"\bstraight (?:on|ahead|through|over)\b|\binstead\b|\b(?:left|right)\b|\bu-turn\b|\boff (?:the )?(?:road|lane)\b"
)
"""What is no turn although one meant to turn."""
NOT_YET = frozenset(("hypothetical", "intended", "purpose"))
LATER = 60
"""Words within which one goes that was said to wait to turn."""


def waited_turns(clauses: Clauses) -> None:
    """Who waits to turn and then just goes, turns: "was waiting to turn left. It set off across my lane"."""
    for meant in [e for e in clauses.events if e.act == "turn" and side(e) is not None]:
        if meant.mode == "hypothetical" or meant.mode not in NOT_YET:
            continue
        later = [e for e in clauses.events if e.agent is meant.agent and e.order > meant.order and e.mode == "fact"]
        later = [e for e in later if e.word - meant.word < LATER]
        goes = next((e for e in sorted(later, key=lambda e: e.order) if e.act in GOES), None)
        if goes is None or STRAIGHT.search(goes.text) or any(e.act in ("turn", "u_turn") for e in later):
            continue
        goes.act, goes.side, goes.patient, meant.mode = "turn", side(meant), None, "hypothetical"

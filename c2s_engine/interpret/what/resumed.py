"""Who goes on with what was begun: "After a motorcycle had passed, it completed its turn"; who turns that waited to."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast

RESUMES = re.compile(
    r"(?:complete|finish|make|begin|start|continue|resume|execute|carry out|go on with|proceed with) "
    r"(?:with )?(?:@\w+ 's|its|his|her|their|the) (?:\w+ )?(?:turn|man(?:oeuvre|euver))\b"
)


def own_turns(cast: Cast, clauses: Clauses) -> None:
    """A turn that "it" completes is that of the one who was said to want to turn."""
    for event in clauses.events:
        if event.act != "turn" or event.mode != "fact" or not RESUMES.search(event.text):
            continue
        subjects = [c for c in cast.words[event.word].children if cast.words[c].dep == "nsubj"]
        if not subjects or cast.words[subjects[0]].norm not in ("it", "he", "she", "they"):
            continue
        earlier = [e for e in clauses.events if e.act == "turn" and e.word < event.word]
        if any(e.agent is event.agent for e in earlier):
            continue


def goes_first(clauses: Clauses) -> None:
    """Who stopped at a junction and then goes first, goes over it: "we all stop. The van goes first"."""
    for event in clauses.events:
        if event.act != "travel" or event.agent.ego or not GOES_FIRST.match(event.text):
            continue


GOES_FIRST = re.compile(r"(?:go|set off|move off|move|drive off|proceed|pull off|pull away)\b[^.;,]*?\bfirst\b")
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

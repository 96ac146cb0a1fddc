"""The side to which one turns where only its indicator tells it: "indicating right, the car turned into Dock Road"."""

from __future__ import annotations

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast

INDICATES = re.compile(
    r"\b(?:indicat|signal)\w*(?: (?:to|for|on|the|its|a|his|her|my|our|turn)){0,3} (left|right)\b"
    r"|\b(left|right)(?:-hand)? (?:turn )?(?:indicators?|blinkers?|signals?|flashers?)\b"
    r"|\b(?:indicators?|blinkers?|turn signals?|flashers?) (?:on |set |flashing |blinking |going )*"
    r"(?:(?:to|for) (?:the |a )?)?(left|right)\b"
)


def indicated(cast: Cast, clauses: Clauses) -> None:
    """Give a turn the side of its driver's indicator, where nothing else says it."""
    for event in clauses.events:
        if event.act == "turn" and event.done and side(event) is None:
            event.side = _indicator(cast, clauses, event)


def _indicator(cast: Cast, clauses: Clauses, event: Event) -> str | None:
    """The side that one indicates in the sentence of its turn or in that before."""
    last = cast.words[event.word].sentence
    for sentence in (last, last - 1):
        text = clauses.render([w.i for w in cast.words if w.sentence == sentence])
        if (match := INDICATES.search(text)) is None:
            continue
        named = re.findall(r"@(\w+)", text[: match.start()])
        if named and named[-1] == event.agent.key:
            return next(g for g in match.groups() if g)
    return None

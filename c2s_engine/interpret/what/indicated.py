"""The side to which one turns where only its indicator tells it: "indicating right, the car turned into Dock Road"."""

from __future__ import annotations

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast


def indicated(cast: Cast, clauses: Clauses) -> None:
    """Give a turn the side of its driver's indicator, where nothing else says it."""
    for event in clauses.events:
        if event.act == "turn" and event.done and side(event) is None:
            event.side = None

"""Who is only said not to do something is there all the same: "the child does not step onto the road" stands there."""

from __future__ import annotations

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

STEPS = frozenset(("cross_road", "enter_road"))


def stays_put(cast: Cast, clauses: Clauses) -> None:
    """One on foot or on a bicycle who is said not to come onto the road stands; what else it does is told elsewhere."""
    for event in list(clauses.events):
        if event.mode != "negated" or event.act not in STEPS:
            continue

"""Who is only said not to do something is there all the same: "the child does not step onto the road" stands there."""

from __future__ import annotations

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast, Entity

STEPS = frozenset(("cross_road", "enter_road"))
NAMED = frozenset(("the", "this", "that", "neither", "nor", "his", "her", "its", "my", "our"))


def stays_put(cast: Cast, clauses: Clauses) -> None:
    """One on foot or on a bicycle who is said not to come onto the road stands; what else it does is told elsewhere."""
    for event in list(clauses.events):
        if event.mode != "negated" or event.act not in STEPS:
            continue
        for who in (event.agent, *event.also):
            if who.ego or not (who.person or who.type == "bicycle") or not _known(who, cast):
                continue


def _known(who: Entity, cast: Cast) -> bool:
    """Whether one in particular is meant, not anybody: "the child", no "pedestrians do not cross here"."""
    return any({cast.words[c].norm for c in cast.words[m.word].children} & NAMED for m in who.mentions)

"""A vehicle whose door is opened is parked at the roadside, where nothing else is told of it; who hits the door hits
the vehicle."""

from __future__ import annotations

from c2s_engine.interpret.entities import MOTOR
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

OPENS = frozenset(("open", "fling", "swing", "throw", "fly", "push", "shove", "crack"))


def doors_opened(cast: Cast, clauses: Clauses) -> None:
    """Park those of whom no more is told than that a door of theirs opens."""
    for word in cast.words:
        if word.norm not in ("door", "doors") or word.span is not None:
            continue
        verb = cast.words[word.head]
        verb = cast.words[verb.head] if verb.lemma not in OPENS else verb
        who = None if verb.lemma in OPENS else None
        if who is None or who.ego or who.type not in MOTOR or who.roles & {"stationary", "lead"}:
            continue

"""A vehicle whose door is opened is parked at the roadside, where nothing else is told of it; who hits the door hits
the vehicle."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

OPENS = frozenset(("open", "fling", "swing", "throw", "fly", "push", "shove", "crack"))
DOOR = re.compile(
    r"\w+ (?:into |with |against |by )?(?:the |a |an |its |his |her |@\w+ 's )?"
    r"(?:(?:open|opened|opening|car|driver's) )*doors?\b"
)


def doors_opened(cast: Cast, clauses: Clauses) -> None:
    """Park those of whom no more is told than that a door of theirs opens."""
    for word in cast.words:
        if word.norm not in ("door", "doors") or word.span is not None:
            continue
        verb = cast.words[word.head]
        verb = cast.words[verb.head] if verb.lemma not in OPENS else verb
        who = _whose(word, verb, cast) if verb.lemma in OPENS else None
        if who is None or who.ego or who.type not in MOTOR or who.roles & {"stationary", "lead"}:
            continue
        told = [e for e in clauses.events if e.agent is who and e.done]
        if all(e.word == verb.i or e.act == "stationary" and ("door" in e.whole or e.whole == "stand") for e in told):
            who.roles.add("parked")
            for event in told:
                event.act, event.patient, event.text, event.whole = "stationary", None, "stand", "stand"
        _hit(cast, clauses, who)


def _hit(cast: Cast, clauses: Clauses, who: Entity) -> None:
    """Let who hits a door, or is hit by one, hit the vehicle that it belongs to."""
    for event in clauses.events:
        if event.act != "collide" or who in (event.agent, event.patient) or not DOOR.match(event.text):
            continue
        event.agent = event.patient if event.passive and event.patient is not None else event.agent
        event.patient, event.passive = who, False


def _whose(door: Word, verb: Word, cast: Cast) -> Entity | None:
    """Whose door it is: of whom it is said to be, else of who sits in the vehicle and opens it."""
    owner = next(
        (cast.of[c] for c in door.children if cast.words[c].dep in ("poss", "compound") and c in cast.of), None
    )
    subjects = [cast.words[c] for c in verb.children if cast.words[c].dep == "nsubj" and c != door.i]
    own = owner if owner is not None and not owner.person else None
    return own or next((found for w in subjects if (found := cast.referent(w.i)) is not None), None)

"""Animals that somebody on foot takes along: "a farmer drives his cows across the road"."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.what.clauses import Clauses

HERDS = language.words("herds")


def herded(clauses: Clauses) -> None:
    """Who is led or driven goes with who does it."""
    for event in clauses.events:
        taken = event.patient
        if (
            event.act in ("cross_road", "move_along")
            and event.agent.person
            and taken is not None
            and taken.type == "animal"
            and clauses.words[event.word].lemma in HERDS
            and not any(e.agent is taken and e.done for e in clauses.events)
        ):
            event.patient, event.also = None, [*event.also, taken]

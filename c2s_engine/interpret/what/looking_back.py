"""What is told later and came first: "It brakes. Before that, it cut in", "it had cut in shortly before"."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

IN_VAIN = re.compile(
    r"\b(?:could not|couldn't|unable to|not able to|failed to|too late to|no time to|was not enough to)"
    r" (?:\w+ )?(?:avoid|stop|prevent|evade|miss|react)\b"
)
TRIES = frozenset(
    ("turn_or_change", "brake", "brake_stop", "stop", "swerve", "lane_change", "evade", "reverse", "accelerate")
)


def looking_back(cast: Cast, clauses: Clauses) -> None:
    """What a sentence says to have come first is put before what was told of the same one."""
    for number in sorted({w.sentence for w in cast.words}):
        clauses.render([w.i for w in cast.words if w.sentence == number])
        continue


def tried_to_avoid(cast: Cast, clauses: Clauses) -> None:
    """Put what one tried in vain before the blow that was told first: "was struck by V2, whose driver said he swerved
    but could not avoid it", "hit a car because a child ran out and I had to swerve"."""
    for number in sorted({w.sentence for w in cast.words}):
        here = [w for w in cast.words if w.sentence == number]
        why = next((w.i for w in here if w.norm == "because"), None)
        why = here[0].i if why is None and IN_VAIN.search(" ".join(w.norm for w in here)) else why
        for event in [e for e in clauses.events if cast.words[e.word].sentence == number and e.done]:
            if why is None or event.word < why or event.act not in TRIES:
                continue
            blows = [e for e in clauses.events if e.act == "collide" and e.done and e.word < why]
            first = next((e.order for e in blows if event.agent in (e.agent, e.patient)), None)
            event.order = event.order if first is None else first - 0.3

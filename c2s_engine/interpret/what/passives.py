"""Who did it where a passive does not say so: "she is struck", "the ego is cut off", "the van is being overtaken"."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import Entity, Mention
from c2s_engine.interpret.what.clauses import BY, Clauses
from c2s_engine.interpret.who.mentions import Cast

FROM_BEHIND = re.compile(r"\bfrom (?:behind|the rear)\b|\brear-?end|\bin the (?:rear|back)\b")
BY_A_PART = re.compile(
    r"\bby (?:the |its )?(?:(?:front|rear|left|right|near|off|near-?side|off-?side|passenger|driver|wing|door) ?)*"
    r"(?:corner|bumper|wing|mirror|bonnet|hood|front|wheel|fender|side)\b(?! (?:of|and)\b)(?! @)"
)
SUFFERED = frozenset(("collide", "overtake", "cut_in", "approach"))


def unnamed_doers(cast: Cast, clauses: Clauses) -> None:
    """Turn the passives without an agent round: the one spoken of suffers it from ego, or ego from the one near it."""
    for event in clauses.events:
        part = BY_A_PART.search(event.whole) is not None
        if event.act not in SUFFERED or not event.passive or not part and BY.search(event.whole) or event.also:
            continue
        suffers = event.agent
        if event.act == "approach" and (suffers.ego or not suffers.mover):
            continue
        doer = None if suffers.ego else cast.ego
        if event.patient is not None and event.patient is not suffers and not event.patient.ego:
            continue
        if suffers.ego and event.act == "collide" and FROM_BEHIND.search(event.whole):
            word = cast.words[event.word]
            doer = cast._new(Entity("", "vehicle", noun="vehicle"))
            doer.mentions.append(Mention(word.i, word.start, word.end, kind="unnamed"))
        if doer is not None:
            event.agent, event.patient = doer, suffers

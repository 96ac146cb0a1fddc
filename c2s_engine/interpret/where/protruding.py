"""Who stands off the road, and partly in ego's lane: "on the shoulder, projecting into ego's lane"."""

import re

from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Entity

LANE = r"(?:the |ego ?'?s? |our |its |a )*(?:\w+ )?(?:lane|carriageway|roadway|road)\b"
PROTRUDES = re.compile(
    r"\b(?:project|protrud|jut|stick|poke|hang|extend|bulge|reach)\w* (?:out |over |partly |partially |halfway )*"
    rf"(?:in|on)?to {LANE}"
    r"|\b(?:tail|rear|back|end|corner|half|part|trailer)\b(?: of it)? (?:is |are |was |still |partly )*"
    rf"(?:block|obstruct)\w* {LANE}"
)
NOBODY = re.compile(r"\b(?:not|without|no longer|never)\b")


def protruding(clauses: Clauses, of: dict[Entity, Where]) -> None:
    """Put those partly into ego's lane who are told to be at the roadside and to reach into the lane."""
    for entity, where in of.items():
        if where.lane not in ("parked", "roadside") or entity.person:
            continue
        for sentence in {clauses.words[m.word].sentence for m in entity.mentions}:
            told = " ".join(w.norm for w in clauses.words if w.sentence == sentence)
            others = {e for w in clauses.words if w.sentence == sentence and (e := clauses.cast.of.get(w.i))}
            match = PROTRUDES.search(told)
            if match and not NOBODY.search(told[: match.start()]) and all(e.ego or e is entity for e in others):
                where.lane = "partly"

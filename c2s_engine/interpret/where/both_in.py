"""A lane that ego and another share: "ego follows a van, both in the left lane"."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.surroundings.whereabouts import Where
from c2s_engine.interpret.who.mentions import Cast

BOTH_IN = re.compile(
    r"\bboth(?: of them| vehicles| cars)? (?:(?:are|were|is|be|drive|drove|travel|travelling|driving|moving|stay|keep"
    r"|running) )?(?:in|on) (?:the )?(?P<lane>left|right|middle|centre|center)(?:-? ?(?:hand|most))? lane\b"
)
NAMES = {"left": "leftmost", "right": "rightmost"}


def both_in_lane(cast: Cast, of: dict[Entity, Where]) -> str | None:
    """Place the other one with ego in the lane that is named for both; the name of that lane."""
    for number in sorted({w.sentence for w in cast.words}):
        words = [w for w in cast.words if w.sentence == number]
        match = BOTH_IN.search(" ".join(w.norm for w in words))
        if match is None:
            continue
        own = {cast.of[w.i] for w in words if w.i in cast.of and cast.of[w.i].mover}
        earlier = {cast.of[i] for i in cast.of if cast.words[i].sentence == number - 1 and cast.of[i].mover}
        before = own if cast.ego in own and len(own) > 1 else own | earlier
        others = [e for e in before if not e.ego]
        if cast.ego not in before or len(others) != 1 or others[0].count > 1:
            continue
        where = of[others[0]]
        if where.lane in (None, "same", match["lane"]) and where.rel in (None, "ahead", "behind"):
            where.lane, where.side, where.rel = "same", None, where.rel or "ahead"
            return NAMES.get(match["lane"], "middle")
    return None

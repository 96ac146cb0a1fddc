"""Road users that are named and are not there: denied, towed, only looked at, or long gone."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word

HIDES = language.words("hides")
LOST, SAYS = language.words("lost"), language.words("says")
SEES = language.words("notices") | {"watch", "hear", "look", "help"}
FILLS = re.compile(r"(?:full of|(?:filled|packed) with|(?:occupied|taken) by)(?: \w+)?$")
_LANE = (
    r"(?:in|on|along) (?:the|its|our|my|both|all|all the|the other) (?:(?:two|three|outer|inner) )?"
    r"(?:(?:left|right|adjacent|neighbou?ring|next|other|second|middle|cent(?:er|re)|fast|slow|passing|overtaking|through)"
    r"(?: ?- ?hand)?(?: hand)? )?lanes?(?: (?:to|on) (?:its|the|our|my) (?:left|right))?"
)
PLACED_BY = frozenset(("between", "at", "by", "near", "beside", "past", "outside", "opposite"))
HEADS = frozenset(("actors", "objects", "vehicles", "participants", "users", "agents", "npcs", "obstacles", "others"))


class AbsentMentions:
    """The part of Cast that tells what is only named."""

    words: list[Word]
    of: dict[int, Entity]
    onlooker: bool  # whether somebody off the road tells the text

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

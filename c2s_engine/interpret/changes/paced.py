"""How fast each of several is, told in one sentence: "ego and the car should drive 60", "ego 60, the van 40".

Such a sentence says nothing but who goes how fast; it is read as one plain demand for each of them.
"""

import re
from functools import cache
from itertools import chain

from c2s_engine.interpret import language
from c2s_engine.interpret.changes import notes


@cache
def _pattern(name: str) -> re.Pattern[str]:
    table = language.table("wordings")
    return notes.compiled(table["paced"][name], {**table["words"], **table["paced"]["words"]})


def each_paced(match: re.Match[str]) -> str:
    """One demand for each of those who are told of with a speed; the sentence itself where only one is."""
    pairs = list(chain(_pattern("pair").finditer(match["said"]), _pattern("value_first").finditer(match["said"])))
    each = [(who, pair) for pair in pairs for who in _pattern("one").findall(pair["whos"])]
    if len(each) < 2 and not _pattern("alone").search(match["said"]):
        return match[0]
    unit = next((pair["unit"] for pair in pairs if pair["unit"]), "km/h")
    return ". ".join(f"{who} at {pair['value']} {pair['unit'] or unit}" for who, pair in each) + match["end"]


def sentence() -> tuple[re.Pattern[str], notes.New]:
    """The pattern of such a sentence, and what is read instead."""
    return _pattern("sentence"), each_paced

"""How many there are of those who are told of together: "five parked cars, not three", "one car less in the row"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import spec_of
from c2s_engine.structure.components import Structure

MOST = 8


def numbered(sentence: str, structure: Structure) -> str:
    """A sentence that says how many there are of some who are there, as "make o1 5"; else the sentence itself."""
    groups = [c for c in structure.objects if spec_of(c).count > 1]
    if len(groups) == 1:
        sentence = re.sub(language.table("wordings")["counts"]["them"], "the xs", sentence)
    for component in groups:
        number = None
        if number is not None:
            return f"make {component.id.lower()} {max(1, min(MOST, number))}"
    return sentence.replace("the xs", "they")

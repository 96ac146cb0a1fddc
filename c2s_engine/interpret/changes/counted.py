"""How many there are of those who are told of together: "five parked cars, not three", "one car less in the row"."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.how_many import count_of
from c2s_engine.interpret.changes.refer import objects_of, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure

MOST = 8


_HOW_MANY = re.compile(
    r"there (?:(?:are|is|should be|must be) (?:only|just|exactly)|(?:should|must"
    r"|shall) be) (?P<n>two|three|four|five|six|[1-8]) "
    r"(?P<noun>[a-z]+s?)\b(?P<rest>(?:(?:,| and) .*)?)$"
)


def numbered(sentence: str, structure: Structure) -> str:
    """A sentence that says how many there are of some who are there, as "make o1 5"; else the sentence itself."""
    groups = [c for c in structure.objects if spec_of(c).count > 1]
    if len(groups) == 1:
        sentence = re.sub(language.table("wordings")["counts"]["them"], "the xs", sentence)
    said = _HOW_MANY.match(sentence)
    alone = [c for c in structure.objects if said and c not in groups]
    for component in [*groups, *alone]:
        kind = next((s.data["type"] for s in scan.names(said["noun"]) if s.kind == "actor"), None) if said else None
        if said and component in objects_of(structure, kind or ""):
            number = count_of(said["n"], spec_of(component).count)
            return f"make {component.id.lower()} {max(1, min(MOST, number))}{said['rest'].replace(' and ', '. ', 1)}"
    return sentence.replace("the xs", "they")

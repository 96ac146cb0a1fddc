"""Somebody new who comes from where his like does not: "pedestrians from both sides", "another from the other side".

Who is there stays, and a side is told for the new one.
"""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import objects_of, spec_of
from c2s_engine.interpret.entities import PERSONS
from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import ObjectSpec


def sided(sentence: str, structure: Structure) -> str:
    """The sentence with a side for a new person, or as it is."""
    for pattern, new in _patterns():
        match = pattern.match(sentence)
        named = scan.names(match["noun"]) if match else []
        if match is None or not named or named[0].kind != "actor" or named[0].data["type"] not in PERSONS:
            continue
        kind = named[0].data["type"]
        there = [spec_of(c) for c in objects_of(structure, kind)]
        side = _free_side(there)
        if side is not None:
            said = new.replace("<noun>", kind).replace("<side>", side)
            return f"{match.expand(said)}{sentence[match.end() :]}"
    return sentence


def _free_side(there: list[ObjectSpec]) -> str | None:
    """The side from which the only one who is there does not come."""
    side = there[0].placement.side if len(there) == 1 and there[0].count == 1 else None
    return OPPOSITE[side] if side else None


@cache
def _patterns() -> list[tuple[re.Pattern[str], str]]:
    table = language.table("wordings")["sided"]
    return [(re.compile(language.filled(form, table["words"])), new) for form, new in table["forms"]]

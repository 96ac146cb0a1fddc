"""Who is meant by a rank or a look among those who are there: "the faster one", "the last one", "the white one"."""

import re
from collections.abc import Callable
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.chosen import ORDINALS, called
from c2s_engine.interpret.changes.refer import objects_of, spec_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec

MEASURES: dict[str, Callable[[ObjectSpec], float | None]] = {
    "speed": lambda s: None if s.speed is None else middle(s.speed),
    "gap": lambda s: None if s.placement.gap is None else middle(s.placement.gap),
    "size": lambda s: language.table("notes")["ranks"]["sizes"].get(s.type),
}
"""What those are compared by who are told of by a rank."""


Naming = Callable[[Component, Structure], str]
"""What calls somebody so that nobody else is meant."""


def ranked(plain: str, structure: Structure, call: Naming) -> str:
    """The text in which those are called by `call` who are told by rank or look, where only one can be meant."""

    def said(match: re.Match[str]) -> str:
        found = _meant(match["how"], match["head"], structure)
        return call(found, structure) if found is not None else match[0]

    return _pattern().sub(said, plain)


@cache
def _pattern() -> re.Pattern[str]:
    table = language.table("notes")["ranks"]
    ranks = "|".join(row["said"] for row in table["by"])
    heads = "|".join(head for head, _ in table["heads"])
    return re.compile(rf"(?:\b(?:the|that) |^)(?P<how>{ranks}|[\w-]+(?= ones?\b)) (?P<head>{heads}|ones?)\b(?! of\b)")


def _meant(how: str, head: str, structure: Structure) -> Component | None:
    """The only one who is first in that rank, or who is called so."""
    table = language.table("notes")["ranks"]
    kind = next((k for said, k in table["heads"] if re.fullmatch(said, head)), None)
    there = objects_of(structure, kind) if kind else [c for c in structure.objects if spec_of(c).type in table["sizes"]]
    if how in ORDINALS:
        return there[ORDINALS[how]] if -len(there) <= ORDINALS[how] < len(there) else None
    row = next((row for row in table["by"] if re.fullmatch(row["said"], how)), None)
    if row is None:
        found = [c for c in there if how in called(c)]
        return found[0] if len(found) == 1 else None
    values = {c.id: MEASURES[row["of"]](spec_of(c)) for c in there}
    known = sorted((v, cid) for cid, v in values.items() if v is not None)
    if len(known) < 2 or len(known) != len(values):
        return None
    first, second = (known[-1], known[-2]) if row["most"] else (known[0], known[1])
    return structure[first[1]] if first[0] != second[0] else None

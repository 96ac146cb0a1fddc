"""Who is pointed at by a number ("NPC 2", "car 2") or by a look that the text of the scene tells ("the red one")."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.meant import by_labels
from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure


def _table(section: str) -> Any:
    return language.table("turns")[section]


def missing(plain: str, structure: Structure) -> str:
    """The number of somebody, by the sheet or the program, whom there is not; empty where all are there."""
    plain = by_labels(plain, structure)
    ids = (f"O{m[1]}" for m in re.finditer(r"\bo([1-9])\b", re.sub(_table("numbered")["of_all"], r"o\g<n>", plain)))
    return next((cid for cid in ids if cid not in structure), "")


def nobody(plain: str, structure: Structure) -> str:
    """A label in a text that nobody has who is there ("unit 3"); empty where there is none."""
    spans = (s for s in scan.names(plain) if "label" in s.data)
    return next((plain[s.start : s.end] for s in spans if refer(plain[s.start : s.end], structure) is None), "")

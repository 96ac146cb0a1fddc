"""Who is pointed at by a number ("NPC 2", "car 2") or by a look that the text of the scene tells ("the red one")."""

import re
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.structure.components import Structure


def _table(section: str) -> Any:
    return language.table("turns")[section]


def missing(plain: str, structure: Structure) -> str:
    """The number of somebody, by the sheet or the program, whom there is not; empty where all are there."""
    ids = (f"O{m[1]}" for m in re.finditer(r"\bo([1-9])\b", re.sub(_table("numbered")["of_all"], r"o\g<n>", plain)))
    return next((cid for cid in ids if cid not in structure), "")

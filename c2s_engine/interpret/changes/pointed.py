"""Who is pointed at by a number ("NPC 2", "car 2") or by a look that the text of the scene tells ("the red one")."""

import re
from collections.abc import Sequence
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.meant import by_labels
from c2s_engine.interpret.changes.refer import refer, spec_of
from c2s_engine.interpret.reading import scan
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit


def _table(section: str) -> Any:
    return language.table("turns")[section]


def missing(plain: str, structure: Structure) -> str:
    """The number of somebody, by the sheet or the program, whom there is not; empty where all are there."""
    plain = by_labels(plain, structure)
    ids = (f"O{m[1]}" for m in re.finditer(r"\bo([1-9])\b", re.sub(_table("numbered")["of_all"], r"o\g<n>", plain)))
    return next((cid for cid in ids if cid not in structure), "")


def stranger(demand: str, edits: Sequence[Edit], structure: Structure) -> str:
    """Who a demand is about, as it calls him, where nobody there is meant and yet the edits would change others whom
    it does not name; empty where there is no such one."""
    changed = {str(getattr(e, "component", "")) for e in edits}
    if not changed or any(isinstance(e, AddObject) for e in edits) or changed & {"G", "R", "T"}:
        return ""
    spans = [s for s in scan.names(demand) if s.kind in ("actor", "ego", "label")]
    subject = _SUBJECT.match(demand[: spans[0].start]) if spans and spans[0].kind == "actor" else None
    if subject is None or refer(demand[: spans[0].end], structure, alone=False) is not None:
        return ""
    if spans[0].data.get("type") == "vehicle" or spans[0].data.get("noun") == "traffic":
        return ""
    meant = [refer(f"the {demand[s.start : s.end]}", structure, alone=False) for s in spans[1:]]
    named = {c.id for c in meant if c is not None} | {m[0].upper() for m in re.finditer(r"\bo[1-9]\b", demand)}
    return "" if changed & named else f"{subject['how'] or ''}{demand[spans[0].start : spans[0].end]}"


_SUBJECT = re.compile(
    r"(?:(?:please|now|let|make|have|move|put|set|slow|speed up) )*(?:(?:the|that|this) (?P<how>(?:[\w-]+ ){0,2}))?$"
)


def absent(who: str, structure: Structure) -> str:
    """That somebody is not there, and who is."""
    there = [f"{c.id} ({spec_of(c).name})" for c in structure.objects]
    return f"there is no {who}; there {'is' if len(there) == 1 else 'are'} {', '.join(there) or 'no others than ego'}"


def nobody(plain: str, structure: Structure) -> str:
    """A label in a text that nobody has who is there ("unit 3"); empty where there is none."""
    spans = (s for s in scan.names(plain) if "label" in s.data)
    return next((plain[s.start : s.end] for s in spans if refer(plain[s.start : s.end], structure) is None), "")

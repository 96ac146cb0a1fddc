"""One of those who are told of together: "one of the parked cars is a van", "only one of them crosses".

He is counted out of his row and gets what the demand asks for; the others stay as they are.
"""

import re
from functools import cache
from typing import Any

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.forms import Found, name_of
from c2s_engine.interpret.changes.refer import spec_of
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, Edit, SetField, SetSpec, apply


def member(clause: str, structure: Structure) -> Found | None:
    """ "The last of the parked cars pulls out", "make one of them a child"."""
    language.table("refine")
    said = _said().search(clause)
    group = None if said else None
    if said is None or group is None:
        return None
    from c2s_engine.interpret.changes.refine import edits_of

    cid = structure.next_object_id()
    left = SetField(component=group.id, path="count", value=spec_of(group).count - 1)
    alone = spec_of(group).model_copy(update={"count": 1, "spacing": None})
    apart = apply(apply(structure, left), AddObject(spec=alone, component=cid))
    wanted, words = edits_of(f"{clause[: said.start()]}{cid.lower()}{clause[said.end() :]}", apart)
    if not words:
        return None
    after = apart
    for edit in wanted:
        after = apply(after, edit)
    if cid not in after:
        return [left], f"{name_of(group)}: {left.value}"
    edits: list[Edit] = [left, AddObject(spec=_named(after[cid], structure), component=cid)]
    edits += [SetSpec(component=c.id, spec=c.spec) for c in after.components if c.id != cid and c != apart[c.id]]
    return edits, f"{name_of(group)}: {left.value}; {'; '.join(words)}"


def _named(component: Component, structure: Structure) -> Any:
    """The spec of one who was counted out, with a name that nobody has."""
    spec = spec_of(component)
    taken = {spec_of(c).name for c in structure.objects}
    name = f"{spec.type}_{component.id[1:]}" if spec.type in taken else spec.type
    return spec.model_copy(update={"name": name})


@cache
def _said() -> re.Pattern[str]:
    return re.compile(_table()["said"])


def _table() -> dict[str, str]:
    found: dict[str, str] = language.table("wordings")["members"]
    return found

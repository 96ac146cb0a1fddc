"""What edits do, in the words of an answer."""

from typing import Any

from c2s_engine.interpret.changes.forms import name_of
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit, SetField

PARTS = {"R": "the place", "G": "the scene"}


def in_words(edits: list[Edit], structure: Structure) -> str:
    """What is added and what each field becomes."""
    said = []
    for edit in edits:
        if isinstance(edit, AddObject):
            said.append(f"{edit.component} added")
        elif isinstance(edit, SetField):
            who = PARTS.get(edit.component) or name_of(structure[edit.component])
            said.append(f"{who}: {_value(str(edit.path), edit.value)}")
    return "; ".join(said)


def _value(path: str, value: Any) -> str:
    field = path.split(".")[-1].replace("_", " ")
    if field == "phases":
        return ", then ".join(p.action.replace("_", " ") for p in value) or "keeps on"
    if field == "speed" and isinstance(value, float | int):
        return f"{value * 3.6:.0f} km/h"
    return f"{field} {str(value).replace('_', ' ')}"

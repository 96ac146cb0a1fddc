"""What edits do, in the words of an answer."""

from typing import Any

from pydantic import BaseModel

from c2s_engine.interpret.changes.forms import name_of
from c2s_engine.structure import quantity
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import AddObject, Edit, SetField
from c2s_engine.structure.quantity import ends

PARTS = {"R": "the place", "G": "the scene", "T": "T"}


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
    if value is None:
        return f"{field} left open"
    if ends(value) is not None:
        return f"{field} {quantity.in_words(path, value)}"
    return f"{field} {', '.join(map(_plain, value)) if isinstance(value, tuple | list) else _plain(value)}"


def _plain(value: Any) -> str:
    """A word of the vocabulary, a yes or no, or a part with its fields, as it is read."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    fields = value.model_dump(exclude_none=True) if isinstance(value, BaseModel) else value
    if isinstance(fields, dict):
        return " ".join(_plain(v) for v in fields.values() if v is not None)
    return str(fields).replace("_", " ")

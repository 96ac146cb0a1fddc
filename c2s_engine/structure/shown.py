"""The values of fields as numbers and in words."""

from typing import Any

from c2s_engine.structure.quantity import Quantity, in_words
from c2s_engine.structure.specs import Phase, Spec


def amount(value: Any) -> Quantity | None:
    """A value where it is a number or a range of numbers."""
    parts = value if isinstance(value, tuple) and len(value) == 2 else (value,)
    return value if all(isinstance(p, float | int) and not isinstance(p, bool) for p in parts) else None


def value_in_words(path: str, value: Any) -> str:
    """A field's value in the user's units."""
    if isinstance(value, tuple):
        if all(isinstance(v, Phase) for v in value):
            return ", ".join(v.action for v in value) or "no phase"
        return in_words(path, value) if amount(value) is not None else ", ".join(value_in_words(path, v) for v in value)
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "nothing"}[value]
    if isinstance(value, float | int):
        return in_words(path, value)
    if isinstance(value, Spec):
        held = ((k, getattr(value, k)) for k in type(value).model_fields)
        return ", ".join(f"{k} {value_in_words(k, v)}" for k, v in held if v)
    return str(value).replace("_", " ")

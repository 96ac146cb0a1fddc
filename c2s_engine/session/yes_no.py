"""Yes and no to questions about S itself: what kind of place, weather, road user there is."""

import re

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.values import Field, fields

_ASKS = re.compile(r"(?:and |but |so )?(?:is|are|was|were|has|have)\b", re.I)
_OF_A_MOMENT = re.compile(
    r"\b(?:when|while|as (?:it|he|she|ego|the|o\d)|before|after|until|at the (?:time|moment))\b", re.I
)
"""What asks of a moment of the run, of which S says nothing."""
_SAY_NOTHING = ("yes", "no", "none", "other", "left", "right", "both", "any")
_TYPE = "type"


def yes_or_no(question: str, structure: Structure) -> str:
    """The answer where a question names a value that a field of G, R or an object's type can have; else empty."""
    if not _ASKS.match(question.strip()) or _OF_A_MOMENT.search(question):
        return ""
    found = [(c, f, value) for c in structure.components for f in _asked_fields(c) for value in f.choices
             if value not in _SAY_NOTHING and _named(value, question, anew=f.path == _TYPE)]  # fmt: skip
    own = [(c, f, v) for c, f, v in found if _is(f, v)]
    others = [c for c in found if c not in own]
    named = {c.id for c in structure.components if isinstance(c.spec, ObjectSpec) and _named(c.spec.name, question)}
    types = [(c, f, v) for c, f, v in others if f.path == _TYPE and c.id in named]
    if types:  # "is the van a truck?"
        component, field, value = types[0]
        return f"No: {component.id} ({component.spec.name}) is a {_plain(field.value)}."  # type: ignore[union-attr]
    if own:
        component, field, value = own[0]
        return f"Yes: {component.id} says {field.label} {_plain(value)}{_assumed(component, field)}."
    if places := [(c, f, v) for c, f, v in others if f.path != _TYPE]:
        component, field, value = places[0]
        says = f"says {field.label} {_plain(field.value)}" if field.value else f"leaves {field.label} open"
        return f"No: {component.id} {says}{_assumed(component, field)}."
    if others:
        there = ", ".join(f"{c.id} a {_plain(c.spec.type)}" for c in structure.objects)  # type: ignore[union-attr]
        return f"No: {there or 'there are no objects besides ego'}."
    return ""


def _asked_fields(component: Component) -> list[Field]:
    if component.kind in "GR":
        return [f for f in fields(component.spec) if f.choices]
    return [f for f in fields(component.spec) if f.path == _TYPE and component.kind == "O"]


def _is(field: Field, value: str) -> bool:
    return value in field.value if isinstance(field.value, list | tuple) else value == field.value


def _named(value: str, question: str, anew: bool = False) -> bool:
    """Whether a question has a value's words, whatever their ending ("fog", "foggy"); `anew`: not of one who is known
    ("can it see the bus?" does not ask what is a bus)."""
    words = r"[ -]".join(map(re.escape, value.split("_")))
    known = r"(?<!\bthe )" if anew else ""
    return re.search(rf"{known}\b{words}(?:s|es|y|gy|ny|ing)?\b", question, re.I) is not None


def _plain(value: object) -> str:
    shown = value if isinstance(value, list | tuple) else [value]
    return " and ".join(str(v).replace("_", " ") for v in shown)


def _assumed(component: Component, field: Field) -> str:
    return next((f" (assumed: {a.reason})" for a in component.assumed if a.field == field.path), "")

"""Edits between two S: those by which one becomes the other, those that take somebody away, and all in words."""

from collections.abc import Iterator, Sequence
from typing import Any

from pydantic import BaseModel

from c2s_engine.structure import quantity
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import AddObject, Edit, MoveObject, RemoveObject, SetField, SetSpec, apply
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.sentences import phase_words
from c2s_engine.structure.specs import AnySpec, EgoSpec, ObjectSpec, Phase, SettingsSpec, Trigger

TOWARDS = ("follow", "overtake", "collide", "yield")
"""Actions that are none without their target."""


def after(structure: Structure, edits: Sequence[Edit]) -> Structure:
    """S after the edits; raises EditError."""
    for edit in edits:
        structure = apply(structure, edit)
    return structure


def differences(now: Structure, wanted: Structure) -> list[Edit]:
    """The edits after which S is the wanted one."""
    edits: list[Edit] = []
    for c in wanted.components:
        if c.id in now and now[c.id].spec != c.spec:
            edits.append(SetSpec(component=c.id, spec=c.spec, description=c.description, assumed=c.assumed))
        elif c.id not in now:
            assert isinstance(c.spec, ObjectSpec)
            edits.append(AddObject(component=c.id, spec=c.spec, description=c.description))
    added = [e for e in edits if isinstance(e, AddObject)]
    gone: list[Edit] = [RemoveObject(component=c.id) for c in now.objects if c.id not in wanted]
    edits = [*added, *(e for e in edits if e not in added), *gone]
    ids = [c.id for c in wanted.objects]
    moved = [cid for cid in ids if any(e.component == cid for e in added)]
    return [*edits, *(MoveObject(component=cid, index=ids.index(cid)) for cid in moved)]


def _name(component: Component) -> str:
    spec = component.spec
    return f"{component.id} ({spec.name.replace('_', ' ')})" if isinstance(spec, ObjectSpec) else "ego"


def removal_edits(components: Sequence[Component], structure: Structure) -> list[Edit]:
    """Edits after which these are there no longer, and nobody refers to them; what T requires of them stays, so that
    it is not lost without a word: then they cannot be removed."""
    edits: list[Edit] = []
    for component in components:
        those = [*_released(component.id, structure), RemoveObject(component=component.id)]
        for edit in those:
            structure = apply(structure, edit)
        edits += those
    return edits


def _released(gone: ComponentId, structure: Structure) -> Iterator[Edit]:
    """Edits after which no other refers to a component that goes; who was placed by it is placed by ego."""
    for other in structure.components:
        if other.id != gone and (update := _update(other.spec, gone)):
            spec = other.spec.model_copy(update=update)
            if spec != other.spec:
                yield SetSpec(component=other.id, spec=spec)


def _update(spec: AnySpec, gone: ComponentId) -> dict[str, Any]:
    match spec:
        case SettingsSpec():
            return {"light_changes": tuple(c for c in spec.light_changes if not _about(c.when, gone))}
        case EgoSpec():
            own = {"react_to": None} if spec.react_to == gone else {}
            return {"phases": _phases(spec.phases, gone), **own}
        case ObjectSpec():
            place = spec.placement
            names: dict[str, Any] = {"of": "ego" if place.of == gone else place.of}
            names |= {"hidden_by": None} if place.hidden_by == gone else {}
            return {"phases": _phases(spec.phases, gone), "placement": place.model_copy(update=names)}
    return {}


def _phases(phases: Sequence[Phase], gone: ComponentId) -> tuple[Phase, ...]:
    kept = (p for p in phases if not (p.target == gone and p.action in TOWARDS))
    return tuple(
        p.model_copy(update={
            "target": None if p.target == gone else p.target,
            "trigger": None if _about(p.trigger, gone) else p.trigger,
            "until": None if _about(p.until, gone) else p.until,
        })
        for p in kept
    )  # fmt: skip


def _about(trigger: Trigger | None, gone: ComponentId) -> bool:
    return trigger is not None and gone in (trigger.of, trigger.subject)


PARTS = {"R": "the place", "G": "the scene", "T": "T"}


def worded(edits: list[Edit], structure: Structure) -> str:
    """What is added and what each field becomes."""
    said = []
    for edit in edits:
        if isinstance(edit, AddObject):
            said.append(f"{edit.component} added")
        elif isinstance(edit, SetField):
            who = PARTS.get(edit.component) or _name(structure[edit.component])
            phases = edit.value if edit.path == "phases" else ()
            words = ", then ".join(phase_words(p, structure) for p in phases)
            said.append(f"{who}: {words or _value(str(edit.path), edit.value)}")
    return "; ".join(said)


def _value(path: str, value: Any) -> str:
    field = path.split(".")[-1].replace("_", " ")
    if field == "phases":
        return "keeps on"
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

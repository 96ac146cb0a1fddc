"""Who is there no longer: the edits that take somebody away, so that nobody refers to him."""

from collections.abc import Iterator, Sequence
from typing import Any

from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import Edit, RemoveObject, SetSpec, apply
from c2s_engine.structure.specs import AnySpec, EgoSpec, ObjectSpec, Phase, SettingsSpec, Trigger

TOWARDS = ("follow", "overtake", "collide", "yield")
"""Actions that are none without their target."""


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

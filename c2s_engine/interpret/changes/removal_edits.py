"""Who is there no longer: the edits that take somebody away, so that nobody refers to him."""

from collections.abc import Sequence
from typing import Any

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, RemoveObject, SetSpec, apply
from c2s_engine.structure.specs import EgoSpec, ObjectSpec


def removal_edits(components: Sequence[Component], structure: Structure) -> list[Edit]:
    """Edits after which these are there no longer, and nobody refers to them."""
    edits: list[Edit] = []
    for component in components:
        those = [*release(structure[component.id], structure), RemoveObject(component=component.id)]
        for edit in those:
            structure = apply(structure, edit)
        edits += those
    return edits


def release(component: Component, structure: Structure) -> list[Edit]:
    """Edits that make the others refer to ego instead of a component that goes."""
    edits: list[Edit] = []
    for other in structure.components:
        if other.id == component.id or not isinstance(other.spec, ObjectSpec | EgoSpec):
            continue
        spec = other.spec
        phases = tuple(
            p.model_copy(
                update={
                    "target": None if p.target == component.id else p.target,
                    "trigger": None if p.trigger and p.trigger.of == component.id else p.trigger,
                }
            )
            for p in spec.phases
            if not (p.target == component.id and p.action in ("follow", "overtake", "collide", "yield"))
        )
        update: dict[str, Any] = {"phases": phases}
        if not isinstance(spec, EgoSpec):
            place = spec.placement
            update["placement"] = place.model_copy(
                update={
                    "of": "ego" if place.of == component.id else place.of,
                    "hidden_by": None if place.hidden_by == component.id else place.hidden_by,
                }
            )
        changed = spec.model_copy(update=update)
        if changed != spec:
            edits.append(SetSpec(component=other.id, spec=changed))
    return edits

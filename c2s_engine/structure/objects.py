"""The objects of an S: their specs, their names in the program, the order in which they can be written."""

import keyword

from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase

IN_CIRCLE = "objects are placed by one another in a circle: what hides this one is left out"


def object_spec(component: Component) -> ObjectSpec:
    """The spec of an object's component."""
    assert isinstance(component.spec, ObjectSpec)
    return component.spec


def types(structure: Structure) -> frozenset[str]:
    """What ego and the objects are."""
    ego = structure.ego.spec
    return object_types(structure) | ({ego.type} if isinstance(ego, EgoSpec) else set())


def object_types(structure: Structure) -> frozenset[str]:
    """What the objects are."""
    return frozenset(c.spec.type for c in structure.objects if isinstance(c.spec, ObjectSpec))


def is_ahead(spec: EgoSpec | ObjectSpec, other: str | None) -> bool:
    """Whether an object is placed ahead of another, in its lane or the next."""
    at = spec.placement if isinstance(spec, ObjectSpec) else None
    return at is not None and at.of == (other or EGO) and "ahead" in (at.position, at.along) and at.facing != "against"


SLOWS = ("brake", "stop")


def slows_for(cid: str, spec: EgoSpec | ObjectSpec, phase: Phase, other: EgoSpec | ObjectSpec | None) -> bool:
    """Whether an object brakes, or stops, in a phase for its target (`other`): not where that waits for it, or is
    behind it."""
    if phase.action not in SLOWS or phase.target in (None, cid) or other is None or is_ahead(spec, phase.target):
        return False
    return not any(p.trigger is not None and p.trigger.of == cid for p in other.phases)


def distinct_names(structure: Structure) -> Structure:
    """The objects' names in the program made distinct: a model may call two of them `car`."""
    taken = {"ego"}
    for component in structure.objects:
        name, number = object_spec(component).name, 2
        while name in taken or keyword.iskeyword(name):
            name, number = f"{object_spec(component).name}{number}", number + 1
        taken.add(name)
        if name != object_spec(component).name:
            spec = object_spec(component).model_copy(update={"name": name})
            structure = structure.with_component(component.model_copy(update={"spec": spec}))
    return structure


def in_order(structure: Structure) -> Structure:
    """The objects so that each follows those that place or hide it; where no order does, hiding gives way."""
    left = list(structure.objects)
    done: list[Component] = []
    while left:
        placed = {"ego", *(o.id for o in done)}
        free = next((o for o in left if _rests_on(o) <= placed | {o.id}), None)
        if free is None:
            free = next((o for o in left if object_spec(o).placement.of in placed), left[0])
            hidden = Unmet(text=free.description, reason=IN_CIRCLE)
            update = (
                {"hidden_by": None} if object_spec(free).placement.of in placed else {"hidden_by": None, "of": "ego"}
            )
            spec = object_spec(free).model_copy(
                update={"placement": object_spec(free).placement.model_copy(update=update)}
            )
            left[left.index(free)] = free = free.model_copy(update={"spec": spec, "unmet": (*free.unmet, hidden)})
        left.remove(free)
        done.append(free)
    return structure.model_copy(update={"objects": tuple(done)})


def _rests_on(component: Component) -> set[str]:
    placement = object_spec(component).placement
    return {placement.of, *([placement.hidden_by] if placement.hidden_by else [])}

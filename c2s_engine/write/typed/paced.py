"""Speeds that S says in words become numbers: ranges of data/paces.yaml, from which each sample draws."""

from typing import TypeVar

from c2s_engine.require.paces import paces_of, speed_at
from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.contradictions import ResolveError

Paced = TypeVar("Paced", bound=EgoSpec | ObjectSpec | Phase)


def paced(structure: Structure) -> Structure:
    """S with a speed for each pace without one; raises ResolveError where a road user has no such pace."""
    for component in (structure.ego, *structure.objects):
        spec, place = component.spec, structure.place.spec
        assert isinstance(spec, EgoSpec | ObjectSpec) and isinstance(place, PlaceSpec)
        phases = tuple(_with_speed(p, f"{component.id}.phases.{i}", spec, place) for i, p in enumerate(spec.phases))
        found: EgoSpec | ObjectSpec = _with_speed(spec, component.id, spec, place)
        if found is not spec or phases != spec.phases:
            structure = structure.with_spec(component.id, found.model_copy(update={"phases": phases}))
    return structure


def _with_speed(said: Paced, path: str, spec: EgoSpec | ObjectSpec, place: PlaceSpec) -> Paced:
    if said.pace is None or said.speed is not None:
        return said
    if (speed := speed_at(spec.type, said.pace, place)) is None:
        kind, known = spec.type.replace("_", " "), ", ".join(paces_of(spec.type)) or "none"
        why = f"{path}.pace: a {kind} has no pace {said.pace.replace('_', ' ')!r}; it has {known.replace('_', ' ')}"
        raise ResolveError(f"{why}. Choose one of these, or give a speed", (f"{path}.pace", f"{path}.speed"))
    return said.model_copy(update={"speed": speed})

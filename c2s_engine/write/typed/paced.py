"""Speeds that S says in words become numbers: ranges of data/paces.yaml, from which each sample draws."""

from c2s_engine.require.paces import paces_of, speed_at
from c2s_engine.structure.components import Structure
from c2s_engine.structure.quantity import Range
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.contradictions import ResolveError


def paced(structure: Structure) -> Structure:
    """S with a speed for each pace without one; raises ResolveError where a road user has no such pace."""
    for component in (structure.ego, *structure.objects):
        spec, place = component.spec, structure.place.spec
        assert isinstance(spec, EgoSpec | ObjectSpec) and isinstance(place, PlaceSpec)
        phases = tuple(
            p.model_copy(update=_speed(p, f"{component.id}.phases.{i}", spec, place))
            for i, p in enumerate(spec.phases)
        )  # fmt: skip
        told = _speed(spec, component.id, spec, place)
        if told or phases != spec.phases:
            structure = structure.with_spec(component.id, spec.model_copy(update={**told, "phases": phases}))
    return structure


def _speed(
    said: EgoSpec | ObjectSpec | Phase, path: str, spec: EgoSpec | ObjectSpec, place: PlaceSpec
) -> dict[str, Range]:
    """What a pace changes in what says it."""
    if said.pace is None or said.speed is not None:
        return {}
    if (speed := speed_at(spec.type, said.pace, place)) is None:
        kind, known = spec.type.replace("_", " "), ", ".join(paces_of(spec.type)) or "none"
        why = f"{path}.pace: a {kind} has no pace {said.pace.replace('_', ' ')!r}; it has {known.replace('_', ' ')}"
        raise ResolveError(f"{why}. Choose one of these, or give a speed", (f"{path}.pace", f"{path}.speed"))
    return {"speed": speed}

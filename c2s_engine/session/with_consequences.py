"""What an edit of one field of S leaves another saying that cannot hold any more: it follows, and that is said."""

from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import Quantity, in_words
from c2s_engine.structure.sentences import says_its_spec, with_own_sentence
from c2s_engine.structure.specs import AnySpec, EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.structure.vocabulary import TOWARDS_EGO

WITH_A_MIDDLE = 3
"""The fewest lanes of which one is the middle."""


def with_consequences(before: Structure, after: Structure) -> tuple[Structure, list[str]]:
    """S after edits, with what follows from them; what that is, in sentences."""
    said: list[str] = []
    for component in after.objects:
        was, spec = before[component.id].spec if component.id in before else None, component.spec
        if not isinstance(was, ObjectSpec) or not isinstance(spec, ObjectSpec) or was.phases != spec.phases:
            continue
        if spec.speed != was.speed and spec.speed is not None and (slower := _as_fast(was, spec)) is not None:
            after = _with(after, component, slower)
            said.append(f"{component.id} ({spec.name}): its first phase takes the new speed, too (was {_words(was)}).")
            continue
        old, new = (TOWARDS_EGO.get(s.placement.position) for s in (was, spec))
        phases = tuple(p.model_copy(update={"side": new}) if p.action == "cut_in" and p.side == old else p
                       for p in spec.phases)  # fmt: skip
        if old and new and phases != spec.phases:
            after = _with(after, component, spec.model_copy(update={"phases": phases}))
            said.append(f"{component.id} ({spec.name}) cuts in to the {new} from there.")
    own, ego = before.ego.spec, after.ego.spec
    assert isinstance(own, EgoSpec) and isinstance(ego, EgoSpec)
    gives_up = own.reaction == "yield" and ego.reaction == "none" and own.phases == ego.phases
    if gives_up and (kept := _without_yielding(ego)) != ego.phases:
        after = _with(after, after.ego, ego.model_copy(update={"phases": kept}))
        said.append("Ego no longer gives way: its yield phase was removed.")
    was, place = before.place.spec, after.place.spec
    assert isinstance(was, PlaceSpec) and isinstance(place, PlaceSpec)
    too_few = place.lanes is not None and place.lanes < WITH_A_MIDDLE and place.lanes != was.lanes
    if too_few and place.ego_lane == was.ego_lane == "middle":
        after = _with(after, after.place, place.model_copy(update={"ego_lane": None}))
        said.append(f"R: {place.lanes} lanes have no middle one, so ego's lane is now left open.")
    return after, said


def _without_yielding(ego: EgoSpec) -> tuple[Phase, ...]:
    """Ego's phases without giving way, and without setting out once the other has passed."""
    kept: list[Phase] = []
    for i, phase in enumerate(ego.phases):
        after_it = i > 0 and ego.phases[i - 1].action == "yield" and phase.action == "start"
        if phase.action != "yield" and not after_it:
            kept.append(phase)
    return tuple(kept)


def _own_speed(spec: ObjectSpec) -> Quantity | None:
    """The speed of the first thing that somebody does, where that is the only one that S gives."""
    first = spec.phases[0] if spec.phases else None
    alone = first is not None and first.speed is not None and all(p.speed is None for p in spec.phases[1:])
    return first.speed if alone and first is not None and spec.speed in (None, first.speed) else None


def _as_fast(was: ObjectSpec, spec: ObjectSpec) -> ObjectSpec | None:
    """The spec whose first phase goes as fast as is said of the whole now; None where that said something else."""
    if _own_speed(was) is None:
        return None
    first = spec.phases[0].model_copy(update={"speed": None})
    return spec.model_copy(update={"phases": (first, *spec.phases[1:])})


def _words(spec: ObjectSpec) -> str:
    speed = _own_speed(spec)
    return "" if speed is None else in_words("speed", speed)


def _with(structure: Structure, component: Component, spec: AnySpec) -> Structure:
    """The structure with another spec of a component, and its sentence of that where it was the spec's."""
    follows = says_its_spec(component, structure)
    changed = component.model_copy(update={"spec": spec})
    structure = structure.with_component(changed)
    return structure.with_component(with_own_sentence(changed, structure)) if follows else structure

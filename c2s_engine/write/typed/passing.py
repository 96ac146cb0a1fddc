"""One form for overtaking: by the side where there is a lane, with the way back in it."""

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec
from c2s_engine.write.typed.lanes import lane_offset, leaves_lane


def passing(structure: Structure, place: PlaceSpec) -> Structure:
    """S with the side of each overtaking in ego's lane, without the change of lane by which it comes back anyhow."""
    objects = {c.id: c.spec for c in structure.objects if isinstance(c.spec, ObjectSpec)}
    for component in (structure.ego, *structure.objects):
        spec = component.spec
        if not isinstance(spec, EgoSpec | ObjectSpec) or all(p.action != "overtake" for p in spec.phases):
            continue
        own = lane_offset(component.id, objects) if component.id in objects else 0
        phases: list[Phase] = []
        for phase in spec.phases:
            if phase.action == "overtake" and own == 0 == _lane_of(phase.target, objects):
                phases.append(phase if leaves_lane(objects.get(phase.target or "")) else _sided(phase, place))
            elif not (phases and own == _lane_of(phases[-1].target, objects) and _comes_back(phases[-1], phase)):
                phases.append(phase)
        if tuple(phases) != spec.phases:
            spec = spec.model_copy(update={"phases": tuple(phases)})
            structure = structure.with_component(component.model_copy(update={"spec": spec}))
    return structure


def _lane_of(cid: str | None, objects: dict[str, ObjectSpec]) -> int | None:
    """How many lanes to the left of ego's one starts who is overtaken."""
    return lane_offset(cid, objects) if cid in objects else 0


def _sided(phase: Phase, place: PlaceSpec) -> Phase:
    """An overtaking on the right where ego's lane is the leftmost of several."""
    by_oncoming = place.lanes is None and place.oncoming is True
    if phase.side is not None or place.ego_lane != "leftmost" or place.lanes == 1 or by_oncoming:
        return phase
    return phase.model_copy(update={"side": "right"})


def _comes_back(before: Phase, phase: Phase) -> bool:
    """Whether a phase is no more than the end of the overtaking before it."""
    if before.action != "overtake" or phase.action != "lane_change" or phase.trigger is not None:
        return False
    return (phase.side or "left") == ("left" if before.side == "right" else "right")

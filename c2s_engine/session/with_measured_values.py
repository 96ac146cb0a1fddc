"""S with what its run shows of numbers that S and the writer leave open, so that changes count from what is there."""

from c2s_engine.require.scene import shown_by
from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

BRAKES = ("brake", "brake_hard")
"""The events with which a stop begins."""


def with_measured_values(structure: Structure, facts: RunFacts | None) -> Structure:
    """The structure whose actors have what is measured of them among what is assumed, where it is open: their gap and
    speed, and when they begin what no trigger of theirs begins."""
    if facts is None:
        return structure
    first: dict[str, ObjectFacts] = {}
    for found in facts.objects:
        cid = "E" if found.name == EGO else found.component
        if cid:
            first.setdefault(cid, found)
    for component in (structure.ego, *structure.objects):
        if component.id in first:
            measured = _measured(component, first)
            open_ = tuple(a for a in measured if component.amount(a.field) is None)
            marked = component.model_copy(update={"assumed": (*component.assumed, *open_)})
            structure = structure.with_component(marked)
    return structure


def _measured(component: Component, first: dict[str, ObjectFacts]) -> list[Assumption]:
    """What the run shows of a component: how far it starts from whom it is placed by, the speed that it holds, and
    when it does what it does once."""
    found, spec = first[component.id], component.spec
    amounts = {"speed": found.held_speed}
    phases = spec.phases if isinstance(spec, EgoSpec | ObjectSpec) else ()
    for i, phase in enumerate(phases):
        shows = BRAKES if phase.action in ("brake", "stop") else shown_by(phase.action)
        begun = [e.time for e in found.events if e.event in shows]
        if phase.trigger is None and begun and [p.action for p in phases].count(phase.action) == 1:
            amounts[f"phases.{i}.trigger"] = min(begun)
    if isinstance(spec, ObjectSpec):
        other = first.get("E" if spec.placement.of == EGO else spec.placement.of)
        start = found.starts.get(other.name) if other is not None else None
        amounts["placement.gap"] = round(start.gap, 1) if start is not None else None
    return [
        Assumption(field=field, value=f"{amount:g}", reason="measured in the run", amount=amount)
        for field, amount in amounts.items()
        if amount is not None
    ]

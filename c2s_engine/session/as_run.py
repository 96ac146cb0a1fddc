"""S with what its run shows of numbers that S and the writer leave open, so that changes count from what is there."""

from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts
from c2s_engine.structure.specs import ObjectSpec


def as_run(structure: Structure, facts: RunFacts | None) -> Structure:
    """The structure whose actors have their measured gap and speed among what is assumed, where these are open."""
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
    """What the run shows of a component: how far it starts from whom it is placed by, and the speed that it holds."""
    found, spec = first[component.id], component.spec
    amounts = {"speed": found.held_speed}
    if isinstance(spec, ObjectSpec):
        other = first.get("E" if spec.placement.of == EGO else spec.placement.of)
        start = found.starts.get(other.name) if other is not None else None
        amounts["placement.gap"] = round(start.gap, 1) if start is not None else None
    return [
        Assumption(field=field, value=f"{amount:g}", reason="measured in the run", amount=amount)
        for field, amount in amounts.items()
        if amount is not None
    ]

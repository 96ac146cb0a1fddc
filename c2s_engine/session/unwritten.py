"""What a turn says of S that its program does not: edits whose writing failed, and code by hand that they pass by."""

from c2s_engine.session.steps import Emit
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.progress import ComponentState, Say


def left(before: Structure, after: Structure, emit: Emit) -> Structure:
    """S after a turn that ended before it was written: what it changed is marked as out of date, and that is said."""
    stale = [c for c in after.components if c.code and _ours(c) and _changed(before, c)]
    for component in stale:
        marked = component.model_copy(update={"key": ""})
        after = after.with_component(marked)
        emit(ComponentState(component=marked, state="dirty"))
    gone = [c.id for c in before.components if c.code and c.id not in after]
    new = [c.id for c in after.components if not c.code and c.id not in before]
    if before.ego.code and (stale or gone or new):
        which = ", ".join([*(c.id for c in stale), *new, *gone])
        text = f"S was changed, but its program not updated yet ({which}). The next turn tries again; undo reverts it."
        emit(Say(text=text, severity="warning"))
    return after


def conflicts(before: Structure, after: Structure, emit: Emit) -> None:
    """Say where code by hand stands against what would be written now."""
    new = [c.id for c in after.components
           if c.conflict and (c.id not in before or before[c.id].conflict != c.conflict)]  # fmt: skip
    if new:
        text = f"{', '.join(new)}: your code is kept; what would be written now is shown beside it as a conflict."
        emit(Say(text=text, severity="warning"))


def _ours(component: Component) -> bool:
    return component.origin in ("rendered", "generated")


def _changed(before: Structure, component: Component) -> bool:
    if component.id not in before or not component.key:
        return True
    was = before[component.id]
    return (was.spec, was.description) != (component.spec, component.description)

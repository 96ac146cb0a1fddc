"""A component's sentence in other words: what the change of words says goes into that component's fields.

The old and the new sentence are read amid the same other sentences; fields in which the readings differ are set, and
nothing else, so that what was edited by hand since, or cannot be said in a sentence, stays.
"""

from collections.abc import Sequence
from typing import Any, TypeGuard

from c2s_engine.session.reader import Unreadable, read, route
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import Edit, EditError, SetDescription, SetField, SetSpec, apply


async def reworded(structure: Structure, edits: Sequence[Edit], tools: Any) -> tuple[list[Edit], list[str]]:
    """The edits, each new sentence followed by the edits of fields that it means; and a sentence on each.

    A sentence that comes with edits of its component's fields only says what they do."""
    found: list[Edit] = []
    replies = []
    told = {e.component for e in edits if isinstance(e, SetSpec) or isinstance(e, SetField) and not _rewords(e)}
    for edit in edits:
        after = apply(structure, edit)
        found.append(edit)
        if not _rewords(edit) or edit.component in told:
            structure = after
            continue
        if structure[edit.component].description != after[edit.component].description:
            meant, reply = await _meant(structure, after, edit.component, tools)
            found += meant
            replies.append(reply)
            for one in meant:
                after = apply(after, one)
        structure = after
    return found, replies


def _rewords(edit: Edit) -> TypeGuard[SetDescription | SetField]:
    return isinstance(edit, SetDescription) or isinstance(edit, SetField) and edit.path == "description"


async def _meant(before: Structure, after: Structure, cid: str, tools: Any) -> tuple[list[Edit], str]:
    try:
        was, becomes = await _readings(before, after, cid, tools)
    except Unreadable as error:
        return [], f"{cid}: the sentence is kept, the fields are unchanged: {error}"
    if becomes is None:
        return [], f"{cid}: the sentence is kept, the fields are unchanged: it was not understood as one of {cid}."
    old = was.spec.model_dump(mode="json") if was is not None else {}
    new, assumed = becomes.spec.model_dump(mode="json"), {a.field.split(".")[0] for a in becomes.assumed}
    changes: list[Edit] = []
    refused = []
    for path, value in new.items():
        if value == old.get(path) or path in ("component", "name") or (was is None and path in assumed):
            continue
        edit = SetField(component=cid, path=path, value=value)
        try:
            after = apply(after, edit)
        except EditError as error:
            refused.append(str(error))
            continue
        changes.append(edit)
    if not changes and not refused:  # what a scene does not say may still be understood as a change
        asked = await route(after[cid].description, before, tools)
        changes = [e for e in asked.edits if isinstance(e, SetField | SetSpec) and e.component == cid]
    told = [str(c.path) if isinstance(c, SetField) else "all" for c in changes]
    reply = f"{cid}: the sentence was read; {', '.join(told).replace('_', ' ')} changed." if told else (
        f"{cid}: the sentence was read; it says nothing that changes its fields.")  # fmt: skip
    return changes, " ".join([reply, *(f"{r}." for r in refused)])


async def _readings(
    before: Structure, after: Structure, cid: str, tools: Any
) -> tuple[Component | None, Component | None]:
    """The component as the old and the new sentence say it."""
    for sentences in (_all, _alone):
        try:
            found = [await read(sentences(s, cid), tools) for s in (before, after)]
        except Unreadable:
            if sentences is _alone:
                raise
            continue
        if sentences is _alone or all(len(f.objects) == len(before.objects) for f in found):
            break
    here = before.ids.index(cid) if sentences is _all else None
    return tuple(_component(f, cid, here) for f in found)  # type: ignore[return-value]


def _component(found: Structure, cid: str, here: int | None) -> Component | None:
    if not cid.startswith("O"):
        return found[cid]
    if here is not None:
        return found.components[here]
    return found.objects[0] if found.objects else None


def _all(structure: Structure, cid: str) -> str:
    """Every component's sentence, in S's order."""
    return " ".join(_closed(c) for c in structure.components if c.description)


def _alone(structure: Structure, cid: str) -> str:
    """The component's sentence after ego's, without which a text tells of no scene."""
    component = structure[cid]
    return _closed(component) if cid == "E" else f"{_closed(structure.ego)} {_closed(component)}"


def _closed(component: Component) -> str:
    text = component.description.strip() or "Ego drives."
    return text if text[-1] in ".!?" else f"{text}."

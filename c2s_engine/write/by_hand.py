"""Code by hand (or imported): what it was written upon, and what a writer would put in its place once that changed.

A fragment by hand bears a mark in place of a key: digests of its code, of its fields, of its sentence, and of the names
of others that it uses. A mark of other code is of no worth: that fragment was written by hand since.
"""

import contextlib

from c2s_engine.structure import edits, names
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import Edit
from c2s_engine.structure.regenerate import FragmentWriter, digest, interface
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.write.merged import alike
from c2s_engine.write.typed import scope

OWN = ("by_hand", "imported")
TAKEN = "taken"
"""The key of an offer that was taken, until the writer that it comes from gives it its own; others write it anew."""
GIVEN_BACK = "given back"
"""The key of code by hand that was given up without an offer: it is to be written, by whatever method."""
_SIGN = "hand"


def apply(structure: Structure, edit: Edit) -> Structure:
    """The structure after an edit, with marks; where code by hand is given up for its offer, the offer itself is taken:
    a model asked again might write something else. Raises EditError."""
    after = edits.apply(structure, edit)
    if isinstance(edit, edits.SetCode) and edit.code is None:
        offer = structure[edit.component].conflict
        update = {"code": offer, "origin": "generated", "key": TAKEN} if offer else {"key": GIVEN_BACK}
        after = after.with_component(after[edit.component].model_copy(update=update))
    return with_marks(after)


def used(structure: Structure, cid: ComponentId) -> dict[str, str]:
    """The names of other components that a component's code uses, with their kinds."""
    component = structure[cid]
    own, found = names.defines(component.code), names.uses(component.code)
    others = [interface(c) for c in structure.components if c.id != cid]
    return {n: kind for defined in others for n, kind in defined.items() if n in found and n not in own}


def with_marks(structure: Structure) -> Structure:
    """The structure in which all code by hand that bears no mark of its own bears one of what stands now."""
    for component in _own(structure):
        if not _marked(component):
            structure = _with_mark(structure, component.id)
    return structure


def outdated(structure: Structure, words: bool) -> list[ComponentId]:
    """The components by hand whose fields are no longer what they were written upon; with `words`, for writers that go
    by sentences and names, also those whose sentence is not, or the names of others that they use."""
    compared = slice(2, 5) if words else slice(2, 3)
    marks = {c.id: (c.key, _mark(structure, c.id)) for c in _own(structure) if _marked(c)}
    return [cid for cid, (was, now) in marks.items() if was.split(":")[compared] != now.split(":")[compared]]


def with_offer(structure: Structure, cid: ComponentId, code: str) -> Structure:
    """The structure in which that code is offered in the place of a component's own, if it is any other."""
    component = structure[cid]
    offer = code if code.strip() and code.strip() != component.code.strip() else None
    return _with_mark(structure.with_component(component.model_copy(update={"conflict": offer})), cid)


def with_offers(structure: Structure, writer: FragmentWriter) -> Structure:
    """The structure with what the writer renders from the fields offered wherever they changed under code by hand."""
    structure = with_marks(structure)
    for cid in outdated(structure, words=False):
        with contextlib.suppress(ValueError):  # fields that cannot be rendered offer nothing
            structure = with_offer(structure, cid, writer.write(structure, cid).code)
    return structure


def followed(structure: Structure, before: Structure, cid: ComponentId, whole: bool) -> Structure:
    """The structure in which a component's code, changed with its fields, is marked: as in step with the `whole` of
    them, else as written upon the fields of before."""
    if whole:
        update = {"conflict": None, "by_hand": ""}
        return _with_mark(structure.with_component(structure[cid].model_copy(update=update)), cid)
    was = before[cid].key.split(":") if _marked(before[cid]) else _mark(before, cid).split(":")
    key = ":".join([*was[:1], digest(structure[cid].code), *was[2:]])
    return structure.with_component(structure[cid].model_copy(update={"key": key}))


def with_names(structure: Structure, before: Structure) -> Structure:
    """The structure in which an object that became one of another type has the name of before, where code by hand uses
    its variable."""
    own = frozenset[str]().union(*(names.uses(c.code) | names.defines(c.code).keys() for c in _own(before)))
    variables = scope.variables(before)
    for component in [c for c in structure.objects if c.id in before]:
        was, spec = before[component.id].spec, component.spec
        if not (isinstance(was, ObjectSpec) and isinstance(spec, ObjectSpec)) or was.type == spec.type:
            continue
        if was.name != spec.name and variables[component.id] in own:
            kept = spec.model_copy(update={"name": was.name})
            structure = structure.with_component(component.model_copy(update={"spec": kept}))
    return structure


def compared(structure: Structure, writer: FragmentWriter) -> Structure:
    """The structure that knows which code by hand is what the writer writes for its fields, but for comments."""
    for component in _own(structure):
        if component.by_hand != "apart":
            with contextlib.suppress(ValueError):
                same = alike(component.code, writer.write(structure, component.id).code)
                component = component.model_copy(update={"by_hand": "same" if same else ""})
                structure = structure.with_component(component)
    return structure


def carried(structure: Structure, before: Structure) -> Structure:
    """A text read anew, with the code by hand of before in it: what was read is what it is said to be now."""
    if any(c.code for c in _own(before)):
        structure = structure.model_copy(update={"arrangement": before.arrangement})
    for own in (c for c in _own(before) if c.code):
        if own.id not in structure:
            structure = structure.model_copy(update={"objects": (*structure.objects, own)})
            continue
        read = structure[own.id]
        kept = {name: getattr(own, name) for name in ("code", "origin", "key", "conflict", "by_hand")}
        if not read.description:
            kept |= {"description": own.description, "spec": own.spec}
        structure = structure.with_component(read.model_copy(update=kept))
    return structure


def in_step(structure: Structure, cid: ComponentId) -> bool:
    """Whether code by hand says what its component's fields say, as far as is known."""
    return structure[cid].conflict is None and cid not in outdated(structure, words=False)


def _own(structure: Structure) -> list[Component]:
    return [c for c in structure.components if c.origin in OWN]


def _mark(structure: Structure, cid: ComponentId) -> str:
    component = structure[cid]
    parts = (component.code, component.spec.model_dump(mode="json"), component.description, used(structure, cid))
    return ":".join([_SIGN, *map(digest, parts)])


def _marked(component: Component) -> bool:
    return component.key.split(":")[:2] == [_SIGN, digest(component.code)]


def _with_mark(structure: Structure, cid: ComponentId) -> Structure:
    return structure.with_component(structure[cid].model_copy(update={"key": _mark(structure, cid)}))

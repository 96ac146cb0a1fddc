"""What an edit makes dirty, and writing only that (DESIGN, "What is regenerated").

A component's key is the digest of its own description and spec, of the interfaces of the components that it reads,
and of the writer's configuration. Pure: the writer is a plain function.
"""

import hashlib
import json
from collections.abc import Callable, Iterable
from typing import Any, Protocol

from c2s_engine.structure import names
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import Edit, apply


class FragmentWriter(Protocol):
    """Writes one component's fragment.

    `reads`: the components whose interfaces it looks at for that. `inputs`: what else of S it looks at, as plain data
    (for the typed writer the facts of the plan that the fragment rests on), and no more than that.
    """

    def config(self) -> dict[str, Any]: ...

    def inputs(self, structure: Structure, cid: ComponentId) -> Any: ...

    def reads(self, structure: Structure, cid: ComponentId) -> frozenset[ComponentId]: ...

    def write(self, structure: Structure, cid: ComponentId) -> Component: ...


def interface(component: Component) -> dict[str, str]:
    """The names that others may use, with their kinds."""
    return names.defines(component.code)


def digest(value: Any) -> str:
    return hashlib.sha256(json.dumps(value, sort_keys=True, default=str).encode()).hexdigest()[:16]


def key_of(structure: Structure, cid: ComponentId, writer: FragmentWriter) -> str:
    """The digest under which a component's fragment is up to date."""
    component, config = structure[cid], writer.config()
    read = {other: interface(structure[other]) for other in sorted(writer.reads(structure, cid)) if other in structure}
    described = [component.description] if config.get("reads_descriptions") else []
    return digest([described, component.spec.model_dump(mode="json"), read, writer.inputs(structure, cid), config])


def order(structure: Structure, cids: Iterable[ComponentId], writer: FragmentWriter) -> list[ComponentId]:
    """The order of writing: Algorithm 1's, but what is read comes before what reads it. Cycles keep S's order."""
    wanted, done = [c for c in structure.ids if c in set(cids)], []

    def visit(cid: ComponentId, path: tuple[ComponentId, ...]) -> None:
        if cid in done or cid in path:
            return
        for other in sorted(writer.reads(structure, cid), key=structure.ids.index):
            if other in wanted:
                visit(other, (*path, cid))
        done.append(cid)

    for cid in wanted:
        visit(cid, ())
    return done


def dirty(structure: Structure, writer: FragmentWriter) -> list[ComponentId]:
    """The components whose fragments are not up to date, by their keys. Code by hand or imported has no key of ours."""
    return [c.id for c in structure.components
            if c.origin in ("rendered", "generated") and c.key != key_of(structure, c.id, writer)]  # fmt: skip


def reach(structure: Structure, edit: Edit, writer: FragmentWriter) -> list[ComponentId]:
    """What an edit may make the writer write anew, before it is made: the closure over the read-relation."""
    after = apply(structure, edit)
    touched = set(dirty(after, writer))
    grew = True
    while grew:
        grew = False
        for component in after.components:
            if component.id not in touched and touched & writer.reads(after, component.id):
                touched.add(component.id)
                grew = True
    return [cid for cid in after.ids if cid in touched]


def regenerate(
    structure: Structure,
    edits: Iterable[Edit],
    writer: FragmentWriter,
    on_written: Callable[[Component], None] = lambda component: None,
) -> tuple[Structure, list[ComponentId]]:
    """The structure after the edits, with what is dirty written anew, and the ids of what was rewritten.

    Early cutoff: a component whose inputs' interfaces did not change keeps its key and is not visited. A fragment by
    hand is kept; what would be written instead is offered as its `conflict` where its spec changed.
    """
    before = structure
    for edit in edits:
        structure = apply(structure, edit)
    written: list[ComponentId] = []
    for _ in range(len(structure.ids) + 1):
        todo = order(structure, dirty(structure, writer), writer)
        if not todo:
            break
        for cid in todo:
            key = key_of(structure, cid, writer)
            if structure[cid].key == key:
                continue
            component = writer.write(structure, cid).model_copy(update={"key": key})
            structure = structure.with_component(component)
            if cid not in written:
                written.append(cid)
            on_written(component)
    return _conflicts(before, structure, writer), written


def _conflicts(before: Structure, after: Structure, writer: FragmentWriter) -> Structure:
    for component in after.components:
        if component.origin not in ("by_hand", "imported") or component.id not in before:
            continue
        if before[component.id].spec != component.spec:
            offered = writer.write(after, component.id).code
            if offered.strip() != component.code.strip():
                after = after.with_component(component.model_copy(update={"conflict": offered}))
    return after


def code_references(structure: Structure, cid: ComponentId) -> frozenset[ComponentId]:
    """The components whose top-level names a component's code uses (for code not rendered from specs)."""
    used = names.uses(structure[cid].code) - names.defines(structure[cid].code).keys()
    return frozenset(c.id for c in structure.components if c.id != cid and used & interface(c).keys())

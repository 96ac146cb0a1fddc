"""Edits of fields followed by code by hand: a literal is changed where the program, read again, then says the new value
and nothing else anew. Where no literal does, the code stays for the writer's offer."""

import contextlib
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.check.protocol import CheckRequest
from c2s_engine.session.steps import Emit
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.program import assemble
from c2s_engine.structure.progress import ComponentState, ProgramChanged, Progress, Say
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.sentences import says_its_spec, sentence, with_sentence
from c2s_engine.structure.specs import SettingsSpec
from c2s_engine.write import by_hand
from c2s_engine.write.in_place import (
    SKY,
    Change,
    Swap,
    at,
    candidates,
    changes,
    data,
    ground,
    halves,
    looks,
    put,
    same,
    sky,
    swapped,
    together,
    told,
)  # fmt: skip
from c2s_engine.write.merged import merged
from c2s_engine.write.renamed import in_code
from c2s_engine.write.typed.writer import MapChoice, TypedWriter

READINGS = 40
"""The most times that a program is read for one turn (some 80 ms each)."""
GAP = ("placement", "gap")


async def followed(
    before: Structure, after: Structure, writer: TypedWriter, check: CheckClient, emit: Emit
) -> tuple[Structure, list[ComponentId]]:
    """The structure after edits, with code by hand changed where it can follow them; whose code that is. What is in
    conflict already stays as it is until that is settled."""
    before, after, called = in_code(before, after)
    for cid, own_names in called.items():
        pairs = ", ".join(f"{old} -> {new}" for old, new in own_names.items())
        emit(Say(text=f"{cid}: your code goes by the new names ({pairs})."))
        emit(ComponentState(component=after[cid], state="by_hand"))
    own = [c for c in after.components if c.origin in by_hand.OWN and c.id in before]
    asked = [c.id for c in own if _edited(before[c.id], c) and before[c.id].conflict is None]
    merged_into = dict.fromkeys(called)
    for cid in [cid for cid in asked if before[cid].origin == "by_hand"]:
        if (ours := _merged(before, after, cid, writer)) is not None:
            emit(Say(text=f"{cid}: the change was merged into your code."))
            emit(ComponentState(component=ours, state="by_hand"))
            after = by_hand.followed(after.with_component(ours), before, cid, by_hand.in_step(before, cid))
            before = before.with_component(after[cid])
            merged_into[cid] = None
    asked = [cid for cid in asked if _edited(before[cid], after[cid])]
    if not asked:
        return after, list(merged_into)
    reader = _Reader(check)
    try:
        read = await reader.read(after)
    except CheckError:
        return after, list(merged_into)  # what cannot be read at all is not changed
    work = _Work(before, after, read, reader)
    for cid in asked:
        if cid == "G":
            await work.settings(writer.map)
        else:
            await work.component(cid)
    after, changed = work.marked(emit)
    return after, list(merged_into | dict.fromkeys(changed))


def _merged(before: Structure, after: Structure, cid: ComponentId, writer: TypedWriter) -> Component | None:
    """A component with what its writer would write otherwise now put into its code; None where it would not, or where
    the code was changed just there."""
    ours = with_sentence(before, after, cid)
    with contextlib.suppress(ValueError):
        base, other = writer.write(before, cid), writer.write(after.with_component(ours), cid)
        if base.code != other.code and (code := merged(base.code, ours.code, other.code)) is not None:
            return ours.model_copy(update={"code": code})
    return None


def marking_rewritten(changed: Sequence[ComponentId], emit: Emit) -> Emit:
    """Events of the writing, in which that code counts as rewritten too."""

    def on_event(event: Progress) -> None:
        if changed and isinstance(event, ProgramChanged):
            event = event.model_copy(update={"rewritten": tuple(dict.fromkeys([*event.rewritten, *changed]))})
        emit(event)

    return on_event


def _edited(was: Component, component: Component) -> bool:
    return was.code == component.code and was.spec != component.spec


class _Reader:
    """Reads programs, so many at most."""

    def __init__(self, check: CheckClient):
        self.check, self.left = check, READINGS
        self.lacking: set[str] | None = None  # errors that the program had before

    async def read(self, structure: Structure) -> Structure:
        """What the program of a structure says; raises CheckError."""
        if self.left <= 0:
            raise CheckError("enough was tried")
        self.left -= 1
        program = assemble(structure).text
        found = (await self.check.import_program(program)).structure
        assert found is not None
        report = await self.check.check(CheckRequest(program=program, upto="parse"))
        lacking = {d.message for stage in report.stages for d in stage.diagnostics if d.severity == "error"}
        if self.lacking is None:
            self.lacking = lacking
        if lacking - self.lacking:
            raise CheckError("the change names what the program's world model does not have")
        return found


class _Work:
    """One turn: `structure` with its code as it becomes, and `read`, what its program says when it is read."""

    def __init__(self, before: Structure, after: Structure, read: Structure, reader: _Reader):
        self.before, self.first, self.reader = before, read, reader
        self.structure, self.read = after, read
        self.whole: dict[ComponentId, bool] = {}
        self.notes: list[tuple[ComponentId, str]] = []

    async def component(self, cid: ComponentId) -> None:
        """Change one component's code group by group of its fields."""
        there = counterpart(self.structure[cid], self.read)
        if there is None or there not in self.read:
            return
        found = changes(data(self.before[cid]), data(self.structure[cid]))
        kept = self.structure, self.read, list(self.notes), dict(self.whole)
        done = [await self._group(cid, there, group) for group in together(found)]
        same_now = any(done) and same(data(self.read[there]), data(self.structure[cid]))
        if not all(done) and not same_now:  # half a change is none: the code stays, and the conflict shows the whole
            self.structure, self.read, self.notes, self.whole = kept
        self.whole[cid] = all(done) and by_hand.in_step(self.before, cid) or same_now

    async def settings(self, chosen: MapChoice) -> None:
        """G's statements take the values that the typed writer would give them; nothing else may change."""
        spec = self.structure.settings.spec
        assert isinstance(spec, SettingsSpec)
        named = {str(c.path[0]) for c in changes(data(self.before.settings), data(self.structure.settings))}
        if named & SKY and "preset" not in named:
            spec = spec.model_copy(update={"preset": None})  # the newer word counts
        done = not named - SKY - {"map"} and by_hand.in_step(self.before, "G")
        if named & SKY:
            if await self._swapped("G", sky(self.structure, spec), _only_sky):
                self.structure = self.structure.with_component(
                    self.structure.settings.model_copy(update={"spec": spec})
                )
            else:
                done = False
        if "map" in named:
            done &= await self._swapped("G", ground(self.structure, chosen), _only_map)
        self.whole["G"] = done

    async def _swapped(self, cid: ComponentId, swaps: list[Swap] | None, allowed: Any) -> bool:
        """Make these changes at once, if the program then says what is allowed."""
        if not swaps:
            return swaps is not None
        trial, notes = self.structure, []
        for swap in swaps:
            notes.append((cid, told(trial, swap)))
            trial = swapped(trial, swap)
        try:
            read = await self.reader.read(trial)
        except CheckError:
            return False
        if not allowed(self.read, read):
            return False
        self.structure, self.read = trial, read
        self.notes += reversed(notes)
        return True

    async def _group(self, cid: ComponentId, there: ComponentId, group: list[Change]) -> bool:
        """Change the code for all of these fields, or for none."""
        kept = self.structure, self.read, list(self.notes)
        kind = any(c.name == "type" for c in group)
        for change in group:
            if change.name == "name" and kind:
                continue  # the variable keeps its name
            loose = kind or cid == "T" and change.path[0] == "require"
            parts = halves(change)
            if not await self._change(cid, there, change, loose) and not (
                parts and all([await self._change(cid, there, part, loose) for part in parts])
            ):
                self.structure, self.read, self.notes = kept
                return False
        if kind:
            await self._swapped(cid, looks(self.structure, cid), partial(_of_type, there))
        return True

    async def _change(self, cid: ComponentId, there: ComponentId, change: Change, loose: bool) -> bool:
        """Try the candidates one by one."""
        now = data(self.read[there])
        change = replace(change, old=at(now, change.path))
        if same(change.old, change.new):
            return True
        wanted = put(now, change.path, change.new)
        for swap in candidates(self.structure, cid, change):
            trial = swapped(self.structure, swap)
            try:
                read = await self.reader.read(trial)
            except CheckError:
                if self.reader.left <= 0:
                    return False
                continue
            if _says(read, there, wanted, self.read, loose):
                self.notes.append((cid, told(self.structure, swap)))
                self.structure, self.read = trial, read
                self.whole.setdefault(swap.component, True)
                return True
        return False

    def marked(self, emit: Emit) -> tuple[Structure, list[ComponentId]]:
        """What came of it: gaps measured anew, sentences, marks; and say what was changed in the code."""
        before, structure = self.before, self.structure
        if not self.notes and not any(self.whole.values()):
            return structure, []
        for cid, text in self.notes:
            emit(Say(text=f"{cid}, changed in the code: {text}."))
        changed = []
        for cid in [c.id for c in structure.components if c.id in before and c.origin in by_hand.OWN]:
            seen = self._as_read(structure, cid)
            measured = seen[cid].spec != structure[cid].spec
            if measured:
                emit(Say(text=f"With that, the gap of {cid} is {_gap(seen[cid])} m."))
            structure = seen
            rewritten = structure[cid].code != before[cid].code
            if rewritten or measured or self.whole.get(cid):
                whole = self.whole.get(cid, by_hand.in_step(before, cid))
                structure = by_hand.followed(structure, before, cid, whole)
            if rewritten:
                changed.append(cid)
                emit(ComponentState(component=structure[cid], state="by_hand"))
        return structure, changed

    def _as_read(self, structure: Structure, cid: ComponentId) -> Structure:
        """A component with what the changed program says of it besides the edit: its gap, where the types of objects
        decide on that, and its sentences, where they are the reader's."""
        there = counterpart(self.before[cid], self.first)
        if there is None or there not in self.first or there not in self.read:
            return structure
        component, was, now = structure[cid], self.first[there], self.read[there]
        update: dict[str, Any] = {}
        fields, old, new = data(component), at(data(was), GAP), at(data(now), GAP)
        if new is not None and not same(old, new) and same(at(fields, GAP), old):
            spec = SPEC_ADAPTER.validate_python(put(fields, GAP, new))
            update = {"spec": spec, "description": _told_anew(structure, component, spec)}
        if component.description == self.before[cid].description == was.description:
            update["description"] = now.description
        if component.unmet == was.unmet:
            update["unmet"] = now.unmet
        return structure.with_component(component.model_copy(update=update)) if update else structure


def _told_anew(structure: Structure, component: Component, spec: Any) -> str:
    """The sentence of an object whose spec is another; one that was not made from the spec stays."""
    if not says_its_spec(component, structure):
        return component.description
    return sentence(component.model_copy(update={"spec": spec}), structure)


def counterpart(component: Component, read: Structure) -> ComponentId | None:
    """The component of a program as it was read that is this one: objects may be numbered otherwise there."""
    if component.kind != "O":
        return component.id
    alike = [o.id for o in read.objects if o.code.strip() == component.code.strip()]
    alike = alike or [o.id for o in read.objects if getattr(o.spec, "name", "") == getattr(component.spec, "name", "")]
    return alike[0] if len(alike) == 1 else None


def _says(read: Structure, there: ComponentId, wanted: Any, was: Structure, loose: bool) -> bool:
    """Whether a program says what is wanted of one component, and of the others what it said.

    `loose`: gaps may be others: they are measured from side to side, which another kind of object changes, and where
    nothing else tells them, they are the distance that is required."""
    if read.ids != was.ids:
        return False
    for cid in was.ids:
        told, meant = data(read[cid]), wanted if cid == there else data(was[cid])
        if loose:
            told, meant = ({k: v for k, v in d.items() if k != "name" or cid != there} for d in (told, meant))
            told, meant = (put(d, GAP, None) if "placement" in d else d for d in (told, meant))
        if not same(told, meant):
            return False
    return True


def _of_type(there: ComponentId, was: Structure, now: Structure) -> bool:
    """Whether a component is of the type that it was, and the others are as they were."""
    same_type = now.ids == was.ids and data(now[there])["type"] == data(was[there])["type"]
    return same_type and all(now[c].spec == was[c].spec for c in now.ids if c != there)


def _only_sky(was: Structure, now: Structure) -> bool:
    return _rest(was) == _rest(now) and was.settings.spec.map == now.settings.spec.map  # type: ignore[union-attr]


def _only_map(was: Structure, now: Structure) -> bool:
    spec = now.settings.spec
    return _rest(was) == _rest(now) and spec.preset == was.settings.spec.preset  # type: ignore[union-attr]


def _rest(structure: Structure) -> list[Any]:
    return [(c.id, c.spec) for c in structure.components if c.id != "G"]


def _gap(component: Component) -> str:
    low, high = ends(at(data(component), GAP)) or (0.0, 0.0)
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"

"""Which fields of a component, with other values, make the writer write what somebody changed in its code."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.edits import SPEC_ADAPTER
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.regenerate import FragmentWriter
from c2s_engine.write.in_place import data, put
from c2s_engine.write.merged import TOKEN, Upon, constants

MOST = 3
"""Numbers that may be changed at once."""
_UNITS = (1.0, 3.6, 1 / 3.6)


def as_field(structure: Structure, cid: ComponentId, writer: "Upon | _Constants") -> Structure | None:
    """The structure (whose component has the new code) with the fields for which the writer writes that code; None
    where it is not by numbers alone that the code differs from the writer's `own`, or where no fields give it."""
    wanted = structure[cid].code.strip()
    differing = _numbers(writer.own.strip(), wanted)
    if not differing or len(differing) > MOST:
        return None
    left = len(differing)
    while left:
        nearer = _nearer(structure, cid, differing, wanted, left, writer)
        if nearer is None:
            return None
        structure, left = nearer
    return structure


def as_constant(structure: Structure, cid: ComponentId, writer: FragmentWriter, base: str) -> Structure | None:
    """The structure with the fields for which the writer defines the constants of its own, `base`, by the numbers that
    they have in the component's code now; what else it would then write otherwise does not count. None where no fields
    give them, or where none was changed."""
    known = constants(base)
    own = {name: value for name, value in constants(structure[cid].code).items() if name in known}
    found = _Constants(writer, frozenset(own), _defined({name: known[name] for name in own}))
    trial = structure.with_component(structure[cid].model_copy(update={"code": _defined(own)}))
    fields = as_field(trial, cid, found)
    if fields is None:
        return None
    return fields.with_component(fields[cid].model_copy(update={"code": structure[cid].code}))


@dataclass(frozen=True)
class _Constants:
    """What a writer writes of some constants; `own`, which it wrote before."""

    writer: FragmentWriter
    names: frozenset[str]
    own: str

    def write(self, structure: Structure, cid: ComponentId) -> Component:
        written = self.writer.write(structure, cid)
        found = {name: value for name, value in constants(written.code).items() if name in self.names}
        return written.model_copy(update={"code": _defined(found)})


def _defined(found: dict[str, str]) -> str:
    return "\n".join(f"{name} = {found[name]}" for name in sorted(found))


def _nearer(
    structure: Structure, cid: ComponentId, differing: list[tuple[str, str]], wanted: str, left: int,
    writer: Upon | _Constants,
) -> tuple[Structure, int] | None:  # fmt: skip
    """The structure with one more field changed, after which fewer numbers differ, and how many."""
    fields, tried = data(structure[cid]), set()
    for path, value in (*_leaves(fields), *_chosen(structure[cid])):
        for was, now in differing:
            for new in _meant(value, float(was), float(now)):
                if (path, str(new)) in tried:
                    continue
                tried.add((path, str(new)))
                try:
                    spec = SPEC_ADAPTER.validate_python(put(fields, path, new))
                    trial = structure.with_component(structure[cid].model_copy(update={"spec": spec}))
                    found = writer.write(trial, cid).code.strip()
                except (ValidationError, ValueError):
                    continue
                others = _numbers(found, wanted)
                if others is not None and len(others) < left:
                    return trial, len(others)
    return None


def _numbers(old: str, new: str) -> list[tuple[str, str]] | None:
    """The numbers that differ; None where anything else does, too."""
    one, other = TOKEN.findall(old), TOKEN.findall(new)
    pairs = [(a, b) for a, b in zip(one, other, strict=False) if a != b]
    plain = len(one) == len(other) and all(a[0].isdigit() and b[0].isdigit() for a, b in pairs)
    return [(a, b) for a, b in pairs if float(a) != float(b)] if plain else None


def _leaves(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[tuple[str | int, ...], Any]]:
    """The numbers and ranges of a spec as plain data, with their paths."""
    if ends(value) is not None:
        yield path, value
    elif isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _leaves(inner, (*path, key))


def _chosen(component: Component) -> Iterator[tuple[tuple[str | int, ...], Any]]:
    """The numbers that the writer chose where the spec says none, as if it said them."""
    for note in component.assumed:
        if note.amount is not None:
            yield tuple(int(p) if p.isdigit() else p for p in note.field.split(".")), note.amount


def _meant(value: Any, was: float, now: float) -> Iterator[Any]:
    """What a field may become where a number in the code became another: it, in another unit, or one end of a range."""
    low, high = ends(value) or (0.0, 0.0)
    for unit in _UNITS:
        to = now / unit
        if abs(low * unit - was) < 0.06 and low == high:
            yield to
        elif abs(low * unit - was) < 0.06 and to <= high:
            yield [to, high]
        elif abs(high * unit - was) < 0.06 and to >= low:
            yield [low, to]
    if low == high:
        yield low + now - was
        if was:
            yield low * now / was

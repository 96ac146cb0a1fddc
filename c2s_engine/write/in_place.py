"""Edits of fields that code by hand can follow: which of its literals might say a field, and the code with another.

What a literal says is not decided here: a candidate is taken only where the program, read again, says the new value
and nothing else anew (session/in_place.py).
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import PurePath
from typing import Any

from c2s_engine.check.describe import table
from c2s_engine.maps.expressions import MANOEUVRE_TYPE
from c2s_engine.structure import names
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.specs import ObjectSpec, SettingsSpec
from c2s_engine.write.by_hand import OWN
from c2s_engine.write.literals import Site, blueprints, numbers, params, statements, words
from c2s_engine.write.typed.settings import weather_value
from c2s_engine.write.typed.tables import BLUEPRINTS
from c2s_engine.write.typed.writer import MapChoice

NEAR = 0.011  # m, m/s: what rounding to two decimals leaves
SKY = frozenset({"weather", "time", "preset", "parameters"})
"""Fields of G that are one statement of the program."""
KIND = frozenset({"type", "model", "name"})
"""Fields of an object that change together."""
_UNITS = (3.6, 2.2369, 3.2808, 1 / 3.6, 1 / 2.2369)
"""How many of a program's units a unit of S is: km/h, mph, feet, and speeds given as if they were those."""
_WORDS: Mapping[str, Mapping[Any, tuple[str, ...]]] = {
    "placement.side": {"left": ("left",), "right": ("right",)},
    "placement.position": {"ahead": ("ahead", "of"), "behind": ("behind",), "left_lane": ("left", "of"),
                           "right_lane": ("right", "of")},
    "manoeuvre": {way: (kind,) for way, kind in MANOEUVRE_TYPE.items()},
    "arms": {3: ("is3Way",), 4: ("is4Way",)},
}  # fmt: skip
_SHOWN = 48  # characters


@dataclass(frozen=True)
class Change:
    """One field of a spec, by its path, and its old and new value as plain data."""

    path: tuple[str | int, ...]
    old: Any
    new: Any

    @property
    def name(self) -> str:
        return ".".join(map(str, self.path))


@dataclass(frozen=True)
class Swap:
    """Another text in the place of a literal of a component's code."""

    component: ComponentId
    site: Site
    text: str


def changes(old: Any, new: Any, path: tuple[str | int, ...] = ()) -> list[Change]:
    """What differs between two specs as plain data, down to single values, numbers and ranges."""
    if old == new:
        return []
    if isinstance(old, dict) and isinstance(new, dict) and old.keys() == new.keys():
        return [c for key in old for c in changes(old[key], new[key], (*path, key))]
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new) and ends(old) is None:
        return [c for i, (a, b) in enumerate(zip(old, new, strict=True)) for c in changes(a, b, (*path, i))]
    return [Change(path, old, new)]


def together(found: list[Change]) -> list[list[Change]]:
    """The changes, those that only make sense together in one group; what decides on the others first."""
    kind = [c for c in found if c.name in KIND]
    groups = [[c] for c in found if c not in kind]
    return [sorted(kind, key=lambda c: c.name != "type"), *groups] if kind else groups


def data(component: Component) -> Any:
    return component.spec.model_dump(mode="json")


def at(data: Any, path: tuple[str | int, ...]) -> Any:
    for key in path:
        try:
            data = data[key]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def put(data: Any, path: tuple[str | int, ...], value: Any) -> Any:
    """A copy with another value at a path."""
    if not path:
        return value
    if isinstance(data, dict):
        return {k: put(v, path[1:], value) if k == path[0] else v for k, v in data.items()}
    if isinstance(data, list):
        return [put(v, path[1:], value) if i == path[0] else v for i, v in enumerate(data)]
    return data


def same(a: Any, b: Any) -> bool:
    """Whether two values as plain data are the same up to the rounding of numbers."""
    one, other = ends(a), ends(b)
    if one is not None and other is not None:
        return all(abs(x - y) <= NEAR for x, y in zip(one, other, strict=True))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b, strict=True))
    return bool(a == b)


def halves(change: Change) -> list[Change]:
    """The change of a range as one of each end, so that it is a range in between; of others nothing."""
    old, new = ends(change.old), ends(change.new)
    if old is None or new is None or old[0] == old[1] or new[0] == old[0] or new[1] == old[1]:
        return []
    between = [old[0], new[1]] if new[1] > old[0] else [new[0], old[1]]
    return [replace(change, new=between), replace(change, old=between)]


def candidates(structure: Structure, cid: ComponentId, change: Change) -> Iterator[Swap]:
    """The swaps that might make a component say a field's new value, the likeliest first, then in reading order."""
    if change.old is None:
        return
    if cid == "R" and change.name in _WORDS:  # places are what others rest on
        places = [(cid, (start, start + len(p.text))) for start, p in statements(structure[cid].code)]
    else:
        places = [(cid, own) for own in _own(structure, cid)]
    places += _constants(structure, cid)
    if cid == "R" and change.name == "distance":  # which requirements tell
        places += [("T", own) for own in _own(structure, "T") if structure["T"].origin in OWN]
    code = {c: structure[c].code for c, _ in places}

    def within(found: Callable[[str], list[Site]]) -> Iterator[tuple[ComponentId, Site]]:
        for place, (start, end) in places:
            for site in found(code[place][start:end]):
                yield place, Site(site.start + start, site.end + start, site.text, site.ends, site.call)

    old, new = ends(change.old), ends(change.new)
    if change.name in _WORDS:
        said = _WORDS[change.name]
        if change.old in said and change.new in said:
            yield from _texts(within(partial(words, wanted=said[change.old])), " ".join(said[change.new]))
    elif change.name == "type":
        for was in _classes(change.old):
            for becomes in _classes(change.new)[:1]:
                yield from _texts(within(partial(words, wanted=[was])), becomes)
    elif change.name == "model":
        text = "" if change.new is None else f"'{change.new}'"
        yield from _texts(within(partial(blueprints, whole=not text)), text)
    elif old is not None and new is not None:
        if old[0] != old[1] and (old[0] == new[0]) != (old[1] == new[1]):
            end = 0 if old[1] == new[1] else 1
            yield from _numeric(list(within(numbers)), (old[end], old[end]), (new[end], new[end]))
        yield from _numeric(list(within(numbers)), old, new)


def _texts(found: Iterator[tuple[ComponentId, Site]], text: str) -> Iterator[Swap]:
    return (Swap(component, site, text) for component, site in found)


def swapped(structure: Structure, swap: Swap) -> Structure:
    """The structure with that code."""
    component, site = structure[swap.component], swap.site
    code = component.code[: site.start] + swap.text + component.code[site.end :]
    return structure.with_component(component.model_copy(update={"code": code}))


def told(structure: Structure, swap: Swap) -> str:
    """A swap in words, upon the structure before it: `LEAD_SPEED = 10 -> 12`."""
    code, site = structure[swap.component].code, swap.site
    if not site.text:
        return f"{_short(swap.text)} added"
    if not swap.text:
        return f"{_short(site.text.lstrip(', '))} taken out"
    before = code[code.rfind("\n", 0, site.start) + 1 : site.start].lstrip()
    before = before if len(before) <= _SHOWN else "..." + before[-_SHOWN:]
    closed = re.match(r"[)\]]*", code[site.end :])
    sign = "-" if before.endswith("-") else ""
    return f"{before}{_short(site.text)} -> {sign}{_short(swap.text)}{closed[0] if closed else ''}"


def sky(structure: Structure, spec: SettingsSpec) -> list[Swap] | None:
    """G's `param weather` as the typed writer would write it; where there is none, a line after the map's.

    None where there is no place for it; no swaps where it stands so already."""
    code, value = structure.settings.code, weather_value(spec)
    if found := list(params(code, "weather")):
        return [Swap("G", found[-1], value)] if found[-1].text != value else []
    named = list(params(code, "carla_map")) or list(params(code, "map"))
    after = code.find("\n", named[-1].end) if named else -1
    return [Swap("G", Site(after, after, ""), f"\nparam weather = {value}")] if after >= 0 else None


def looks(structure: Structure, cid: ComponentId) -> list[Swap]:
    """The blueprints of other types that a component's code names: the first of its type in their place."""
    spec, code = structure[cid].spec, structure[cid].code
    own = BLUEPRINTS.get(spec.type, ()) if isinstance(spec, ObjectSpec) else ()
    named = [s for s in reversed(blueprints(code, whole=False)) if s.text[:1] in "'\"" and s.text[1:-1] not in own]
    return [Swap(cid, s, f"'{own[0]}'") for s in named if own]


def ground(structure: Structure, chosen: MapChoice) -> list[Swap] | None:
    """G's `param map` and `param carla_map` as the typed writer would write them; the last first, so that places hold.

    None where the map that was asked for is not the one at hand, or where the program names none."""
    spec, code = structure.settings.spec, structure.settings.code
    assert isinstance(spec, SettingsSpec)
    if spec.map is None or PurePath(spec.map).name.removesuffix(".xodr").lower() != chosen.name.lower():
        return None
    maps = [Swap("G", s, f"localPath('{chosen.path.name}')") for s in params(code, "map")]
    towns = [Swap("G", s, repr(chosen.carla_map)) for s in params(code, "carla_map")]
    found = sorted([*maps, *towns], key=lambda s: -s.site.start)
    return [s for s in found if s.text != s.site.text] if maps else None


def _classes(kind: Any) -> list[str]:
    """Scenic's classes of a type of S; none of those that stand for several things."""
    return [name for name, is_a in table()["types"].items() if is_a == kind and kind != "obstacle"]


def _own(structure: Structure, cid: ComponentId) -> list[tuple[int, int]]:
    """The statements of a component's code on which no other component rests, by first and last character.

    The object itself may be named by others."""
    found = statements(structure[cid].code)
    elsewhere = _used([c for c in structure.components if c.id != cid])
    shared: set[int] = set()
    while True:
        reached = elsewhere.union(*(names.uses(found[i][1].text) for i in shared))
        more = {i for i, (_, p) in enumerate(found) if names.defines(p.text).keys() & reached and not _makes(p.text)}
        if more <= shared:
            break
        shared |= more
    return [(start, start + len(p.text)) for i, (start, p) in enumerate(found) if i not in shared]


def _constants(structure: Structure, cid: ComponentId) -> list[tuple[ComponentId, tuple[int, int]]]:
    """The constants and global parameters of other components by hand that this component alone uses."""
    own, found = structure[cid].code, []
    for component in structure.components:
        if component.id == cid or component.origin not in OWN:
            continue
        pieces = statements(component.code)
        for i, (start, piece) in enumerate(pieces):
            defined = names.defines(piece.text)
            if len(defined) != 1 or not set(defined.values()) <= {"value", "param"} or _makes(piece.text):
                continue
            name = next(iter(defined))
            rest = [p.text for j, (_, p) in enumerate(pieces) if j != i]
            rest += [c.code for c in structure.components if c.id not in (cid, component.id)]
            if _reads(own, name) and not any(_reads(text, name) for text in rest):
                found.append((component.id, (start, start + len(piece.text))))
    return found


def _reads(code: str, name: str) -> bool:
    """Whether code uses a constant, or (`param x`) a global parameter."""
    kind, _, parameter = name.partition(" ")
    if kind == "param":
        return re.search(rf"\bglobalParameters\s*\.\s*{re.escape(parameter)}\b", code) is not None
    return name in names.uses(code)


def _used(components: list[Component]) -> frozenset[str]:
    return frozenset[str]().union(*(names.uses(c.code) for c in components))


def _makes(text: str) -> bool:
    """Whether a statement makes objects or places by itself."""
    return "new" in names.uses(text) and not re.match(r"(behavior|monitor|scenario|class|def)\s", text)


def _numeric(
    found: list[tuple[ComponentId, Site]], old: tuple[float, float], new: tuple[float, float]
) -> Iterator[Swap]:
    """The value itself, in another unit, or with what the reader adds or takes (half a length); then as a factor."""
    seen = set()
    for meant in (_equal, _scaled, _moved, _mirrored, _factor):
        for component, site in found:
            assert site.ends is not None
            single = site.ends[0] == site.ends[1]
            if single != (old[0] == old[1]):
                continue
            becomes = meant(site.ends, old, new)
            if becomes is None or (becomes[0] < 0) != (site.ends[0] < 0):
                continue
            swap = Swap(component, site, site.with_ends(*becomes))
            if swap.text != site.text and swap not in seen:
                seen.add(swap)
                yield swap


Ends = tuple[float, float]


def _equal(here: Ends, old: Ends, new: Ends) -> Ends | None:
    return new if same(here, old) else None


def _scaled(here: Ends, old: Ends, new: Ends) -> Ends | None:
    for unit in _UNITS:
        if old[1] > 0 and all(abs(h - unit * o) <= 0.002 * abs(h) + 1e-9 for h, o in zip(here, old, strict=True)):
            return unit * new[0], unit * new[1]
    return None


def _moved(here: Ends, old: Ends, new: Ends) -> Ends | None:
    return here[0] + new[0] - old[0], here[1] + new[1] - old[1]


def _mirrored(here: Ends, old: Ends, new: Ends) -> Ends | None:
    """Of what is behind: a distance against the direction of travel."""
    return (here[0] + old[1] - new[1], here[1] + old[0] - new[0]) if here[1] < 0 else None


def _factor(here: Ends, old: Ends, new: Ends) -> Ends | None:
    return (here[0] * new[0] / old[0], here[1] * new[1] / old[1]) if old[0] > 0 and old[1] > 0 else None


def _short(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= _SHOWN else line[: _SHOWN - 3].rstrip() + "..."

"""A text that asks for more than maps or specs can give is not refused: a gap by which one starts inside another is
left open, as few of R's fields as it takes are, else lane changes go by the oncoming lane of a road with one each way,
and who is in a lane that no such place has comes into ego's. Where roads then lack the room for the speeds, the fewest
of these are lowered.

Only for what was read from a text; an edit that contradicts the rest is refused, with the fields named.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.maps.library import MapLibrary, MapNotFound
from c2s_engine.maps.opendrive import BrokenMap
from c2s_engine.session.places import (
    ENOUGH,
    Resolution,
    at_hand,
    demanded,
    first_on_map,
    having,
    is_short,
    listed,
    refusal,
    resolve,
)
from c2s_engine.solve.fitting import slower
from c2s_engine.structure.components import Assumption, Structure, Unmet
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import ObjectSpec, Placement

ORDER = (
    "speed_limit", "shoulder", "sidewalk", "distance", "crosswalk", "ego_lane", "lanes", "arms", "curve", "oncoming",
    "control", "manoeuvre", "kind",
)  # fmt: skip
"""Fields of R, from the one that is given up first."""
ROADS = ("straight", "motorway", "crosswalk")
"""Kinds of places for which another road stands in on a map that has none; what is done at a ramp, in a roundabout or
at a junction is done nowhere else."""
BESIDE = ("left_lane", "right_lane", "beside")
"""Positions that need a lane beside ego's."""


async def settle(
    structure: Structure, library: MapLibrary, check: CheckClient, *, given: str | None, default: str | None
) -> tuple[Structure, Resolution]:
    """The structure with as few of R's fields left open as it takes to resolve, and as few speeds lowered as it takes
    to have the room, each named in `assumed`.

    A map that the text names counts as one that is given, as long as it is at hand and has anything near.
    """
    named = demanded(structure, library)
    if given is None and named is not None:
        relaxed, found = await settle(structure, library, check, given=named, default=default)
        if found.writer is not None:
            return relaxed, found
    settled, found = await _settle(structure, library, check, given=given, default=default)
    return await _fitted(settled, found, library, check) if is_short(settled, found) else (settled, found)


async def strictly(
    structure: Structure, library: MapLibrary, check: CheckClient, *, given: str | None, default: str | None
) -> tuple[Structure, Resolution]:
    """The structure as it is, refused where a map that is given lacks the place or the room for its speeds."""
    found = await resolve(structure, library, check, given=given, default=default)
    if given is None or not is_short(structure, found):
        return structure, found
    others = await having(structure, library, check, (n for n in at_hand(library, None) if n != given), room=True)
    there = f"{listed(others)} {'has' if len(others) == 1 else 'have'} the room" if others else "lower them"
    lack = f"{given} has no such road without stop signs that is long and straight enough for the speeds; {there}."
    return structure, Resolution(None, diagnostic=refusal(lack, "no-room", ("R",)))


async def _settle(
    structure: Structure, library: MapLibrary, check: CheckClient, *, given: str | None, default: str | None
) -> tuple[Structure, Resolution]:
    found = await resolve(structure, library, check, given=given, default=default, offers=False)
    if (
        found.writer is not None
        or found.diagnostic is None
        or found.diagnostic.code not in ("contradiction", "no-place")
    ):
        return structure, found
    why = f"{given} has no such place" if given and found.diagnostic.code == "no-place" else found.diagnostic.message
    anywhere = found.diagnostic.code == "contradiction" or given is None
    relaxed = _relaxed(_gap_open(structure, found.diagnostic.text.split(", "), why), why, anywhere)
    nearest = await _nearest(list(relaxed), library, check, given, default)
    if nearest is None:
        return structure, await resolve(structure, library, check, given=given, default=default)
    return nearest, await resolve(nearest, library, check, given=given, default=default, offers=False)


async def _fitted(
    structure: Structure, found: Resolution, library: MapLibrary, check: CheckClient
) -> tuple[Structure, Resolution]:
    """The structure with the fewest of its speeds lowered with which a map's roads have the room; itself if none do."""
    assert found.writer is not None
    name = found.writer.map.name
    variants = slower(structure, name)
    fitting = await first_on_map(variants, library, check, name, ENOUGH + 1)
    if fitting is None:
        return structure, found
    number, there = fitting
    return variants[number], replace(there, assumed=found.assumed)


async def _nearest(
    variants: list[Structure], library: MapLibrary, check: CheckClient, given: str | None, default: str | None
) -> Structure | None:
    """The first of the variants that has a place, on the map that is given, else on any at hand."""
    nearest = None
    for name in (given,) if given else at_hand(library, default):
        try:
            found = await first_on_map(variants, library, check, name)
        except (MapNotFound, BrokenMap, CheckError):
            continue
        if found is not None:
            nearest, variants = variants[found[0]], variants[: found[0]]
    return nearest


def _relaxed(structure: Structure, why: str, anywhere: bool) -> Iterator[Structure]:
    """What may stand for a structure, from the one that gives up least."""
    for changed in (structure, _in_line(structure, why)):
        if changed is None:
            return
        for narrow in (changed, _one_lane(changed, why)):
            yield narrow
            fields = [field for field in ORDER if _set(narrow, field, anywhere)]
            if narrow is not changed:
                fields.remove("lanes")
            subsets = [subset for size in range(1, min(len(fields), 3) + 1) for subset in combinations(fields, size)]
            subsets += [tuple(fields[:n]) for n in range(4, len(fields) + 1)]
            yield from (_without(narrow, subset, why) for subset in subsets)


def _gap_open(structure: Structure, fields: list[str], why: str) -> Structure:
    """The structure with the first gap left open of the fields that contradict each other: it says where somebody
    starts who would be inside another."""
    cid = next((f.partition(".")[0] for f in fields if f.endswith(".placement.gap")), "")
    spec = structure[cid].spec if cid in structure else None
    if not isinstance(spec, ObjectSpec) or spec.placement.gap is None:
        return structure
    component, was = structure[cid], f"{middle(spec.placement.gap):g} m"
    placement = spec.placement.model_copy(update={"gap": None})
    note = _instead("placement.gap", "left open", was, why)
    update = {"spec": spec.model_copy(update={"placement": placement}), "assumed": (*component.assumed, note)}
    return structure.with_component(component.model_copy(update=update))


def _one_lane(structure: Structure, why: str) -> Structure:
    """The structure on a road of one lane each way, where lane changes and overtaking go by the oncoming lane."""
    place = structure.place
    note = _instead("lanes", "1", getattr(place.spec, "lanes", None), why)
    spec = place.spec.model_copy(update={"lanes": 1})
    return structure.with_component(place.model_copy(update={"spec": spec, "assumed": (*place.assumed, note)}))


def _set(structure: Structure, field: str, anywhere: bool) -> bool:
    value = getattr(structure.place.spec, field)
    if field == "kind":
        return value != "road" and (anywhere or value in ROADS)
    return value is not None


def _in_line(structure: Structure, why: str) -> Structure | None:
    """The structure with those in lanes beside ego's in its own, ahead of it or behind; None where there are none."""
    changed = structure
    for component in structure.objects:
        spec = component.spec
        if not isinstance(spec, ObjectSpec) or spec.placement.position not in BESIDE:
            continue
        place = spec.placement
        position = "behind" if place.along == "behind" else "ahead"
        placement = Placement(position=position, gap=place.gap)
        was = _value_text(place.position)
        update = {
            "spec": spec.model_copy(update={"placement": placement}),
            "unmet": (*component.unmet, Unmet(text=f"{spec.name}: {was}", reason=why)),
            "assumed": (*component.assumed, _instead("placement.position", position, was, why)),
        }
        changed = changed.with_component(component.model_copy(update=update))
    return changed if changed is not structure else None


def _without(structure: Structure, fields: tuple[str, ...], why: str) -> Structure:
    """The structure with fields of R left open."""
    place = structure.place
    update = {field: "road" if field == "kind" else None for field in fields}
    notes = tuple(_instead(field, "left open", getattr(place.spec, field), why) for field in fields)
    spec = place.spec.model_copy(update=update)
    return structure.with_component(place.model_copy(update={"spec": spec, "assumed": (*place.assumed, *notes)}))


def _instead(field: str, value: str, was: object, why: str) -> Assumption:
    said = "" if was is None else _value_text(was)
    return Assumption(field=field, value=value, reason=f"originally {said or 'left open'}: {why}", was=said)


def _value_text(value: object) -> str:
    return str(value).lower().replace("_", " ") if isinstance(value, str | bool) else str(value)

"""A text that asks for more than maps or specs can give is not refused: R's least important field is left open, else
who is in a lane that no such place has comes into ego's.

Only for what was read from a text; an edit that contradicts the rest is refused, with the fields named.
"""

from c2s_engine.check.client import CheckClient
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import Resolution, resolve
from c2s_engine.structure.components import Assumption, Structure, Unmet
from c2s_engine.structure.specs import ObjectSpec, Placement

ORDER = (
    "speed_limit", "shoulder", "sidewalk", "distance", "crosswalk", "ego_lane", "lanes", "arms", "curve", "oncoming",
    "control", "manoeuvre", "kind",
)  # fmt: skip
"""Fields of R, from the one that is given up first."""

BESIDE = ("left_lane", "right_lane", "beside")
"""Positions that need a lane beside ego's."""


async def settle(
    structure: Structure, library: MapLibrary, check: CheckClient, *, given: str | None, default: str | None
) -> tuple[Structure, Resolution]:
    """The structure with as few of R's fields left open as it takes to resolve, each named in R's `assumed`."""
    found = await resolve(structure, library, check, given=given, default=default)
    if (
        found.writer is not None
        or found.diagnostic is None
        or found.diagnostic.code not in ("contradiction", "no-place")
    ):
        return structure, found
    why = found.diagnostic.message
    single = [(field,) for field in ORDER]
    growing = [ORDER[: n + 1] for n in range(1, len(ORDER))]
    for fields in [*single, *growing]:
        relaxed = _without(structure, fields, why)
        if relaxed is None:
            continue
        again = await resolve(relaxed, library, check, given=given, default=default)
        if again.writer is not None:
            return relaxed, again
    moved = _in_line(structure, why)
    if moved is None:
        return structure, found
    for relaxed in (moved, *(_without(moved, fields, why) for fields in growing)):
        if relaxed is None:
            continue
        again = await resolve(relaxed, library, check, given=given, default=default)
        if again.writer is not None:
            return relaxed, again
    return structure, found


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
        unmet = Unmet(text=f"{spec.name}: {place.position.replace('_', ' ')}", reason=why)
        changed = changed.with_component(
            component.model_copy(
                update={"spec": spec.model_copy(update={"placement": placement}), "unmet": (*component.unmet, unmet)}
            )
        )
    return changed if changed is not structure else None


def _without(structure: Structure, fields: tuple[str, ...], why: str) -> Structure | None:
    """The structure with fields of R left open; None where none of them was set."""
    place = structure.place
    update = {f: "road" if f == "kind" else None for f in fields if getattr(place.spec, f) not in (None, "road")}
    if not update:
        return None
    notes = tuple(Assumption(field=f, value="left open", reason=why) for f in update)
    spec = place.spec.model_copy(update=update)
    return structure.with_component(place.model_copy(update={"spec": spec, "assumed": (*place.assumed, *notes)}))

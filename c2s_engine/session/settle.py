"""A text that asks for more than maps or specs can give is not refused: R's least important field is left open.

Only for what was read from a text; an edit that contradicts the rest is refused, with the fields named.
"""

from c2s_engine.check.client import CheckClient
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import Resolution, resolve
from c2s_engine.structure.components import Assumption, Structure

ORDER = (
    "speed_limit", "shoulder", "sidewalk", "distance", "crosswalk", "ego_lane", "lanes", "arms", "curve", "oncoming",
    "control", "manoeuvre", "kind",
)  # fmt: skip
"""Fields of R, from the one that is given up first."""


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
    return structure, found


def _without(structure: Structure, fields: tuple[str, ...], why: str) -> Structure | None:
    """The structure with fields of R left open; None where none of them was set."""
    place = structure.place
    update = {f: "road" if f == "kind" else None for f in fields if getattr(place.spec, f) not in (None, "road")}
    if not update:
        return None
    notes = tuple(Assumption(field=f, value="left open", reason=why) for f in update)
    spec = place.spec.model_copy(update=update)
    return structure.with_component(place.model_copy(update={"spec": spec, "assumed": (*place.assumed, *notes)}))

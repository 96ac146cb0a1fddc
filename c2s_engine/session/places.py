"""Which map a structure is written for, and whether that map has its place (DESIGN, "R")."""

from dataclasses import dataclass

from c2s_engine.check.client import CheckClient
from c2s_engine.check.protocol import PlacesRequest
from c2s_engine.maps.expressions import relaxed
from c2s_engine.maps.extras import read_extras
from c2s_engine.maps.library import SHIPPED, MapFile, MapLibrary, MapNotFound
from c2s_engine.structure.components import Assumption, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.specs import PlaceSpec, SettingsSpec
from c2s_engine.write.typed import ResolveError, TypedWriter, contradiction
from c2s_engine.write.typed.kernel import source
from c2s_engine.write.typed.writer import MapChoice

DEFAULT_MAP = "Town05"
ROOMS = (1.0, 0.7, 0.45, 0.25)
PRELUDE = "import math\n" + source("approach") + source("pocket") + source("ring_approach") + source("bend_start")


@dataclass(frozen=True)
class Resolution:
    """The map and the room that fit, how many places match, and what was assumed about it; or why nothing fits."""

    writer: TypedWriter | None
    count: int = 0
    assumed: tuple[Assumption, ...] = ()
    diagnostic: Diagnostic | None = None


def map_choice(library: MapLibrary, map_file: MapFile) -> MapChoice:
    return MapChoice(
        name=map_file.name,
        path=library.working_copy(map_file),
        carla_map=map_file.carla_map,
        digest=map_file.digest,
        extras=read_extras(map_file.path),
    )


async def resolve(
    structure: Structure,
    library: MapLibrary,
    check: CheckClient,
    *,
    given: str | None = None,
    default: str | None = None,
) -> Resolution:
    """Find a map that has the place: the one given, else the text's, else the default, else the shipped town.

    A map that the caller gives must do: where it is not there or lacks the place, that is a diagnostic.
    """
    spec = structure.settings.spec
    named = spec.map if isinstance(spec, SettingsSpec) else None
    assumed: list[Assumption] = []
    if (error := contradiction(structure)) is not None:
        return Resolution(None, diagnostic=_diagnostic(str(error), "contradiction", error.fields))
    for wanted in dict.fromkeys(w for w in (given, named, default or DEFAULT_MAP, SHIPPED) if w):
        try:
            choice = map_choice(library, library.find(wanted))
        except MapNotFound as error:
            if wanted == given:
                return Resolution(None, diagnostic=_diagnostic(str(error), "unknown-map", ("G.map",)))
            if wanted == named:
                assumed.append(Assumption(field="map", value=SHIPPED, reason=f"{wanted} is not on this machine"))
            continue
        writers = {f"room {r}": TypedWriter(choice, room=r) for r in ROOMS}
        expressions = {name: w.candidates(structure) for name, w in writers.items()}
        report = await check.places(PlacesRequest(map=str(choice.path), expressions=expressions, prelude=PRELUDE))
        if report.errors:
            broken = next(iter(report.errors.values()))
            return Resolution(
                None, diagnostic=_diagnostic(f"the place cannot be looked up: {broken}", "lookup", ("R",))
            )
        for name, writer in writers.items():
            if report.counts.get(name):
                if wanted not in (given, named):
                    reason = "no map is named" if named is None else f"{named} cannot be used here"
                    if wanted == SHIPPED and not library_has(library, DEFAULT_MAP):
                        reason += f"; {DEFAULT_MAP}, the paper's default, is not on this machine"
                    assumed.append(Assumption(field="map", value=choice.name, reason=reason))
                return Resolution(writer, report.counts[name], tuple(assumed))
        if wanted == given:
            break
        assumed.append(Assumption(field="map", value=SHIPPED, reason=f"{wanted} has no such place"))
    nearest = await _nearest(structure, library, check, given)
    lack = f"{given} has no such place" if given else "no map at hand has such a place"
    return Resolution(None, diagnostic=_diagnostic(f"{lack}. {nearest}", "no-place", ("R",)))


def library_has(library: MapLibrary, name: str) -> bool:
    return name in library.names()


async def _nearest(structure: Structure, library: MapLibrary, check: CheckClient, given: str | None) -> str:
    """Which single field of R, left open, would give places."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    choice = map_choice(library, library.find(given or SHIPPED))
    found = []
    for field, spec in relaxed(place).items():
        changed = structure.with_component(structure.place.model_copy(update={"spec": spec}))
        try:
            expression = TypedWriter(choice, room=ROOMS[-1]).candidates(changed)
        except ResolveError:
            continue
        report = await check.places(
            PlacesRequest(map=str(choice.path), expressions={field: expression}, prelude=PRELUDE)
        )
        if report.counts.get(field):
            found.append(f"R.{field} left open gives {report.counts[field]} places on {choice.name}")
    others = await _maps_with(structure, library, check, given)
    ways = [*found, *([f"{' and '.join(others)} {'has' if len(others) == 1 else 'have'} it"] if others else [])]
    return "; ".join(ways) + "." if ways else "Change R.kind, or name another map."


async def _maps_with(structure: Structure, library: MapLibrary, check: CheckClient, given: str | None) -> list[str]:
    """The default map and the shipped town, where they have the place that the given map lacks."""
    found = []
    for name in (DEFAULT_MAP, SHIPPED):
        if given is None or name == given or not library_has(library, name):
            continue
        choice = map_choice(library, library.find(name))
        expressions = {f"room {r}": TypedWriter(choice, room=r).candidates(structure) for r in ROOMS}
        report = await check.places(PlacesRequest(map=str(choice.path), expressions=expressions, prelude=PRELUDE))
        if any(report.counts.values()):
            found.append(name)
    return found


def _diagnostic(message: str, code: str, fields: tuple[str, ...]) -> Diagnostic:
    component = fields[0].split(".")[0] if fields else None
    return Diagnostic(stage="resolve", message=message, code=code, component=component, text=", ".join(fields))

"""Which map a structure is written for, and whether that map has its place (DESIGN, "R")."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from c2s_engine.check.client import CheckClient, CheckError
from c2s_engine.check.protocol import PlacesRequest
from c2s_engine.maps.expressions import relaxed
from c2s_engine.maps.extras import MapExtras, read_extras
from c2s_engine.maps.library import SHIPPED, MapFile, MapLibrary, MapNotFound
from c2s_engine.maps.opendrive import BrokenMap
from c2s_engine.structure.components import Assumption, Structure
from c2s_engine.structure.diagnostics import Diagnostic
from c2s_engine.structure.specs import PlaceSpec, SettingsSpec
from c2s_engine.write.typed import ResolveError, TypedWriter, contradiction
from c2s_engine.write.typed.writer import MapChoice

DEFAULT_MAP = "Town05"
FIRST = (DEFAULT_MAP, "Town10HD", "Town04", "Town03", "Town07", "Town06")
"""CARLA's towns that are looked at before the others, where no map is named: those with most kinds of places first."""
ROOMS = (1.0, 0.7, 0.45, 0.25)
"""How much of the way to a junction, or of a stretch of road, that a structure would take must be there: the best
first."""
ENOUGH = ROOMS.index(0.45)
"""The highest `less` of a stretch of road that has room for the speeds of a scene."""
ANY = len(ROOMS) + 1
"""`less` of a stretch of road that is shorter, leads past stop signs, or bends too much for the speeds."""


@dataclass(frozen=True)
class Resolution:
    """The map and the fit, how many places match, and what was assumed about it; or why nothing fits. `less`: 0 where
    the map has all the road that the structure takes, more the less of it there is."""

    writer: TypedWriter | None
    count: int = 0
    assumed: tuple[Assumption, ...] = ()
    diagnostic: Diagnostic | None = None
    less: int = 0


def is_short(structure: Structure, found: Resolution) -> bool:
    """Whether a map has no stretch of road with the room for the speeds of a structure."""
    return found.writer is not None and found.less > ENOUGH and bool(found.writer.stretch(structure))


def map_choice(library: MapLibrary, map_file: MapFile) -> MapChoice:
    return MapChoice(
        name=map_file.name,
        path=library.working_copy(map_file),
        carla_map=map_file.carla_map,
        digest=map_file.digest,
        extras=read_extras(map_file.path),
    )


def named_map(structure: Structure) -> str | None:
    """The map that the text names."""
    spec = structure.settings.spec
    return spec.map if isinstance(spec, SettingsSpec) else None


def demanded(structure: Structure, library: MapLibrary) -> str | None:
    """The map that the text names, where that is at hand."""
    named = named_map(structure)
    return named if named is not None and named.lower() in {name.lower() for name in library.names()} else None


def at_hand(library: MapLibrary, default: str | None) -> tuple[str, ...]:
    """Where a place is looked for that no map is named for: the default, CARLA's towns, other maps, the shipped one."""
    known = library.names()
    beyond = [name for name in known if name != SHIPPED]
    towns = sorted((n for n in beyond if library.is_town(n)), key=lambda n: (FIRST.index(n) if n in FIRST else 99, n))
    found = (default or DEFAULT_MAP, *towns, *beyond, SHIPPED)
    return tuple(dict.fromkeys(name for name in found if name in known or name == default))


async def resolve(
    structure: Structure,
    library: MapLibrary,
    check: CheckClient,
    *,
    given: str | None = None,
    default: str | None = None,
    offers: bool = True,
) -> Resolution:
    """Find a map that has the place: the one given, else the text's, else the one that it was on before, else of those
    at hand the first with all the road that it takes, or with the most of it; the shipped one only if no other has it.

    A map that the caller gives must do: where it is not there or lacks the place, that is a diagnostic.
    `offers`: whether a refusal names what would do.
    """
    if (error := contradiction(structure)) is not None:
        return Resolution(None, diagnostic=refusal(str(error), "contradiction", error.fields))
    named = named_map(structure)
    before = next((str(a.value) for a in structure.settings.assumed if a.field == "map"), None)
    beyond = (*((before,) if before in library.names() else ()), *at_hand(library, default))
    names = (given,) if given else tuple(dict.fromkeys(n for n in (named, *beyond) if n))
    lacking, failed, looked, best = "", None, False, Resolution(None, less=ANY + 1)
    for wanted, under in _looked_up(names, (given, named, before)):
        if under > ANY and best.writer is not None:
            break
        try:
            found = await on_map(structure, library, check, wanted, min(under, best.less))
        except (MapNotFound, BrokenMap) as error:
            if wanted == given:
                return Resolution(None, diagnostic=refusal(str(error), "unknown-map", ("G.map",)))
            if wanted == named:
                lacking = f"{named} is not on this machine" if isinstance(error, MapNotFound) else str(error)
            continue
        except CheckError as error:
            if wanted in (given, named):
                return _not_looked_up(error)
            failed = failed or error
            continue
        looked = True
        if found is not None and wanted in (given, named):
            return found
        best = found or best
        if found is not None and (best.less == 0 or wanted == before):
            break
        lacking = lacking or (f"{wanted} has no such place" if wanted == named else "")
    if best.writer is not None:
        chosen = best.writer.map.name
        assumed = Assumption(field="map", value=chosen, reason=lacking or _chosen(chosen, library))
        return replace(best, assumed=(assumed,))
    if failed is not None and not looked:
        return _not_looked_up(failed)
    nearest = await _offers(structure, library, check, given) if offers else ""
    lack = f"{given} has no such place" if given else "no available map has such a place"
    return Resolution(None, diagnostic=refusal(f"{lack}. {nearest}", "no-place", ("R",)))


def _not_looked_up(error: CheckError) -> Resolution:
    """The refusal where maps cannot be searched at all, which says nothing of what is on them."""
    lookup = f"the place cannot be looked up: {error}"
    return Resolution(None, diagnostic=refusal(lookup, "lookup", ("R",)))


def _looked_up(names: Sequence[str], wished: Sequence[str | None]) -> Iterator[tuple[str, int]]:
    """In which order places are looked up on maps, each with the bound of `less`: on those that are wished whatever
    there is; else first stretches up to their junctions, which takes less time, and on the shipped map last."""
    yield from ((name, ANY + 1) for name in names if name in wished)
    others = [name for name in names if name not in wished and name != SHIPPED]
    yield from ((name, under) for under in (ANY, ANY + 1) for name in others)
    yield from ((name, ANY + 1) for name in names if name == SHIPPED and name not in wished)


async def on_map(
    structure: Structure, library: MapLibrary, check: CheckClient, name: str, under: int | None = None
) -> Resolution | None:
    """The best fit on one map, with `less` under a bound; None where it lacks that. Raises MapNotFound, BrokenMap,
    CheckError."""
    found = await first_on_map((structure,), library, check, name, under)
    return found[1] if found else None


async def first_on_map(
    structures: Sequence[Structure], library: MapLibrary, check: CheckClient, name: str, under: int | None = None
) -> tuple[int, Resolution] | None:
    """Of several structures the first that has places on a map, by its number, with its best fit; asked for at once.

    None where no structure has any; those that contradict themselves have none. Raises as `on_map` does.
    """
    choice = map_choice(library, library.find(name))
    writers = [TypedWriter(choice, room=room) for room in ROOMS]
    fits: dict[str, tuple[int, TypedWriter, int]] = {}
    for number, structure in enumerate(structures):
        if contradiction(structure) is None and not lacks(structure, choice.extras):
            for expression, writer, less in _ways_to_fit(structure, writers):
                fits.setdefault(expression, (number, writer, less))
    fits = {expression: fit for expression, fit in fits.items() if under is None or fit[2] < under}
    if not fits:
        return None
    expressions = {expression: expression for expression in fits}
    report = await check.places(PlacesRequest(map=str(choice.path), expressions=expressions, first=True))
    if report.errors:
        raise CheckError(next(iter(report.errors.values())))
    for expression, count in report.counts.items():
        if count:
            number, writer, less = fits[expression]
            return number, Resolution(writer, count, less=less)
    return None


def _ways_to_fit(structure: Structure, writers: Sequence[TypedWriter]) -> Iterator[tuple[str, TypedWriter, int]]:
    """What may be looked up for a structure, with the writer for what is found there and `less`, the best first."""
    first, place = writers[0], structure.place.spec
    assert isinstance(place, PlaceSpec)
    length, longest = first.stretch(structure), first.map.extras.longest(place.lanes or 1)
    for less, writer in enumerate(writers):
        if not length:
            yield writer.candidates(structure), writer, less
            continue
        if less == ENOUGH + 1:
            yield first.candidates(structure, share=ROOMS[ENOUGH], across=True), first, ENOUGH
        if writer.room * length <= longest:
            yield first.candidates(structure, share=writer.room), first, less
    if length:
        yield first.candidates(structure), first, ANY


def lacks(structure: Structure, extras: MapExtras) -> str:
    """In a sentence, why the map's own file says that there can be no such place; nothing where it may have one."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    there = {"roundabout": extras.of_kind("roundabout"), "on_ramp": extras.ramps("on_ramp"),
             "off_ramp": extras.ramps("off_ramp")}  # fmt: skip
    if not there.get(place.kind, True):
        return f"The map has no {place.kind.replace('_', '-')}."
    if place.kind == "motorway" and not any(road.motorway for road in extras.roads.values()):
        return "The map has no motorway."
    if place.lanes and place.lanes > max(max(road.left, road.right) for road in extras.roads.values()):
        return f"The map has no road of {place.lanes} lanes in one direction."
    if place.control in ("signal", "stop", "yield") and not any(c.kind == place.control for c in extras.controls):
        return f"The map has no {place.control} {'' if place.control == 'signal' else 'sign '}at an intersection."
    return ""


def _chosen(name: str, library: MapLibrary) -> str:
    """Why a map was taken that nobody named."""
    if name == SHIPPED and DEFAULT_MAP not in library.names():
        return f"no map is named; {DEFAULT_MAP}, the usual default, is not installed"
    return "no map is named"


async def _offers(structure: Structure, library: MapLibrary, check: CheckClient, given: str | None) -> str:
    """What the map lacks, which fields of R, left open, would give places, and which other maps have them all."""
    place = structure.place.spec
    assert isinstance(place, PlaceSpec)
    name = given or SHIPPED
    choice = map_choice(library, library.find(name))
    ways = [missing.rstrip(".")] if (missing := lacks(structure, choice.extras)) else []
    single = relaxed(place)
    for field, spec in single.items():
        found = await _quietly(_placed(structure, spec), library, check, name)
        if found is not None:
            ways.append(f"R.{field} left open gives {_places(found.count)} on {choice.name}")
    if not ways:
        plain = _placed(structure, PlaceSpec(kind=place.kind))
        ways.append(await _lacking(plain, library, check, choice, tuple(single)))
    others = await having(structure, library, check, (n for n in at_hand(library, None) if n != name))
    if others:
        ways.append(f"{listed(others)} {'has' if len(others) == 1 else 'have'} it")
    return "; ".join(way for way in ways if way) + "." if any(ways) else "Change R.kind, or name another map."


def _placed(structure: Structure, spec: PlaceSpec) -> Structure:
    return structure.with_component(structure.place.model_copy(update={"spec": spec}))


async def _lacking(
    plain: Structure, library: MapLibrary, check: CheckClient, choice: MapChoice, fields: Sequence[str]
) -> str:
    """What keeps a map from having the place, where no single field does: all fields together, or none of them.

    `plain`: the structure with nothing of R said but its kind.
    """
    if fields and (found := await _quietly(plain, library, check, choice.name)) is not None:
        together = listed([f"R.{field}" for field in fields])
        return f"leaving {together} open gives {_places(found.count)} on {choice.name}"
    try:
        return f"It has no {TypedWriter(choice, room=ROOMS[-1]).candidates(plain)}, whatever else of R is left open"
    except ResolveError:
        return ""


def listed(names: Sequence[str]) -> str:
    return f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]


def _places(count: int) -> str:
    return "one place" if count == 1 else f"{count} places"


async def having(
    structure: Structure, library: MapLibrary, check: CheckClient, names: Iterable[str], room: bool = False
) -> tuple[str, ...]:
    """Those maps that have the place; with `room`, those of them that have the room for the speeds, too."""
    found = [(name, await _quietly(structure, library, check, name)) for name in names]
    return tuple(name for name, there in found if there is not None and not (room and is_short(structure, there)))


async def _quietly(structure: Structure, library: MapLibrary, check: CheckClient, name: str) -> Resolution | None:
    try:
        return await on_map(structure, library, check, name)
    except (MapNotFound, BrokenMap, CheckError, ResolveError):
        return None


def refusal(message: str, code: str, fields: tuple[str, ...]) -> Diagnostic:
    component = fields[0].split(".")[0] if fields else None
    return Diagnostic(stage="resolve", message=message, code=code, component=component, text=", ".join(fields))

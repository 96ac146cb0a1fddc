"""Programs of the typed writer: one for each action and one for each place of the vocabulary, on the shipped town."""

import itertools
import typing
from collections.abc import AsyncIterator

from c2s_engine.api import Engine
from c2s_engine.structure import vocabulary
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec, RestrictionsSpec, SettingsSpec

PLACES = ("straight", "intersection", "motorway", "crosswalk", "road")
POSITIONS = ("ahead", "left_lane", "right_lane", "crossing_left", "oncoming_lane", "sidewalk", "roadside", "parked")
TYPES = ("car", "pedestrian")


async def programs() -> AsyncIterator[tuple[str, str]]:
    """Name and text of each; raises LookupError where no structure of an action or a place resolves."""
    async with Engine() as engine:
        for action in typing.get_args(vocabulary.Action):
            tries = itertools.product(TYPES, PLACES, POSITIONS)
            yield f"action_{action}", await _first(engine, action, (_acting(action, *one) for one in tries))
        for place in typing.get_args(vocabulary.PlaceKind):
            yield f"place_{place}", await _first(engine, place, (_structure(place, p, "car", None) for p in POSITIONS))


def _acting(action: str, kind: str, place: str, position: str) -> Structure:
    return _structure(place, position, kind, action)


def _structure(place: str, position: str, kind: str, action: str | None) -> Structure:
    phases = (Phase(action=action, target="ego"),) if action else ()  # type: ignore[arg-type]
    spec = ObjectSpec(name="other", type=kind, placement=Placement(position=position), phases=phases)  # type: ignore[arg-type]
    return Structure(
        settings=Component(id="G", spec=SettingsSpec()),
        place=Component(id="R", spec=PlaceSpec(kind=place)),  # type: ignore[arg-type]
        ego=Component(id="E", spec=EgoSpec(speed=8)),
        objects=(Component(id="O1", spec=spec),),
        restrictions=Component(id="T", spec=RestrictionsSpec()),
    )


async def _first(engine: Engine, name: str, structures: typing.Iterable[Structure]) -> str:
    """The first program that resolves, compiles and samples."""
    for structure in structures:
        async for event in engine.apply(structure, [], run=False):
            if isinstance(event, Finished) and event.ok:
                return event.program.text
    raise LookupError(f"no program with {name}")

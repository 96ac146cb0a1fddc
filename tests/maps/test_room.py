"""On a town whose roads are short, speeds are lowered for the room there is, and said; or refused with what has it."""

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.session.settle import settle, strictly
from c2s_engine.structure.components import FITTED, Component, Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from tests.maps.test_towns import SAID, TOWNS

pytestmark = [
    pytest.mark.full,
    pytest.mark.skipif(TOWNS is None, reason="CARLA's towns are not in ../shared/maps nor $C2S_SHARED_MAPS"),
]


@pytest.fixture
async def engine():
    async with Engine(Settings(map_folders=(str(TOWNS),))) as started:
        yield started


def scene(said) -> Structure:
    return Structure(
        place=Component(id="R", spec=PlaceSpec(**said["R"])),
        ego=Component(id="E", spec=EgoSpec(**said["E"])),
        objects=tuple(Component(id=f"O{k}", spec=ObjectSpec(**o)) for k, o in enumerate(said["O"], 1)),
    )


@pytest.mark.parametrize(("town", "said", "lowered"), SAID["room"])
async def test_speeds_are_lowered_for_the_room_there_is(engine, town, said, lowered):
    before = scene(said)
    after, found = await settle(before, engine.library, engine.check_client, given=town, default=None)
    assert found.writer is not None
    notes = {f"{c.id}.{a.field}": a for c in after.components for a in c.assumed if a.by == FITTED}
    assert notes.keys() == lowered.keys()
    for field, within in lowered.items():
        least, most = map(float, within.split(" to "))
        assert least <= float(notes[field].value.removesuffix(" km/h")) <= most
        assert f"was specified; the roads of {town} only allow" in notes[field].reason
    assert lowered or after == before


@pytest.mark.parametrize(("town", "said", "lowered"), SAID["room"])
async def test_or_refused_with_the_maps_that_have_it(engine, town, said, lowered):
    before = scene(said)
    after, found = await strictly(before, engine.library, engine.check_client, given=town, default=None)
    assert after == before
    assert (found.diagnostic is not None) == bool(lowered)
    if found.diagnostic is not None:
        assert found.diagnostic.message.startswith(f"{town} has no such road")
        assert "Town04" in found.diagnostic.message

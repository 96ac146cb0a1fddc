"""Places on CARLA's towns: the town that has one is taken, else the nearest on the one named; skipped without them."""

import os
from pathlib import Path

import pytest

from c2s_engine.api import Engine
from c2s_engine.config import Settings
from c2s_engine.session.places import ANY, demanded, resolve
from c2s_engine.session.settle import settle
from c2s_engine.structure.components import Assumption, Component, Structure
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec, SettingsSpec

FOLDERS = (os.environ.get("C2S_SHARED_MAPS", ""), str(Path(__file__).parents[3] / "shared" / "maps"))
TOWNS = next((Path(folder) for folder in FOLDERS if folder and Path(folder).is_dir()), None)

pytestmark = pytest.mark.skipif(TOWNS is None, reason="CARLA's towns are not in ../shared/maps nor $C2S_SHARED_MAPS")


@pytest.fixture
async def engine(tmp_path):
    root = tmp_path / "CarlaUE4/Content/Carla/Maps/OpenDrive"
    root.mkdir(parents=True)
    for name in ("Town07", "Town10HD"):
        (root / f"{name}.xodr").symlink_to(TOWNS / f"{name}.xodr")
    async with Engine(Settings(carla_root=str(tmp_path), offers=False)) as started:
        yield started


def asks(**place):
    return Structure(place=Component(id="R", spec=PlaceSpec(**place)), ego=Component(id="E", spec=EgoSpec(speed=10.0)))


@pytest.mark.full
async def test_where_places_are_found_and_what_is_told(engine):
    library, check = engine.library, engine.check_client
    signals = asks(kind="intersection", arms=4, control="signal", manoeuvre="straight")
    found = await resolve(signals, library, check)
    assert found.writer.map.name == "Town07"  # with more road before it than Town10HD has
    assert [(a.field, a.value) for a in found.assumed] == [("map", "Town07")]
    there = Assumption(field="map", value="Town10HD", reason="no map is named")
    kept = signals.with_component(Component(id="G", spec=SettingsSpec(), assumed=(there,)))
    assert (await resolve(kept, library, check)).writer.map.name == "Town10HD"  # an edit does not move the scene
    road = asks(kind="road").with_component(Component(id="E", spec=EgoSpec(speed=25.0)))
    assert (await resolve(road, library, check)).less == ANY  # neither has one fit for 90 km/h
    assert (await resolve(asks(kind="road"), library, check)).less < ANY
    stops = asks(kind="intersection", arms=4, control="stop", manoeuvre="straight")
    assert (await resolve(stops, library, check)).writer.map.name == "Town07"
    assert (await resolve(asks(kind="roundabout"), library, check)).writer.map.name == "town"

    refused = await resolve(stops, library, check, given="Town10HD")
    assert refused.writer is None
    assert "Town07 and town have it" in refused.diagnostic.message
    relaxed, found = await settle(stops, library, check, given="Town10HD", default=None)
    assert found.writer.map.name == "Town10HD"
    (note,) = relaxed.place.assumed
    assert (note.field, note.value) == ("arms", "left open")
    assert note.reason == "originally 4: Town10HD has no such place"
    _, found = await settle(asks(kind="roundabout"), library, check, given="Town10HD", default=None)
    assert found.writer is None
    assert "The map has no roundabout; town has it." in found.diagnostic.message


@pytest.mark.full
async def test_what_is_missing_is_named_where_no_single_field_is(engine):
    library, check = engine.library, engine.check_client
    narrow = asks(kind="straight", ego_lane="middle", shoulder=True, crosswalk=True)
    refused = await resolve(narrow, library, check, given="Town07")
    assert "leaving R.ego_lane, R.shoulder and R.crosswalk open gives" in refused.diagnostic.message
    assert "town has it" in refused.diagnostic.message

    runs_stop = asks(kind="intersection", arms=4, manoeuvre="straight").with_component(
        Component(id="E", spec=EgoSpec(speed=10.0, phases=(Phase(action="run_stop"),)))
    )
    truck = ObjectSpec(name="truck", type="truck", placement=Placement(position="crossing_left"))
    runs_stop = runs_stop.model_copy(update={"objects": (Component(id="O1", spec=truck),)})
    refused = await resolve(runs_stop, library, check, given="Town10HD")
    message = refused.diagnostic.message
    assert "It has no junctions(STRAIGHT, control='stop'," in message
    assert "others=[From('left', priority=True)]), whatever else of R is left open; Town07 and town have it." in message


@pytest.mark.full
async def test_on_a_town_of_narrow_roads_lanes_beside_ego_are_given_up_last(engine):
    library, check = engine.library, engine.check_client

    def wants(*objects, **ego):
        structure = asks(kind="motorway", lanes=2, ego_lane="rightmost")
        structure = structure.with_component(Component(id="E", spec=EgoSpec(speed=20.0, **ego)))
        return structure.model_copy(
            update={"objects": tuple(Component(id=f"O{i}", spec=o) for i, o in enumerate(objects, 1))}
        )

    truck = ObjectSpec(name="truck", type="truck", speed=10.0, placement=Placement(position="ahead"))
    passing = wants(truck, phases=(Phase(action="overtake", target="O1"),))
    relaxed, found = await settle(passing, library, check, given="Town07", default=None)
    assert found.writer.map.name == "Town07"
    assert {a.field: (a.value, a.reason) for a in relaxed.place.assumed} == {
        "lanes": ("1", "originally 2: Town07 has no such place"),
        "kind": ("left open", "originally motorway: Town07 has no such place"),
    }
    assert relaxed.objects == passing.objects

    beside = wants(ObjectSpec(name="van", type="van", placement=Placement(position="left_lane", along="behind")))
    relaxed, found = await settle(beside, library, check, given="Town07", default=None)
    assert found.writer is not None
    assert relaxed["O1"].spec.placement.position == "behind"
    reasons = {a.field: a.reason for a in relaxed["O1"].assumed}
    assert reasons.pop("placement.position") == "originally left lane: Town07 has no such place"
    assert set(reasons) <= {"speed"} and all("only allow" in reason for reason in reasons.values())

    _, found = await settle(asks(kind="on_ramp"), library, check, given="Town07", default=None)
    assert found.writer is None
    assert "The map has no on-ramp; town has it." in found.diagnostic.message


@pytest.mark.full
async def test_a_map_that_the_text_names_is_kept_where_places_are_strict(engine):
    structure = asks(kind="roundabout").with_component(Component(id="G", spec=SettingsSpec(map="Town07")))
    assert demanded(structure, engine.library) == "Town07"
    text = "In Town07 ego drives around in a roundabout."
    strict, lenient = [
        [e async for e in engine.generate(text, strict=strict, run=False) if isinstance(e, Finished)][0]
        for strict in (True, False)
    ]
    assert not strict.ok
    assert "Town07 has no such place. The map has no roundabout; town has it." in strict.diagnostics[0].message
    assert lenient.ok and lenient.details["map"] == "town"
    assert [a.reason for a in lenient.structure.settings.assumed if a.field == "map"] == ["Town07 has no such place"]


@pytest.mark.full
async def test_ego_comes_over_several_short_roads(engine):
    text = "Ego drives at 50 km/h. 60 m ahead of it a truck drives at 30 km/h on the same straight road. Ego brakes."
    done = [e async for e in engine.generate(text, map="Town07") if isinstance(e, Finished)][0]
    assert done.ok, done.diagnostics
    assert done.details["map"] == "Town07"
    refused = [
        e
        async for e in engine.generate("Ego drives around in a roundabout.", map="Town07", strict=True, run=False)
        if isinstance(e, Finished)
    ][0]
    assert not refused.ok
    assert "town has it" in refused.diagnostics[0].message

"""Programs that are deliberately wrong in one thing, checked and run for real, lose the atoms of that thing."""

import pytest
from bench_scenes import record

from c2s_bench.scorer import score
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckRequest
from c2s_engine.maps.library import MapLibrary
from c2s_engine.session.places import map_choice
from c2s_engine.structure import specs as s
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import AddObject, SetField, apply
from c2s_engine.structure.program import assemble
from c2s_engine.structure.regenerate import regenerate
from c2s_engine.write.typed import TypedWriter

pytestmark = pytest.mark.full

EXPECT = """
road: {lanes_same_direction: {min: 2}}
ego: {does: [keep_lane]}
actors:
  - {as: lead, type: car, starts: {relation: ahead, lane: same, gap_m: [20, 45]}, does: [brake_hard]}
environment: {weather: heavy_rain, time: night}
"""
RUNS = 3


def scene():
    """Ego follows a car that brakes hard, at night in heavy rain, on a road with two lanes."""
    brake = s.Phase(action="brake", rate=6.0, speed=3.0, trigger=s.Trigger(kind="time", value=4.0))
    placement = s.Placement(position="ahead", gap=30.0)
    structure = Structure(
        settings=Component(id="G", spec=s.SettingsSpec(weather=("heavy_rain",), time="night")),
        place=Component(id="R", spec=s.PlaceSpec(kind="road", lanes=2, ego_lane="rightmost")),
        ego=Component(id="E", spec=s.EgoSpec(speed=13.9, reaction="brake")),
    )
    return apply(structure, AddObject(spec=s.ObjectSpec(name="lead", placement=placement, speed=13.9, phases=(brake,))))


STRANGER = AddObject(spec=s.ObjectSpec(name="stranger", type="bus", placement=s.Placement(position="left_lane")))
WRONG = {
    "right": ([], set()),
    "without the event": ([SetField(component="O1", path="phases", value=[])], {"lead: brake_hard"}),
    "the wrong actor": ([SetField(component="O1", path="type", value="truck")], {"lead: car"}),
    "the other lane": (
        [SetField(component="O1", path="placement.position", value="left_lane")], {"lead: starts lane: same"}
    ),
    "too far away": ([SetField(component="O1", path="placement.gap", value=70)], {"lead: starts gap_m: 20 to 45"}),
    "no weather": (
        [SetField(component="G", path="weather", value=[]), SetField(component="G", path="time", value=None)],
        {"weather heavy_rain", "time night"},
    ),
    "a stranger": ([STRANGER], {"stranger moves, and nothing expects it"}),
}  # fmt: skip


@pytest.fixture(scope="module")
def check():
    with SyncCheckClient(runner="c2s_engine.dryrun.runner:run_scene") as client:
        yield client


@pytest.fixture(scope="module")
def library():
    return MapLibrary()


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_program_loses_the_atoms_of_what_is_wrong(check, library, name):
    edits, expected = WRONG[name]
    chosen = map_choice(library, library.find("town"))
    structure, _ = regenerate(scene(), edits, TypedWriter(chosen))
    request = CheckRequest(program=assemble(structure).text, folder=str(chosen.path.parent), upto="run", runs=RUNS)
    report = check.check(request)
    assert report.ok, [d.message for stage in report.stages for d in stage.diagnostics]
    result = score(record(EXPECT), report.facts, RUNS)
    assert result.ran
    assert {a.atom for a in result.atoms if a.counts and not a.holds} == expected

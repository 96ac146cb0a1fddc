"""Programs as others write them: VerifAI's samplers, the abstract driving model, the Newtonian one."""

import importlib.util

import pytest

from c2s_engine import paths
from c2s_engine.check.client import SyncCheckClient
from c2s_engine.check.protocol import CheckReport, CheckRequest

CARLA = "scenic.simulators.carla.model"
DRIVES = """\
behavior Walk():
    take SetWalkingDirectionAction(self.heading), SetWalkingSpeedAction(1.5)
behavior Onward(speed):
    try:
        do FollowLaneBehavior(speed)
    interrupt when withinDistanceToAnyPedestrians(self, 5):
        take SetBrakeAction(1)
ego = new Car on Uniform(*network.lanes).centerline, with behavior Onward(8), with speed 5
person = new Pedestrian with behavior Walk()
terminate after 3 seconds
"""
SAMPLERS = """\
param verifaiSamplerType = 'halton'
param verifaiHeaders = ['speed']
param SPEED = VerifaiRange(4, 9)
kind = VerifaiOptions({'vehicle.lincoln.mkz_2017': 1, 'vehicle.tesla.model3': 2})
count = VerifaiDiscreteRange(2, 3)
behavior Onward():
    do FollowLaneBehavior(globalParameters.SPEED)
ego = new Car on Uniform(*network.lanes).centerline, with blueprint kind, with behavior Onward()
terminate after 2 seconds
"""


@pytest.fixture(scope="module")
def dry() -> SyncCheckClient:
    with SyncCheckClient(runner="c2s_engine.dryrun.runner:run_scene") as client:
        yield client


def check(dry: SyncCheckClient, code: str, model: str = CARLA, override: str | None = None, scenario: str | None = None,
          ) -> CheckReport:  # fmt: skip
    head = f"param map = localPath('town.xodr')\nparam render = 0\nmodel {model}\n"
    folder = str(paths.shipped("maps"))
    return dry.check(CheckRequest(program=head + code, folder=folder, upto="run", trajectories=True, model=override,
                                  scenario=scenario))  # fmt: skip


def run(dry: SyncCheckClient, code: str, model: str = CARLA, **options: str) -> CheckReport:
    report = check(dry, code, model, **options)
    assert report.ok, [d.message for s in report.stages for d in s.diagnostics]
    return report


@pytest.mark.parametrize("model", ["scenic.domains.driving.model", "scenic.simulators.newtonian.driving_model"])
def test_models_without_vehicles_of_their_own_drive_ours(dry, model):
    report = run(dry, DRIVES, model)
    ego, person = report.trajectories[0].tracks
    assert ego.kind == "car" and person.kind == "walker"
    assert ego.speed[0] == pytest.approx(5, abs=0.1) and max(ego.speed) > 6
    assert person.speed[-1] == pytest.approx(1.5)


def test_samplers_of_verifai_draw(dry):
    report = run(dry, SAMPLERS)
    notes = [d for s in report.stages for d in s.diagnostics]
    if importlib.util.find_spec("verifai") is None:
        assert [(d.code, d.severity, d.line) for d in notes] == [("verifai", "info", 6)]
        assert "c2s[verifai]" in notes[0].fix
    else:
        assert notes == []


SEVERAL = """\
scenario Pair(gap=20):
    setup:
        ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
        lead = new Car following roadDirection from ego for gap, with behavior FollowLaneBehavior(6)
        terminate after 1 seconds
scenario Late():
    setup:
        new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
scenario Composed():
    setup:
        ego = new Car on Uniform(*network.lanes).centerline, with behavior FollowLaneBehavior(6)
    compose:
        do Late() for 1 seconds
        wait
        do Late() for 0.5 seconds
"""


@pytest.mark.parametrize("name, cars, seconds", [("Pair", 2, 1.0), ("Composed", 3, 1.6)])
def test_the_scenario_that_is_meant_is_run(dry, name, cars, seconds):
    report = run(dry, SEVERAL, scenario=name)
    assert len(report.trajectories[0].tracks) == cars
    assert report.facts[0].duration == pytest.approx(seconds, abs=0.11) and report.facts[0].ended_by == "terminated"


@pytest.mark.parametrize("name, code", [(None, "several_scenarios"), ("Trio", "no_scenario")])
def test_without_one_that_can_be_run_it_is_said(dry, name, code):
    report = check(dry, SEVERAL, scenario=name)
    assert [d.code for s in report.stages for d in s.diagnostics] == [code]


def test_a_model_can_take_the_place_of_the_programs(dry):
    code = DRIVES.replace("ego = new Car on", "ego = new Truck on").replace(", with speed 5", "")
    report = run(dry, code, "scenic.domains.driving.model", override="scenic.simulators.carla.model")
    assert report.trajectories[0].tracks[0].kind == "truck"
    refused = check(dry, code, override="os")
    assert [(s.name, s.ok) for s in refused.stages] == [("parse", True), ("safety", False)]


JOINS = """\
scenario Joining():
    setup:
        new Pedestrian at 0 @ 0, with regionContainedIn everywhere, with behavior Fails()
behavior Fails():
    raise ValueError('it cannot walk there')
    wait
scenario Main():
    setup:
        ego = new Car on Uniform(*network.lanes).centerline
    compose:
        do Joining()
"""


def test_a_run_that_ends_as_a_scenario_of_its_own_begins_says_why(dry):
    report = check(dry, JOINS)
    (finding,) = [d for s in report.stages if s.name == "run" for d in s.diagnostics]
    assert "it cannot walk there" in finding.message

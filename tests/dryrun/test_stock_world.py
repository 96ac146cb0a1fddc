"""How what the stock CARLA model offers works out in the dry run: pedals, paths, walkers, lights, collisions, ends."""

import numpy as np
import pytest

pytestmark = pytest.mark.full

PLACE = """
lane = [l for r in network.roads if int(r.id)=={road} for l in r.forwardLanes.lanes][{lane}]
ego = new {kind} following lane.orientation from lane.centerline[{end}] for {at}, with behavior B(){more}
"""


def program(
    behavior, kind="Car", road=43, lane=0, at=200, end=0, more=", with blueprint 'vehicle.lincoln.mkz_2017'", extra=""
):
    body = "\n".join("    " + line for line in behavior.strip().splitlines())
    return f"behavior B():\n{body}\n" + PLACE.format(kind=kind, road=road, lane=lane, at=at, end=end, more=more) + extra


def ways(run, *args, seconds=6.0, seed=0, **more):
    done = run(program(*args, **more), seconds=seconds, seed=seed)
    assert done.ended_by in ("time", "terminated"), done.reason
    return done.recording.paths[0]


def moved(path):
    return float(np.hypot(path.x[-1] - path.x[0], path.y[-1] - path.y[0]))


def turned(path):
    return float(np.unwrap(path.heading)[-1] - path.heading[0])


def test_throttle_brake_and_handbrake(run):
    path = ways(run, "take SetThrottleAction(1)")
    assert path.speed[-1] > 15, "the setting stays"
    path = ways(run, "take SetSpeedAction(20)\ntake SetBrakeAction(1)")
    fall = -np.diff(path.speed).min() / 0.1
    assert 8.0 < fall < 9.5 and path.speed[-1] == 0
    path = ways(run, "take SetSpeedAction(10)\ntake SetHandBrakeAction(True)")
    assert path.speed[-1] == 0


@pytest.mark.parametrize(("speed", "least", "most"), [(10, 0.3, 0.8), (30, 0.5, 1.1)])
def test_coasting_slows_as_a_car_in_gear_does(run, speed, least, most):
    """Without pedals a car of 1.5 t loses about 0.1-0.15 m/s2 to the tyres, 0.03 (10 m/s) to 0.25 (30 m/s) to the air
    (half of 1.2 kg/m3 times 0.65 m2 times the speed squared), and 0.2-0.6 to the engine, which is in gear: CARLA's
    automatic gearbox keeps it so (its engine's damping is far greater at closed throttle than at full)."""
    path = ways(run, f"take SetSpeedAction({speed})", seconds=2)
    slowing = (path.speed[5] - path.speed[15]) / 1.0
    assert least < slowing < most


def test_steering_and_its_sign(run):
    assert turned(ways(run, "take SetSpeedAction(8), SetSteerAction(0.3)", seconds=2)) < -0.3, "positive is right"
    assert turned(ways(run, "take SetSpeedAction(8), SetSteerAction(-0.3)", seconds=2)) > 0.3


def test_reverse_and_gears(run):
    assert ways(run, "take SetReverseAction(True), SetThrottleAction(0.5)").forward[-1] < -3
    assert (
        ways(run, "take SetManualGearShiftAction(True)\ntake SetGearAction(-1)\ntake SetThrottleAction(0.5)").forward[
            -1
        ]
        < -2
    )
    assert ways(run, "take SetManualFirstGearShiftAction()\ntake SetThrottleAction(0.5)").forward[-1] > 5


def test_regulated_control(run):
    assert ways(run, "while True:\n    take RegulatedControlAction(1, 0, 0)").speed[-1] > 8
    path = ways(run, "take SetSpeedAction(20)\nwhile True:\n    take RegulatedControlAction(-1, 0, 0)", seconds=3)
    assert 0.5 < -np.diff(path.speed).min() / 0.1 < 1.2, "it never brakes: Scenic zeroes the signal before it uses it"


def test_walking(run):
    more = ", with regionContainedIn everywhere"
    path = ways(
        run,
        "take SetWalkingDirectionAction(self.heading + 90 deg), SetWalkingSpeedAction(2)",
        kind="Pedestrian",
        more=more,
    )
    assert moved(path) == pytest.approx(12, abs=0.5) and turned(path) == pytest.approx(np.pi / 2, abs=0.01)
    path = ways(run, "do WalkForwardBehavior(1.5)", kind="Pedestrian", more=more)
    assert moved(path) == pytest.approx(9, abs=0.5)
    text = """
behavior B():
    do WalkBehavior(1.2)
ego = new Pedestrian with behavior B()
"""
    done = run(text)
    assert 3 < moved(done.recording.paths[0]) < 7.5


def test_crossing_behavior_crosses_in_front(run):
    extra = """
behavior C():
    do CrossingBehavior(ego, 1.5, 30)
spot = new OrientedPoint following lane.orientation from ego for 60
ped = new Pedestrian at spot offset by (6, 0), facing 90 deg relative to spot, with regionContainedIn everywhere, \
    with behavior C()
"""
    done = run(program("take SetSpeedAction(8)\ndo FollowLaneBehavior(8)", road=8, extra=extra), seconds=10)
    ped = done.recording.paths[1]
    assert moved(ped) > 3 and ped.speed[:20].max() == 0


def test_following_changing_and_avoiding(run):
    path = ways(run, "take SetSpeedAction(36)\ndo FollowLaneBehavior(36)", road=44, seconds=10)
    assert path.speed[1:].min() > 35
    change = "do LaneChangeBehavior(self.laneSection.laneToLeft, target_speed=33)"
    text = f"take SetSpeedAction(33)\n{change}\ndo FollowLaneBehavior(33)"
    path = ways(run, text, seconds=8)
    assert abs(abs(path.y[-1] - path.y[0]) - 3.75) < 0.15, "in the middle of the next lane"
    assert np.abs(np.diff(path.heading)).max() < 0.02, "without a jerk"
    path = ways(run, "do ConstantThrottleBehavior(0.5)")
    assert path.speed[-1] > 5
    path = ways(run, "do AccelerateForwardBehavior()")
    assert path.speed[-1] > 5
    extra = "blocked = new Car following lane.orientation from ego for 40"
    path = ways(run, "do DriveAvoidingCollisions(10, 18)", extra=extra, seconds=10)
    assert path.speed.max() > 5 and path.speed[-1] < 0.5


def test_turning_stays_on_the_road(run, network):
    text = """
behavior B(ways):
    take SetSpeedAction(8)
    do FollowTrajectoryBehavior(8, trajectory=ways)
    do FollowLaneBehavior(8)
crossing = [i for i in network.intersections if int(i.id) == 102][0]
m = [m for m in crossing.maneuvers if m.type == ManeuverType.{kind}][0]
first = m.startLane
ego = new Car following first.orientation from first.centerline[-1] for -30,
    with behavior B([first, m.connectingLane, m.endLane])
"""
    for kind, sign in (("LEFT_TURN", 1), ("RIGHT_TURN", -1)):
        path = run(text.format(kind=kind), seconds=14).recording.paths[0]
        assert turned(path) == pytest.approx(sign * np.pi / 2, abs=0.15)
        assert all(network.drivableRegion.containsPoint((x, y, 0)) for x, y in zip(path.x, path.y, strict=True))


def test_autopilot_drives_and_keeps_its_distance(run):
    assert moved(ways(run, "do AutopilotBehavior()", road=8, at=50, seconds=10)) > 40
    assert ways(run, "take SetAutopilotAction(True, speed=12)\nwait", seconds=10).speed[-1] == pytest.approx(
        12, abs=0.5
    )
    extra = "blocked = new Car following lane.orientation from ego for 60"
    path = ways(run, "do AutopilotBehavior()", road=4, extra=extra, seconds=15)
    assert path.speed.max() > 8 and path.speed[-1] < 0.2


LIGHT = """
behavior B():
    take SetSpeedAction(8)
    while True:
        {first}
        do FollowLaneBehavior(8) for 0.1 seconds
monitor Watch():
    {watch}
    while True:
        wait
require monitor Watch()
lane = [c.lanes[0] for r in network.roads if int(r.id) == 2 for c in [r.backwardLanes, r.forwardLanes] if c][0]
ego = new Car following lane.orientation from lane.centerline[-1] for -60, with behavior B()
"""


def shown(done):
    return [state for _, junction, road, state in done.recording.lights if road == "2" and junction in ("101", "102")]


@pytest.mark.parametrize("colour", ["red", "yellow", "green"])
def test_lights_are_set_by_actions(run, colour):
    done = run(LIGHT.format(first=f"take SetTrafficLightAction({colour!r}, 100)", watch="wait"), seconds=2)
    assert colour in shown(done)[-2:], done.reason


def test_lights_are_set_and_read_by_functions(run):
    watch = "freezeTrafficLights()\n    setClosestTrafficLightStatus(ego, 'red')"
    seen = "getClosestTrafficLightStatus(self) == 'red' and withinDistanceToRedYellowTrafficLight(self, 100)"
    first = f"if {seen}:\n            terminate"
    done = run(LIGHT.format(first=first, watch=watch), seconds=3)
    assert done.ended_by == "terminated" and done.duration < 1.0


def test_lights_go_through_their_phases_and_agree(run):
    done = run("ego = new Car", seconds=40)
    states = {}
    greens = set()
    for time, junction, road, state in done.recording.lights:
        states[junction, road] = state
        if time and junction == "102":
            greens.add(frozenset(r for (j, r), s in states.items() if j == "102" and s == "green"))
    assert {frozenset(), frozenset({"2", "3"})} <= greens, "opposite approaches together, crossing ones in turn"
    assert not any("2" in g and "7" in g for g in greens)


def test_who_has_crashed_pushes_on_what_it_runs_into_and_does_not_go_through_it(run):
    ahead = "new Car following lane.orientation from ego for"
    extra = f"first = {ahead} 20\nsecond = {ahead} 26"
    done = run(program("take SetSpeedAction(15)", extra=extra), seconds=10)
    hit, then = done.recording.contacts[:2]
    assert hit[1:] == (0, 1) and then[1:] == (1, 2) and then[0] > hit[0]
    ways = done.recording.paths
    behind = [np.hypot(a.x - b.x, a.y - b.y).min() for a, b in zip(ways, ways[1:], strict=False)]
    assert min(behind) > 3.5, "no car within another"
    assert moved(ways[1]) > 1 and moved(ways[2]) > 0.3


def test_vehicles_whose_sides_only_graze_drive_on(run):
    straight = "take SetSpeedAction(8)\nwhile True:\n    wait"
    for degrees, stands in ((4, False), (45, True)):
        beside = f"""
other = new Car at ego offset by -4 @ 0, facing ego.heading - {degrees} deg, with behavior B(),
    with blueprint 'vehicle.lincoln.mkz_2017', with regionContainedIn everywhere
"""
        done = run(program(straight, extra=beside), seconds=7)
        assert done.recording.contacts, degrees
        assert (done.recording.paths[0].speed[-1] < 2) == stands, degrees


def test_collisions_end_the_run_when_those_in_them_stand(run):
    extra = "blocked = new Car following lane.orientation from ego for 20"
    done = run(program("take SetSpeedAction(15)", extra=extra), seconds=10)
    assert done.ended_by == "collision"
    rolls_out = 15 / 2 / 6  # both take half of its speed, and lose 6 m/s2
    assert done.duration == pytest.approx(done.recording.contacts[0][0] + rolls_out, abs=0.15)
    slow = run(program("take SetSpeedAction(5)", extra=extra), seconds=10)
    assert slow.duration == pytest.approx(slow.recording.contacts[0][0] + 1.0, abs=0.15), "a second at least"
    low = "thing = new Prop following lane.orientation from ego for 20, with blueprint 'static.prop.dirtdebris01'"
    assert run(program("take SetSpeedAction(15)", extra=low), seconds=3).ended_by == "time", "driven over"
    tall = "thing = new Prop following lane.orientation from ego for 20, with blueprint 'static.prop.streetbarrier'"
    assert run(program("take SetSpeedAction(15)", extra=tall), seconds=3).ended_by == "collision"


def test_reasons_of_runs_that_fail(run):
    done = run(program("wait\nwait\ntake undefined_thing"), seconds=2)
    assert done.ended_by == "error" and "at 0.2 s, in B of" in done.reason and "undefined_thing" in done.reason
    done = run(program("wait\ntake SetSpeedAction(9)") + "require always ego.speed < 5\n", seconds=2)
    assert done.ended_by == "rejected" and done.reason
    done = run(program("take SetSpeedAction(9)\nwhile True:\n    x = 1"), seconds=2)
    assert done.ended_by == "error" and "without taking an action" in done.reason


def test_a_seed_gives_the_same_run(run):
    text = program("take SetSpeedAction(Range(5, 20))\ndo AutopilotBehavior()", road=8)
    one, two, three = (run(text, seconds=5, seed=s).recording.paths[0].x for s in (1, 1, 2))
    assert (one == two).all() and not (one == three).all()

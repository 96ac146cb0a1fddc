"""One test for each action, behaviour, light function and class that the installed CARLA model offers.

What is offered is read from the installed package, so that what a later version adds is noticed here.
"""

import re
from importlib import resources

import numpy as np
import pytest
import scenic.simulators.carla.actions as offered
from scenic.core.simulators import Action

pytestmark = pytest.mark.full

ROAD = """
lane = [l for r in network.roads if int(r.id) == {road} for l in r.forwardLanes.lanes][{lane}]
ego = new {kind} following lane.orientation from lane.centerline[0] for {at}, with behavior B(){more}
"""
CAR = ", with blueprint 'vehicle.lincoln.mkz_2017'"
ANYWHERE = ", with regionContainedIn everywhere"
LIT = """
lane = [c.lanes[0] for r in network.roads if int(r.id) == 2 for c in [r.backwardLanes, r.forwardLanes] if c][0]
junction = lane.maneuvers[0].intersection
ego = new Car following lane.orientation from lane.centerline[-1] for -60, with behavior B()
"""
MONITOR = """
monitor Watch():
    {0}
    while True:
        wait
require monitor Watch()
"""


def behave(*lines):
    return "behavior B():\n" + "\n".join("    " + line for line in lines) + "\n"


def car(*lines, road=43, lane=0, at=200, extra=""):
    return behave(*lines) + ROAD.format(kind="Car", road=road, lane=lane, at=at, more=CAR) + extra


def walker(*lines, extra=""):
    return behave(*lines) + ROAD.format(kind="Pedestrian", road=43, lane=0, at=200, more=ANYWHERE) + extra


def turned(path):
    return float(np.unwrap(path.heading)[-1] - path.heading[0])


def moved(path):
    return float(np.hypot(path.x[-1] - path.x[0], path.y[-1] - path.y[0]))


def ends(done):
    """The program's own condition came true."""
    return done.ended_by == "terminated" and done.duration < 2.0


def way(test):
    """A test of ego's way, in a run that goes through."""
    return lambda done: done.ended_by == "time" and bool(test(done.recording.paths[0]))


def fails(part):
    return lambda done: done.ended_by == "error" and part in done.reason


FAST = "take SetSpeedAction(8)"
ACTIONS = {
    "OffsetAction": (car("take OffsetAction(Vector(0, 3))"), way(lambda p: abs(moved(p) - 3) < 0.01)),
    "RegulatedControlAction": (
        car("while True:", "    take RegulatedControlAction(1, 0.05, 0)"),
        way(lambda p: p.speed[-1] > 6 and turned(p) < -0.01),
    ),
    "SetAngularVelocityAction": (car("take SetAngularVelocityAction(1)"), fails("scalarToCarlaVector3D")),
    "SetAutopilotAction": (
        car("take SetAutopilotAction(True, speed=6)", "wait"),
        way(lambda p: abs(p.speed[-1] - 6) < 0.5 and moved(p) > 10),
    ),
    "SetBrakeAction": (car("take SetSpeedAction(15)", "take SetBrakeAction(0.5)"), way(lambda p: p.speed[-1] == 0)),
    "SetGearAction": (
        car("take SetManualGearShiftAction(True)", "take SetGearAction(-1)", "take SetThrottleAction(0.5)"),
        way(lambda p: p.forward[-1] < -1),
    ),
    "SetHandBrakeAction": (car(FAST, "take SetHandBrakeAction(True)"), way(lambda p: p.speed[-1] == 0)),
    "SetJumpAction": (walker("take SetJumpAction(True)", "wait", extra="terminate when ego.elevation > 0.1\n"), ends),
    "SetLocationAction": (
        car("take SetLocationAction(self.position + Vector(0, 5))"), way(lambda p: abs(moved(p) - 5) < 0.01)
    ),
    "SetManualFirstGearShiftAction": (
        car("take SetManualFirstGearShiftAction()", "take SetThrottleAction(0.5)"), way(lambda p: p.forward[-1] > 3)
    ),
    "SetManualGearShiftAction": (
        car("take SetManualGearShiftAction(True)", "wait",
            extra="terminate when ego.carlaActor.get_control().manual_gear_shift\n"),
        ends,
    ),
    "SetPositionAction": (
        car("take SetPositionAction(self.position + Vector(5, 0))"), way(lambda p: abs(moved(p) - 5) < 0.01)
    ),
    "SetReverseAction": (
        car("take SetReverseAction(True), SetThrottleAction(0.5)"), way(lambda p: p.forward[-1] < -2)
    ),
    "SetSpeedAction": (car("take SetSpeedAction(30)"), way(lambda p: abs(p.speed[1] - 30) < 0.2)),
    "SetSteerAction": (car(FAST, "take SetSteerAction(0.3)"), way(lambda p: turned(p) < -0.3)),
    "SetThrottleAction": (car("take SetThrottleAction(1)"), way(lambda p: p.speed[-1] > 12)),
    "SetTrafficLightAction": (
        behave("take SetTrafficLightAction('green', 100)", "wait") + LIT
        + "terminate when getClosestTrafficLightStatus(ego) == 'green' and withinDistanceToTrafficLight(ego, 100)\n",
        ends,
    ),
    "SetTransformAction": (car("take SetTransformAction(self.position, 0)"), fails("Error")),
    "SetVehicleLightStateAction": (
        car("take SetVehicleLightStateAction(2)", "wait",
            extra="terminate when ego.carlaActor.get_light_state() == 2\n"),
        ends,
    ),
    "SetVelocityAction": (
        car("while True:", "    take SetVelocityAction(3, 4)"), way(lambda p: 18 < moved(p) < 20.5)
    ),
    "SetWalkAction": (
        behave("take SetWalkAction(True, 1.2)", "for i in range(25):", "    wait", "take SetWalkAction(False)")
        + "ego = new Pedestrian with behavior B()\n",
        way(lambda p: 1 < moved(p) < 3.5 and p.speed[-1] == 0),
    ),
    "SetWalkingDirectionAction": (
        walker("take SetWalkingDirectionAction(self.heading + 90 deg), SetWalkingSpeedAction(1)"),
        way(lambda p: abs(turned(p) - np.pi / 2) < 0.01),
    ),
    "SetWalkingSpeedAction": (
        walker("take SetWalkingSpeedAction(2)"),
        way(lambda p: p.x[-1] - p.x[0] > 7.5),  # to the east, CARLA's default direction
    ),
    "TrackWaypointsAction": (
        car("pts = [(self.position.x + 5 * i, self.position.y) for i in range(40)]", "while True:",
            "    take TrackWaypointsAction(pts, 8)"),
        way(lambda p: p.x[-1] - p.x[0] > 12 and abs(p.y[-1] - p.y[0]) < 1),
    ),
}  # fmt: skip
TURN = """
behavior B():
    take SetSpeedAction(6)
    do {0}
crossing = [i for i in network.intersections if int(i.id) == 102][0]
m = [m for m in crossing.maneuvers if m.type == ManeuverType.LEFT_TURN][0]
ego = new Car following m.connectingLane.orientation from m.connectingLane.centerline[0] for {1},
    with behavior B(), with regionContainedIn everywhere
"""
BLOCKED = "blocked = new Car following lane.orientation from ego for 40\n"
BEHAVIORS = {
    "AccelerateForwardBehavior": (car("do AccelerateForwardBehavior()"), way(lambda p: p.speed[-1] > 5)),
    "AutopilotBehavior": (car("do AutopilotBehavior()", road=8, at=50), way(lambda p: moved(p) > 10)),
    "ConstantThrottleBehavior": (car("do ConstantThrottleBehavior(0.5)"), way(lambda p: p.speed[-1] > 5)),
    "CrossingBehavior": (
        car(FAST, "do FollowLaneBehavior(8)", road=8, extra="""
behavior C():
    do CrossingBehavior(ego, 1.5, 50)
spot = new OrientedPoint following lane.orientation from ego for 60
ped = new Pedestrian at spot offset by (6, 0), facing 90 deg relative to spot, with regionContainedIn everywhere,
    with behavior C()
"""),
        lambda done: moved(done.recording.paths[1]) > 3 and done.recording.paths[1].speed[:8].max() == 0,
    ),
    "DriveAvoidingCollisions": (
        car("take SetSpeedAction(10)", "do DriveAvoidingCollisions(10, 18)", extra=BLOCKED),
        way(lambda p: p.speed.max() > 5 and p.speed[-1] < 0.5),
    ),
    "FollowLaneBehavior": (
        car("take SetSpeedAction(20)", "do FollowLaneBehavior(20)", road=44),
        way(lambda p: p.speed[1:].min() > 19),
    ),
    "FollowTrajectoryBehavior": (
        TURN.format("FollowTrajectoryBehavior(6, trajectory=[m.connectingLane, m.endLane])", 8),
        way(lambda p: turned(p) > 0.6),
    ),
    "LaneChangeBehavior": (
        car("take SetSpeedAction(25)", "do LaneChangeBehavior(self.laneSection.laneToLeft, target_speed=25)",
            "do FollowLaneBehavior(25)"),
        way(lambda p: 3 < abs(p.y[-1] - p.y[0]) < 4.5),
    ),
    "TurnBehavior": (TURN.format("TurnBehavior([m.connectingLane, m.endLane])", 8), way(lambda p: turned(p) > 0.6)),
    "WalkBehavior": (
        behave("do WalkBehavior(1.2)") + "ego = new Pedestrian with behavior B()\n", way(lambda p: moved(p) > 3)
    ),
    "WalkForwardBehavior": (walker("do WalkForwardBehavior(1.5)"), way(lambda p: 5 < moved(p) < 8)),
}  # fmt: skip
BROKEN = "'utils' is not defined"
"""What Scenic 3.1.1's own functions for a given signal say, in CARLA as here."""
FUNCTIONS = {
    "freezeTrafficLights": (
        behave("wait") + LIT + MONITOR.format("setClosestTrafficLightStatus(ego, 'yellow')\n    freezeTrafficLights()"),
        lambda done: done.recording.lights[-1][0] < 0.2,
    ),
    "unfreezeTrafficLights": (
        behave("wait") + LIT + MONITOR.format(
            "setClosestTrafficLightStatus(ego, 'yellow')\n    freezeTrafficLights()\n    wait\n"
            "    unfreezeTrafficLights()"),
        lambda done: done.recording.lights[-1][0] > 2,
    ),
    "setAllIntersectionTrafficLightsStatus": (
        behave("wait") + LIT + MONITOR.format("setAllIntersectionTrafficLightsStatus(junction, 'red')"), fails(BROKEN)
    ),
    "setTrafficLightStatus": (
        behave("wait") + LIT + MONITOR.format("setTrafficLightStatus(junction.signals[0], 'yellow')"), fails(BROKEN)
    ),
    "getTrafficLightStatus": (
        behave("wait") + LIT + MONITOR.format("getTrafficLightStatus(junction.signals[0])"), fails(BROKEN)
    ),
    "withinDistanceToRedYellowTrafficLight": (
        behave("wait") + LIT + MONITOR.format("setClosestTrafficLightStatus(ego, 'red')")
        + "terminate when withinDistanceToRedYellowTrafficLight(ego, 100)\n",
        ends,
    ),
    "withinDistanceToTrafficLight": (
        behave("wait") + LIT + "terminate when withinDistanceToTrafficLight(ego, 80)"
        " and not withinDistanceToTrafficLight(ego, 20)\n",
        ends,
    ),
    "getClosestTrafficLightStatus": (
        behave("wait") + LIT + "terminate when getClosestTrafficLightStatus(ego) in ('red', 'yellow', 'green')\n", ends
    ),
    "setClosestTrafficLightStatus": (
        behave("wait") + LIT + MONITOR.format("setClosestTrafficLightStatus(ego, 'yellow')")
        + "terminate when getClosestTrafficLightStatus(ego) == 'yellow'\n",
        ends,
    ),
}  # fmt: skip
BASES = {"CarlaActor", "Vehicle", "Prop"}
RIDES = {"Car", "NPCCar", "Bicycle", "Motorcycle", "Truck", "Van", "Bus"}


def source(*parts):
    return resources.files("scenic").joinpath(*parts).read_text(encoding="utf-8")


MODEL = source("simulators", "carla", "model.scenic")


def actions():
    classes = {n: c for n, c in vars(offered).items() if isinstance(c, type) and issubclass(c, Action)}
    return sorted(n for n, c in classes.items() if c.applyTo is not Action.applyTo)


def behaviors():
    library = source("domains", "driving", "behaviors.scenic") + source("simulators", "carla", "behaviors.scenic")
    return sorted(set(re.findall(r"^behavior (\w+)", library, re.M)))


@pytest.mark.parametrize("name", [*actions(), *behaviors(), *re.findall(r"^def ([a-z]\w+)", MODEL, re.M)])
def test_what_is_offered_shows_its_effect(run, name):
    text, shows = (ACTIONS | BEHAVIORS | FUNCTIONS)[name]
    done = run(text, seconds=4.0)
    path = done.recording.paths[0] if done.recording else None
    assert shows(done), (done.ended_by, done.reason, path and (moved(path), turned(path), path.speed[-1]))


@pytest.mark.parametrize("name", [n for n in re.findall(r"^class (\w+)", MODEL, re.M) if n not in BASES])
def test_what_is_offered_stands_or_drives(run, name):
    act = "take SetThrottleAction(0.6)" if name in RIDES else "take SetWalkingSpeedAction(1)"
    behaves = ", with behavior B()" if name in RIDES | {"Pedestrian"} else ""
    done = run(
        behave(act) + "lane = [l for r in network.roads if int(r.id) == 43 for l in r.forwardLanes.lanes][0]\n"
        f"ego = new Car following lane.orientation from lane.centerline[0] for 200\n"
        f"it = new {name} following lane.orientation from ego for 30, with regionContainedIn everywhere{behaves}\n",
        seconds=3.0,
    )
    path = done.recording.paths[1]
    assert done.ended_by == "time", done.reason
    assert (moved(path) > 1.5) is bool(behaves)
    assert path.kind == ("walker" if name == "Pedestrian" else path.kind if name in RIDES else "prop")
    assert 0.02 < path.length < 15 and 0.02 < path.width < 4 and path.blueprint

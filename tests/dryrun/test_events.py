"""Each event on hand-made ways: one that holds, and one that just does not."""

import numpy as np
import pytest

from c2s_engine import driving
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.dryrun.runner import blueprint_classes

STEPS = 201


def ramp(first, last, start, rate, steps=STEPS):
    """A speed that changes from step `start` on with `rate` m/s2."""
    t = np.maximum(0.0, (np.arange(steps) - start) * 0.1)
    change = np.sign(last - first) * np.minimum(abs(last - first), rate * t)
    return first + change


def slide(first, last, start, seconds, steps=STEPS):
    """A distance to the left that changes evenly within some seconds."""
    return np.interp(np.arange(steps), [start, start + seconds * 10], [first, last])


def sides(*points, steps=STEPS):
    """A distance to the left through (step, m) points."""
    return np.interp(np.arange(steps), [p[0] for p in points], [p[1] for p in points])


def ego(t, speed=15.0, start=200.0, road=43, lane=1, **more):
    return t.ride("ego", t.lane(road, lane), start, speed, **more)


def shows(facts, event, name="a", other=None):
    return next(o for o in facts.objects if o.name == name).shows(event, other)


def one(speed, **more):
    return lambda t: [ego(t), t.ride("a", t.lane(43, 2), 300, speed, **more)]


def near(start, aside, speed=15.0, lane=1, road=43, **more):
    return lambda t: [ego(t), t.ride("a", t.lane(road, lane), start, speed, aside, **more)]


def crossing(kind, ego_start=-30.0, speed=8.0, arm=0, steps=STEPS, name="ego"):
    def make(t):
        lanes = t.through(108, kind, arm)
        return t.ride(name, None, t.index.lanes[lanes[0]].length + ego_start, speed, lanes=lanes, steps=steps)

    return make


def arm_of(t, kind, turn):
    """The manoeuvre whose approach is turned by about `turn` (rad) from ego's straight one."""
    base = t.index.lanes[t.through(108, "STRAIGHT", 0)[0]].headings[-1]
    for arm in range(4):
        lanes = t.through(108, kind, arm)
        if abs(np.remainder(t.index.lanes[lanes[0]].headings[-1] - base - turn + np.pi, 2 * np.pi) - np.pi) < 0.3:
            return lanes
    raise AssertionError("no such arm")


def meets(start, speed=8.0, ego_speed=8.0, turn=np.pi / 2):
    """ego goes straight over a crossing, `a` comes from the side."""

    def make(t):
        mine, theirs = t.through(108, "STRAIGHT", 0), arm_of(t, "STRAIGHT", turn)
        return [
            t.ride("ego", None, t.index.lanes[mine[0]].length - 30.0, ego_speed, lanes=mine),
            t.ride("a", None, t.index.lanes[theirs[0]].length + start, speed, lanes=theirs),
        ]

    return make


def walks(start=8.0, speed=1.5, s=260.0, **more):
    return lambda t: [ego(t, 10.0, road=8, lane=0), t.walk("a", t.lane(8, 0), s, start, speed, **more)]


def slow_ego(profile, start=6.0, speed=1.5, s=245.0):
    return lambda t: [ego(t, profile, road=8, lane=0), t.walk("a", t.lane(8, 0), s, start, speed)]


wait_then_go = np.concatenate([ramp(10, 0, 5, 4, 60), ramp(0, 8, 60, 2, 141)])

def slid(turn):
    """A car that moves along its lane turned by so many rad."""

    def make(t):
        lane = t.lane(43, 1)
        return [ego(t), t.ride("a", lane, 300, 8.0, heading=t.index.lanes[lane].heading_at(300) + turn)]

    return make


CASES = {
    "stationary": (one(0.0), one(np.where(np.arange(STEPS) < 8, 1.0, 0.0))),
    "keep_lane": (one(10.0), near(300, slide(0, 3.75, 50, 3))),
    "stop": (one(ramp(10, 0, 20, 3)), one(ramp(10, 0.5, 20, 3))),
    "brake": (one(ramp(15, 12, 20, 1.2)), one(ramp(15, 12, 20, 0.8))),
    "brake_hard": (one(ramp(15, 10, 20, 5)), one(ramp(15, 10, 20, 3.5))),
    "accelerate": (one(ramp(10, 13, 30, 2)), one(ramp(10, 11.8, 30, 2))),
    "slow": (one(8.0), one(14.0)),
    "follow": (near(180, 0.0), near(180, sides((0, 0), (30, 0), (50, 3.75), (200, 3.75)))),
    "approach": (near(240, 0.0, ramp(15, 12, 10, 1)), near(240, 0.0, ramp(15, 14.7, 10, 1))),
    "lane_change": (near(300, slide(0, 3.75, 50, 3)), near(300, slide(0, 1.6, 50, 3))),
    "lane_change_left": (near(300, slide(0, 3.75, 50, 3)), near(300, slide(0, -3.75, 50, 3))),
    "lane_change_right": (near(300, slide(0, -3.75, 50, 3)), near(300, slide(0, 3.75, 50, 3))),
    "cut_in": (near(230, slide(3.75, 0, 50, 3)), near(270, slide(3.75, 0, 50, 3))),
    "cut_out": (near(230, slide(0, 3.75, 50, 3)), near(170, slide(0, 3.75, 50, 3))),
    "overtake": (near(180, 3.75, 18.0), near(180, 3.75, 16.0)),
    "swerve": (near(300, sides((50, 0), (70, 1.3), (100, 0))), near(300, sides((50, 0), (70, 0.9), (100, 0)))),
    "skid": (slid(0.3), slid(0.15)),
    "drift": (near(300, slide(0, 3.75, 50, 6)), near(300, slide(0, 3.75, 50, 2))),
    "cross_path": (meets(-60.0), lambda t: meets(-150.0)(t)),
    "passes_first": (meets(-15.0), meets(-60.0)),
    "yield": (
        lambda t: slow_ego(wait_then_go)(t)[::-1],
        lambda t: slow_ego(8.0, start=10.0)(t)[::-1],
    ),
    "cross_road": (walks(), walks(speed=np.where(np.arange(STEPS) < 20, 1.5, 0.0))),
    "walk_along": (
        lambda t: [ego(t, road=8, lane=0), t.ride("a", t.lane(8, 0), 300, 1.2, -6.0, "walker", size=(0.5, 0.5, 1.8))],
        walks(),
    ),
    "ride_along": (
        lambda t: [ego(t, road=8, lane=0), t.ride("a", t.lane(8, 0), 300, 4.0, -1.0, "bicycle", size=(1.8, 0.6, 1.6))],
        walks(kind="bicycle"),
    ),
    "enter_road": (near(300, slide(-6.0, 0, 30, 4), lane=0), near(300, -5.0, lane=0)),
    "leave_road": (near(300, slide(0, -6.0, 30, 4), lane=0), near(300, slide(0, -1.5, 30, 4), lane=0)),
    "oncoming_intrusion": (
        lambda t: [
            ego(t, road=30, lane=0),
            t.ride("a", t.lane(30, 0), 400, 10, sides((30, 0), (50, 3.5), (90, 3.5), (110, 0))),
        ],
        lambda t: [ego(t, road=30, lane=0), t.ride("a", t.lane(30, -1), 400, 10)],
    ),
    "hits": (
        lambda t: ([ego(t), t.ride("a", t.lane(43, 1), 240, 5.0)], [(3.0, 0, 1)]),
        lambda t: [ego(t), t.ride("a", t.lane(43, 1), 240, 5.0)],
    ),
}


@pytest.mark.parametrize("event", sorted(CASES))
def test_event_holds_and_just_does_not(town, event):
    for make, expected in zip(CASES[event], (True, False), strict=True):
        made = make(town)
        ways, contacts = made if isinstance(made, tuple) else (made, ())
        name = "ego" if event == "yield" else "a"
        assert shows(town.facts(*ways, contacts=contacts), event, name) is expected, (event, expected)


@pytest.mark.parametrize(
    ("kind", "event"), [("LEFT_TURN", "turn_left"), ("RIGHT_TURN", "turn_right"), ("STRAIGHT", "go_straight")]
)
def test_ways_through_an_intersection(town, kind, event):
    facts = town.facts(crossing(kind)(town))
    for other in ("turn_left", "turn_right", "go_straight", "u_turn"):
        assert shows(facts, other, "ego") is (other == event), other
    halted = crossing(kind, speed=np.where(np.arange(STEPS) < 45, 8.0, 0.0))(town)
    assert not shows(town.facts(halted), event, "ego"), "stopped before half of it"


def test_u_turn(town):
    angle = np.clip((np.arange(STEPS) - 40) * 0.06, 0, np.pi)
    base = town.ride("a", town.lane(30, 0), 300, 8.0)
    h = base.heading[0] + angle
    x = base.x[0] + np.cumsum(-np.sin(h)) * 0.5
    y = base.y[0] + np.cumsum(np.cos(h)) * 0.5
    assert shows(town.facts(town.way("a", x, y, h)), "u_turn")
    half = base.heading[0] + np.minimum(angle, 2.3)
    x, y = base.x[0] + np.cumsum(-np.sin(half)) * 0.5, base.y[0] + np.cumsum(np.cos(half)) * 0.5
    assert not shows(town.facts(town.way("a", x, y, half)), "u_turn")


def test_reverse(town):
    back = town.ride("a", town.lane(43, 2), 300, 2.0, against=True, steps=50)
    back.heading += np.pi
    ahead = town.ride("a", town.lane(43, 2), 300, 2.0, against=True, steps=50)
    assert shows(town.facts(ego(town, steps=50), back), "reverse")
    assert not shows(town.facts(ego(town, steps=50), ahead), "reverse")


def test_run_red(town):
    lanes = town.through(102, "STRAIGHT", 0)
    road = town.index.lanes[lanes[0]].road
    car = town.ride("ego", None, town.index.lanes[lanes[0]].length - 40, 8.0, lanes=lanes)
    assert shows(town.facts(car, lights=[(0.0, "102", road, "red")]), "run_red", "ego")
    assert not shows(town.facts(car, lights=[(0.0, "102", road, "red"), (4.0, "102", road, "green")]), "run_red", "ego")
    assert town.facts(car, lights=[(0.0, "102", road, "red"), (4.0, "102", road, "green")]).light == "red"


def test_the_light_that_a_program_sets_in_its_first_step(town):
    lanes = town.through(102, "STRAIGHT", 0)
    road = town.index.lanes[lanes[0]].road
    stands = town.ride("ego", None, town.index.lanes[lanes[0]].length - 12, 0.0, lanes=lanes)
    assert town.facts(stands, lights=[(0.0, "102", road, "green"), (0.1, "102", road, "red")]).light == "red"


def test_run_stop(town):
    control = next(c for c in town.extras.controls if c.kind == "stop" and c.junction == 108)
    arm = next(a for a in range(4) if town.index.lanes[town.through(108, "STRAIGHT", a)[0]].road == str(control.road))
    lanes = town.through(108, "STRAIGHT", arm)
    start = town.index.lanes[lanes[0]].length - 40
    through = town.ride("ego", None, start, 8.0, lanes=lanes)
    stands = np.concatenate([ramp(8, 0, 15, 1.2, 110), ramp(0, 8, 20, 2.0, 91)])
    assert shows(town.facts(through), "run_stop", "ego")
    assert not shows(town.facts(town.ride("ego", None, start, stands, lanes=lanes)), "run_stop", "ego")
    assert "stop_sign" in town.facts(through).infrastructure


def test_motion_counts_up_to_the_first_contact(town):
    car = town.ride("a", town.lane(43, 2), 300, ramp(15, 0, 30, 9))
    assert shows(town.facts(ego(town), car), "brake_hard")
    assert not shows(town.facts(ego(town), car, contacts=[(3.05, 0, 1)]), "brake_hard")


def test_every_event_of_the_table_is_tested():
    elsewhere = {"turn_left", "turn_right", "go_straight", "u_turn", "reverse", "run_red", "run_stop"}
    assert set(CASES) | elsewhere == set(definitions())


@pytest.mark.parametrize("start", [9.0, 5.6, 2.0])
@pytest.mark.parametrize("speed", [0.9, 4.0])
def test_who_crosses_the_lanes_changes_none(town, start, speed):
    """A cyclist who rides over a road of several lanes, from beside it or from one of them."""
    for s in (210.0, 240.0, 190.0):
        rider = town.walk("a", town.lane(43, 1), s, start, speed, kind="bicycle")
        shown = {e.event for e in next(o for o in town.facts(ego(town), rider).objects if o.name == "a").events}
        driven = {"lane_change", "lane_change_left", "lane_change_right", "cut_in", "cut_out", "overtake", "drift"}
        assert not shown & driven, (s, shown & driven)
        assert "cross_road" in shown or start < 8


def test_the_library_s_pickups_are_no_trucks():
    known = {name for name, kind in blueprint_classes().items() if kind == "pickup"}
    assert known == set(driving.constants()["PICKUPS"])

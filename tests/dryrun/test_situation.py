"""Starts, hidden objects, road facts, works, signs, weather and types, on hand-made scenes of the town."""

import numpy as np
import pytest

from c2s_engine.dryrun.events.environment import weather_and_time
from c2s_engine.dryrun.events.kinds import types_of
from tests.dryrun.conftest import HEAD


def start(facts, name="a", other="ego"):
    return next(o for o in facts.objects if o.name == name).starts[other]


def test_relations_lanes_and_gaps_on_the_motorway(town):
    ego = town.ride("ego", town.lane(43, 1), 300, 20.0)
    ahead = start(town.facts(ego, town.ride("a", town.lane(43, 1), 330, 20.0)))
    assert "ahead" in ahead.relations and ahead.lanes == ("same",) and ahead.gap == pytest.approx(25.5, abs=0.1)
    left = start(town.facts(ego, town.ride("a", town.lane(43, 2), 300, 20.0)))
    right = start(town.facts(ego, town.ride("a", town.lane(43, 0), 280, 20.0)))
    assert set(left.lanes) == {"left", "adjacent"} and left.gap == 0
    assert set(right.lanes) == {"right", "adjacent"} and "behind_right" in right.relations


def test_oncoming_crossing_and_beside_the_road(town):
    ego = town.ride("ego", town.lane(30, 0), 300, 10.0)
    other = town.ride("a", town.lane(30, -1), 200, 10.0)
    assert start(town.facts(ego, other)).lanes == ("oncoming",)
    lanes = {arm: town.through(108, "STRAIGHT", arm) for arm in range(4)}
    base = town.index.lanes[lanes[0][0]].headings[-1]
    ego = town.ride("ego", None, 100, 8.0, lanes=lanes[0])
    for arm in (1, 2, 3):
        turn = abs(np.degrees(np.angle(np.exp(1j * (town.index.lanes[lanes[arm][0]].headings[-1] - base)))))
        found = start(town.facts(ego, town.ride("a", None, 100, 8.0, lanes=lanes[arm]))).lanes
        assert ("oncoming" if turn > 135 else "crossing") in found
    ego = town.ride("ego", town.lane(8, 0), 200, 10.0)
    parked = start(town.facts(ego, town.ride("a", town.lane(8, 0), 230, 0.0, -3.0)))
    assert parked.lanes == ("roadside",) and "ahead_right" in parked.relations
    walker = start(town.facts(ego, town.walk("a", town.lane(8, 0), 230, -6.0, 0.0)))
    assert set(walker.lanes) == {"sidewalk", "roadside"}


def test_hidden_behind(town):
    lane = town.lane(8, 0)
    ego = town.ride("ego", lane, 200, 10.0)
    van = town.ride("van", lane, 225, 0.0, -3.0, size=(6.0, 2.4, 2.5))
    low = town.ride("van", lane, 225, 0.0, -3.0, size=(6.0, 2.4, 0.5))
    walker = town.walk("a", lane, 231, -3.6, 0.0)
    assert next(o for o in town.facts(ego, van, walker).objects if o.name == "a").hidden_behind == ("van",)
    assert next(o for o in town.facts(ego, low, walker).objects if o.name == "a").hidden_behind == ()


def test_road_facts(town):
    motorway = town.facts(town.ride("ego", town.lane(43, 1), 300, 20.0)).road
    assert (motorway.lanes_same_direction, motorway.oncoming_lane, motorway.intersection) == (3, False, "none")
    assert motorway.straight and not motorway.curve and motorway.speed_limit_kmh == 130
    rural = town.facts(town.ride("ego", town.lane(30, 0), 300, 20.0)).road
    assert rural.oncoming_lane and rural.lanes_same_direction == 1
    boulevard = town.facts(town.ride("ego", town.lane(3, 0), 100, 5.0)).road
    assert not boulevard.oncoming_lane, "a median lies between"
    bend = next(i for i in town.index.lanes if i.junction is None and np.ptp(np.unwrap(i.headings)) > 0.8)
    at = float(bend.along[np.abs(np.diff(np.unwrap(bend.headings))).argmax()])
    bent = town.facts(town.ride("ego", bend.index, max(1.0, at - 50.0), 10.0)).road
    assert bent.curve and not bent.straight
    lanes = town.through(102, "STRAIGHT", 0)
    end = town.index.lanes[lanes[0]].length
    crossing = town.facts(town.ride("ego", None, end - 60, 8.0, lanes=lanes))
    assert crossing.road.intersection == "4way" and crossing.road.signalized
    assert {"traffic_light", "crosswalk"} <= set(crossing.infrastructure)
    waiting = town.facts(town.ride("ego", None, end - 60, 0.0, lanes=lanes)).road
    assert waiting.intersection == "4way", "a standing ego's path is its lane's continuation"
    assert town.facts(town.ride("ego", None, end - 140, 0.0, lanes=lanes)).road.intersection == "none"


def test_works_and_closures(town):
    lane = town.lane(43, 1)
    ego = town.ride("ego", lane, 300, 10.0)
    cone = "static.prop.constructioncone"
    three = [town.prop(f"c{i}", lane, 360 + 5 * i, 0.0, blueprint=cone) for i in range(3)]
    assert {"cones", "construction_zone", "lane_closure"} <= set(town.facts(ego, *three).temporary)
    two = town.facts(ego, *three[:2]).temporary
    assert "construction_zone" not in two and "cones" in two
    sign = town.prop("s", lane, 340, -5.6, blueprint="static.prop.trafficwarning")
    assert {"construction_zone", "warning_sign"} <= set(town.facts(ego, three[0], sign).temporary)
    edge = town.prop("c", lane, 360, 1.7, blueprint=cone)
    assert "lane_closure" not in town.facts(ego, edge).temporary, "over 2 m are left"
    debris = town.prop("d", lane, 400, blueprint="static.prop.dirtdebris01")
    assert "debris" in town.facts(ego, debris).temporary


def test_sign_props_that_face_ego(town):
    lane = town.lane(30, 0)
    ego = town.ride("ego", lane, 200, 10.0)
    towards = town.index.lanes[lane].headings[0] + np.pi
    for role, name in (("stop_sign", "stop_sign"), ("yield_sign", "yield_sign")):
        assert name in town.facts(ego, town.prop("s", lane, 270, -4.0, role, heading=towards)).infrastructure
        away = town.prop("s", lane, 270, -4.0, role, heading=towards + np.pi)
        assert name not in town.facts(ego, away).infrastructure
    limit = town.prop("s", lane, 270, -4.0, "speed_sign:50", heading=towards)
    assert set(town.facts(ego, limit).speed_limits_kmh) == {100.0, 50.0}
    assert 60.0 in town.facts(ego, speed_limit=60).speed_limits_kmh


@pytest.mark.parametrize(
    ("weather", "expected", "time"),
    [
        ("ClearNoon", {"clear"}, {"day"}),
        ("HardRainNoon", {"cloudy", "wet", "rain", "heavy_rain", "wind"}, {"day"}),
        ("ClearSunset", {"clear"}, {"dawn", "dusk"}),
        ({"sun_altitude_angle": -30.0}, {"clear"}, {"night"}),
        ({"sun_altitude_angle": -5.0, "fog_density": 30.0}, {"fog"}, {"night", "dawn", "dusk"}),
        ({"sun_altitude_angle": 45.0, "fog_density": 29.0, "cloudiness": 30.0}, set(), {"day"}),
    ],
)
def test_weather_and_time(weather, expected, time):
    found = weather_and_time(weather)
    assert (set(found[0]), set(found[1])) == (expected, time)


def test_types(town):
    lane = town.lane(43, 0)
    assert types_of(town.ride("a", lane, 10, 0.0)) == ("car", "vehicle")
    assert types_of(town.walk("a", lane, 10, 0.0, 0.0, role="animal_deer")) == ("animal",)
    assert types_of(town.walk("a", lane, 10, 0.0, 0.0, role="child")) == ("pedestrian", "vru")
    assert types_of(town.ride("a", lane, 10, 0.0, kind="bicycle")) == ("bicycle", "vru")
    assert types_of(town.prop("a", lane, 10)) == ("obstacle",)


WAITS = """behavior Waits():
    try:
        take SetSpeedAction(5)
        while True:
            wait
    interrupt when self.speed > 50:
        take SetBrakeAction(1)
behavior Goes():
    do FollowLaneBehavior(5)
lane = Uniform(*[l for l in network.lanes if l.centerline.length > 200 and l.road])
ego = new Car at lane.centerline.pointAlongBy(20), with name 'ego', with behavior Waits()
other = new Car at lane.centerline.pointAlongBy(60), with name 'other', with behavior Goes()
stands = new Car at lane.centerline.pointAlongBy(100), with name 'stands'
"""


def test_it_is_known_at_which_line_of_the_program_each_behavior_ended(run):
    found = run(WAITS, seconds=2.0)
    lines = (HEAD + WAITS).split("\n")
    assert {name: lines[line - 1].strip() for name, line in found.lines.items()} == {
        "ego": "wait", "other": "do FollowLaneBehavior(5)"
    }  # fmt: skip

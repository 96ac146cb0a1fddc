"""The shipped town: built again byte for byte, clean, and with every place that the vocabulary names."""

import math
import subprocess
import sys

import pytest

from c2s_engine import paths
from c2s_engine.maps.expressions import place_call, survey
from c2s_engine.structure.specs import PlaceSpec
from tests.maps.conftest import places

TOWN = paths.shipped("maps", "town.xodr")


@pytest.mark.full
def test_the_plan_gives_the_same_bytes(tmp_path):
    built = tmp_path / "town.xodr"
    subprocess.run([sys.executable, str(TOWN.parent / "build_town.py"), str(built)], check=True, timeout=120)
    assert built.read_bytes() == TOWN.read_bytes()


def test_it_is_small_and_parses_without_warnings(names):
    assert TOWN.stat().st_size < 600_000
    assert [str(w.message) for w in names["warnings"]] == []


def test_every_place_of_the_survey_is_there(names):
    counts = {name: len(eval(text, names)) for name, text in survey().items()}
    assert [name for name, count in counts.items() if not count] == []


@pytest.mark.parametrize(
    ("fields", "room", "least"),
    [
        ({"kind": "motorway", "lanes": 3, "ego_lane": "middle"}, 1500, 3),
        ({"kind": "straight", "lanes": 2, "oncoming": True, "sidewalk": True, "shoulder": True}, 900, 4),
        ({"kind": "straight", "lanes": 1, "speed_limit": 100 / 3.6}, 1200, 2),
        ({"kind": "straight", "sidewalk": True, "shoulder": True, "speed_limit": 50 / 3.6}, 500, 2),
        ({"kind": "curve", "curve": "left", "speed_limit": 80 / 3.6, "shoulder": True}, 475, 2),
        ({"kind": "curve", "curve": "right", "speed_limit": 80 / 3.6}, 475, 2),
        ({"kind": "straight", "lanes": 3, "oncoming": True}, 1000, 6),
        ({"kind": "straight", "lanes": 2, "oncoming": False, "sidewalk": True}, 400, 2),
        ({"kind": "crosswalk", "lanes": 2}, 150, 2),
        ({"kind": "crosswalk", "oncoming": True}, 150, 6),
        ({"kind": "intersection", "manoeuvre": "u_turn", "arms": 4, "oncoming": True}, 150, 4),
        ({"kind": "intersection", "manoeuvre": "u_turn", "control": "signal", "oncoming": False}, 150, 2),
        ({"kind": "straight", "lanes": 1, "oncoming": True, "speed_limit": 55 * 0.44704}, 1200, 2),
        ({"kind": "straight", "lanes": 2, "oncoming": True, "speed_limit": 55 * 0.44704}, 1200, 4),
        ({"kind": "motorway", "lanes": 2, "speed_limit": 55 * 0.44704}, 1200, 2),
        ({"kind": "motorway", "lanes": 3, "speed_limit": 65 * 0.44704}, 1200, 3),
        ({"kind": "roundabout"}, 150, 4),
        ({"kind": "roundabout", "lanes": 3, "ego_lane": "middle", "oncoming": True, "sidewalk": True}, 500, 2),
        ({"kind": "crosswalk", "lanes": 3, "oncoming": True, "sidewalk": True}, 150, 6),
        ({"kind": "intersection", "lanes": 3, "control": "none", "arms": 4, "oncoming": True}, 500, 4),
        ({"kind": "intersection", "lanes": 3, "control": "none", "manoeuvre": "u_turn", "oncoming": True}, 500, 2),
        ({"kind": "on_ramp"}, 250, 1),
        ({"kind": "off_ramp"}, 500, 1),
    ],
)
def test_long_enough_for_twenty_seconds(names, fields, room, least):
    assert len(places(names, approach=room, length=room, **fields)) >= least


@pytest.mark.parametrize("manoeuvre", ["left", "right", "straight"])
@pytest.mark.parametrize(("control", "lanes"), [("signal", 1), ("signal", 2), ("stop", 1), ("yield", 1), ("none", 1)])
def test_four_way_intersections_have_every_manoeuvre_with_room(names, manoeuvre, control, lanes):
    spec = PlaceSpec(kind="intersection", arms=4, control=control, manoeuvre=manoeuvre, lanes=lanes)
    found = eval(str(place_call(spec, approach=250 if lanes == 2 else 200, exit_room=120)), names)
    assert found and any(place.turn.conflictingManeuvers for place in found)


@pytest.mark.parametrize("control", ["signal", "stop", "yield", "none"])
def test_tees_have_every_control(names, control):
    assert places(names, approach=200, kind="intersection", arms=3, control=control, manoeuvre="left")


def test_ways_join_their_lanes(names):
    """Every connecting lane begins where its lane ends, in its direction, and likewise at the other end."""
    for junction in names["network"].intersections:
        for way in junction.maneuvers:
            line, before, behind = way.connectingLane.centerline, way.startLane.centerline, way.endLane.centerline
            assert math.dist(line.points[0], before.points[-1]) < 0.1
            assert math.dist(line.points[-1], behind.points[0]) < 0.1
            assert abs((line[1] - line[0]).angleWith(before[-1] - before[-2])) < 0.08
            assert abs((line[-1] - line[-2]).angleWith(behind[1] - behind[0])) < 0.08


def test_a_ring_of_lanes_leads_on_lane_by_lane(names, extras):
    """On every lane of the three-lane ring one drives on in the same lane or leaves; every lane of an arm leads in."""
    for junction in (141, 142, 143):
        place = next(i for i in names["network"].intersections if i.id == junction)
        coming = [lane for lane in place.incomingLanes if lane.road.name == "ring"]
        assert len(coming) == 3
        for lane in coming:
            place_in = abs(lane.sections[0].openDriveID)
            onward = [m.endLane for m in lane.maneuvers if m.endLane.road.name == "ring"]
            assert [abs(each.sections[0].openDriveID) for each in onward] == [place_in]
        arm = next(lane for lane in place.incomingLanes if lane.road.name != "ring").road
        entries = [m for lane in place.incomingLanes if lane.road is arm for m in lane.maneuvers]
        exits = [m for lane in coming for m in lane.maneuvers if m.endLane.road is arm]
        assert len(exits) == 3
        assert len(entries) == len({m.endLane for m in entries}) == extras.roads[arm.id].left
        assert all(m.conflictingManeuvers for m in entries)


def test_roads_keep_clear_of_each_other(names):
    import shapely

    roads = names["network"].roads
    tree = shapely.STRtree([road.polygons for road in roads])
    for i, road in enumerate(roads):
        for j in tree.query(road.polygons):
            if j > i:
                assert road.polygons.intersection(roads[j].polygons).area < 0.5, (road.id, roads[j].id)


def test_two_way_roads_know_their_sides(names):
    for road in names["network"].roads:
        if road.forwardLanes and road.backwardLanes:
            assert road.forwardLanes._opposite is road.backwardLanes
            assert road.backwardLanes._opposite is road.forwardLanes
            for group in road.laneGroups:
                ends = [lane.sections[0] for lane in group.lanes]
                assert sum(section._fasterLane is None for section in ends) == 1
                assert sum(section._slowerLane is None for section in ends) == 1


def test_ways_that_turn_round_are_wide_enough_for_cars(names):
    """No three points on a way lie on a circle of less than 5 m."""
    ways = [w for i in names["network"].intersections for w in i.maneuvers if w.type.name == "U_TURN"]
    assert len(ways) >= 8
    for way in ways:
        line = way.connectingLane.centerline.lineString
        points = [line.interpolate(s) for s in range(0, int(line.length) + 1, 2)]
        for a, b, c in zip(points, points[1:], points[2:], strict=False):
            area = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2
            if area > 1e-6:
                assert a.distance(b) * b.distance(c) * c.distance(a) / (4 * area) > 4.9


def test_bends_begin_soon_after_their_lanes(names):
    """A car that starts with the lane is in the bend within 200 m, and has a road before and behind it."""
    found = places(names, kind="curve", oncoming=True)
    assert len(found) >= 10
    for place in found:
        line = place.lane.centerline
        early = line.pointAlongBy(200.5) - line.pointAlongBy(199.5)
        late = line.pointAlongBy(330.5) - line.pointAlongBy(329.5)
        assert abs((line[1] - line[0]).angleWith(late)) > 0.35 or abs(early.angleWith(line[-1] - line[-2])) > 0.2
        assert abs((line[1] - line[0]).angleWith(early)) > 0.001

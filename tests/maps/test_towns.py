"""CARLA's towns as read from their files, against what their XML says to the eye; skipped where they are not there."""

import math
import os
import shutil
from functools import cache
from pathlib import Path

import pytest
import shapely
import yaml

from c2s_engine.maps.expressions import survey
from c2s_engine.maps.extras import MapExtras, read_extras
from tests.maps.conftest import names_on, places

HERE = Path(__file__).parent
FOLDERS = (os.environ.get("C2S_SHARED_MAPS", ""), str(HERE.parents[2] / "shared" / "maps"))
TOWNS = next((Path(folder) for folder in FOLDERS if folder and Path(folder).is_dir()), None)
SAID = yaml.safe_load((HERE / "towns.yaml").read_text())

pytestmark = pytest.mark.skipif(TOWNS is None, reason="CARLA's towns are not in ../shared/maps nor $C2S_SHARED_MAPS")


@cache
def town(name: str) -> MapExtras:
    assert TOWNS is not None
    return read_extras(TOWNS / f"{name}.xodr")


@pytest.mark.parametrize(("name", "junction", "approaches"), SAID["controls"])
def test_what_regulates_an_approach(name, junction, approaches):
    extras = town(name)
    assert set(extras.junctions[junction].incoming) == set(approaches)
    assert {road: extras.control(junction, road) for road in approaches} == approaches


@pytest.mark.parametrize(("name", "road", "x", "y", "length", "width"), SAID["crosswalks"])
def test_where_a_crosswalk_lies_and_how_large_it_is(name, road, x, y, length, width):
    found = [c for c in town(name).crosswalks if c.road == road and math.dist(c.centre, (x, y)) < 1.5]
    assert len(found) == 1
    sides = sorted(math.dist(a, b) for a, b in zip(found[0].polygon, found[0].polygon[1:], strict=False))
    assert abs(sides[-1] - length) < 0.12 * length
    assert 0.8 * width < sides[0] < 1.5 * width


@pytest.mark.parametrize(("name", "count"), SAID["crosswalks_in_all"].items())
def test_no_crosswalk_is_lost(name, count):
    assert len(town(name).crosswalks) == count


@pytest.mark.parametrize(("name", "road", "mph"), SAID["limits"])
def test_limits(name, road, mph):
    assert town(name).limit(road) == pytest.approx(mph * 0.44704)


@pytest.mark.parametrize(("name", "roads"), SAID["motorways"].items())
def test_motorways_are_those_of_several_lanes_that_nobody_crosses(name, roads):
    found = {road.id for road in town(name).roads.values() if road.motorway}
    assert set(roads) <= found
    assert bool(found) == bool(roads)


@pytest.mark.parametrize(("name", "count"), SAID["roundabouts"].items())
def test_roundabouts(name, count):
    assert len(town(name).of_kind("roundabout")) == count


@pytest.mark.parametrize(("name", "junction", "joining", "leaving"), SAID["ramps"])
def test_ramps_are_one_way_roads_that_join_or_leave_without_turning_off(name, junction, joining, leaving):
    info = town(name).junctions[junction]
    assert (list(info.on_ramps), list(info.off_ramps)) == (joining, leaving)


@pytest.fixture(scope="module")
def server():
    from c2s_engine.check.client import SyncCheckClient

    with SyncCheckClient() as client:
        yield client


def counts(server, name, expressions):
    from c2s_engine.check.protocol import PlacesRequest

    report = server.places(PlacesRequest(map=str(TOWNS / f"{name}.xodr"), expressions=expressions))
    assert not report.errors, name
    return report.counts


@pytest.mark.full
@pytest.mark.parametrize("name", SAID["roundabouts"])
def test_places_of_every_town_are_counted(server, name):
    found = counts(server, name, survey())
    assert found["road"] > 30
    assert found["left turn"] > 10
    assert (found["motorway"] > 0) == (name in ("Town04", "Town06"))
    assert (found["4-way intersection, stop signs"] > 0) == (name in ("Town07",))
    assert (found["crosswalk at an intersection"] > 0) == (SAID["crosswalks_in_all"][name] > 0)
    assert found["roundabout"] == 0


@pytest.mark.full
@pytest.mark.parametrize("name", SAID["roundabouts"])
def test_programs_read_the_same_from_a_town_s_file_as_the_engine(server, name):
    extras = town(name)
    limits = {r: round(info.limit, 3) for r, info in extras.roads.items() if info.limit}
    motorways = {r.id for r in extras.roads.values() if r.junction is None and r.motorway}
    signs = {(c.junction, c.road): c.kind for c in extras.controls if c.junction is not None}
    roads = "{road.id for road in network.allRoads}"
    facts = "map_facts()"
    expected = {
        "limits": f"{{(r, round(v, 3)) for r, v in {facts}.limits.items()}} ^ "
        f"{{(r, v) for r, v in {limits}.items() if r in {roads}}}",
        "signs": f"set({facts}.signs.items()) ^ set({signs}.items())",
        "motorways": f"{facts}.motorways ^ {motorways or 'set()'}",
        "intersections": f"{facts}.intersections ^ {extras.of_kind('intersection')}",
        "roundabouts": f"{facts}.roundabouts",
        "on-ramps": f"{facts}.on_ramps ^ {extras.ramps('on_ramp') or 'set()'}",
        "off-ramps": f"{facts}.off_ramps ^ {extras.ramps('off_ramp') or 'set()'}",
        "crosswalks": f"[0] * abs(len({facts}.crosswalks) - {len(extras.crosswalks)})",
    }
    assert counts(server, name, expected) == dict.fromkeys(expected, 0)


@pytest.mark.full
@pytest.mark.parametrize("name", ["Town04", "Town07", "Town10HD"])
def test_the_crosswalk_at_a_junction_is_where_it_is_drawn(name, tmp_path):
    """Also beyond the end of ego's lane, as on these towns; one over another arm is not the one at ego's line."""
    names = names_on(shutil.copy(TOWNS / f"{name}.xodr", tmp_path))
    outlines = [shapely.Polygon(c.polygon) for c in town(name).crosswalks]
    found = places(names, kind="intersection", crosswalk=True)
    assert found
    for lane in (place.lane for place in found):
        spot = names["beside"](lane.centerline, lane, names["crosswalk_of"](lane), 0)
        assert any(outline.contains(shapely.Point(spot.x, spot.y)) for outline in outlines)
        assert names["stop_line"](lane) <= min(names["crosswalk_of"](lane) - 3, lane.centerline.length - 1)

"""CARLA's towns as read from their files, against what their XML says to the eye; skipped where they are not there."""

import math
import os
from functools import cache
from pathlib import Path

import pytest
import yaml

from c2s_engine.maps.expressions import survey
from c2s_engine.maps.extras import MapExtras, read_extras

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


@pytest.mark.full
def test_places_of_every_town_are_counted():
    from c2s_engine.check.client import SyncCheckClient
    from c2s_engine.check.protocol import PlacesRequest

    with SyncCheckClient() as server:
        for name in SAID["roundabouts"]:
            report = server.places(PlacesRequest(map=str(TOWNS / f"{name}.xodr"), expressions=survey(town(name))))
            assert not report.errors, name
            assert report.counts["road"] > 30, name
            assert report.counts["left turn"] > 10, name
            assert (report.counts["motorway"] > 0) == (name in ("Town04", "Town06")), name

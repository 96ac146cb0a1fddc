"""Places as calls of the driving library: each field selects what it says."""

import math
import re
from xml.etree import ElementTree

import pytest

from c2s_engine import paths
from c2s_engine.maps.expressions import place_call, relaxed
from c2s_engine.maps.extras import read_extras
from c2s_engine.structure import vocabulary
from c2s_engine.structure.specs import PlaceSpec
from tests.maps.conftest import names_on, places


@pytest.mark.parametrize("kind", vocabulary.PlaceKind.__args__)
def test_each_kind_has_places_and_a_way_where_one_is_taken(names, kind):
    found = places(names, kind=kind)
    turns = kind in ("intersection", "roundabout", "on_ramp", "off_ramp")
    assert found and all((place.turn is not None) == turns for place in found)
    assert all(place.turn is None or place.turn.startLane is place.lane for place in found)


def test_calls_name_no_road_and_no_junction():
    for kind in vocabulary.PlaceKind.__args__:
        call = place_call(PlaceSpec(kind=kind, lanes=2, oncoming=False, sidewalk=True, speed_limit=10), approach=100)
        assert not re.search(r"\bid\b|network|\{", str(call))
        lines = call.lines("place = Uniform(*", ")", 60)
        assert max(map(len, lines)) <= 60
        assert "".join(line.strip() + " " for line in lines).strip().replace("( ", "(") == f"place = Uniform(*{call})"


def test_curves_bend_to_their_side(names):
    for side, sign in (("left", 1), ("right", -1)):
        for place in places(names, kind="curve", curve=side):
            line = place.lane.centerline
            assert sign * (line[1] - line[0]).angleWith(line[-1] - line[-2]) > 0.35
            assert 0 <= place.mark < place.length


def test_plain_roads_have_both_directions(names):
    for kind in ("road", "straight", "curve"):
        assert all(place.oncoming_lane.group is place.lane.group.opposite for place in places(names, kind=kind))


@pytest.mark.parametrize("ego_lane", ["leftmost", "middle", "rightmost"])
def test_ego_lanes(names, ego_lane):
    for lane in (place.lane for place in places(names, kind="motorway", lanes=3, ego_lane=ego_lane)):
        ordered = sorted(lane.group.lanes, key=lambda each: -abs(each.sections[0].openDriveID))
        at = ordered.index(lane)
        assert {"rightmost": at == 0, "leftmost": at == len(ordered) - 1}.get(
            ego_lane, 0 < at < len(ordered) - 1)  # fmt: skip


def test_oncoming_means_no_divider(names):
    beside, divided = ({place.lane.uid for place in places(names, kind="straight", oncoming=has, lanes=2)}
                       for has in (True, False))  # fmt: skip
    assert beside and divided and not beside & divided
    boulevard = next(road for road in names["network"].roads if road.name == "Boulevard")
    assert {lane.uid for lane in boulevard.lanes} <= divided


def test_limits_select_roads_where_any_has_them(names, extras):
    for place in places(names, kind="road", speed_limit=30 / 3.6):
        assert extras.limit(place.lane.road.id) == pytest.approx(30 / 3.6)
    assert len(places(names, kind="motorway", speed_limit=39.0)) == len(places(names, kind="motorway"))


def test_signs_face_ego(names, extras):
    for control in ("stop", "yield"):
        for place in places(names, kind="intersection", control=control):
            assert extras.control(place.turn.intersection.id, place.lane.road.id) == control


def test_ramps_and_roundabouts_are_no_intersections(names, extras):
    others = extras.of_kind("roundabout", "on_ramp", "off_ramp", "transition")
    for arms in (None, 3, 4):
        for manoeuvre in ("left", "right", "straight"):
            found = places(names, kind="intersection", arms=arms, manoeuvre=manoeuvre)
            assert found and not {place.turn.intersection.id for place in found} & others


def test_what_the_library_reads_from_the_file_is_what_the_engine_reads(names, extras):
    facts = names["map_facts"]()
    roads = {road.id for road in names["network"].allRoads}
    limits = {r: info.limit for r, info in extras.roads.items() if info.limit and r in roads}
    assert facts.limits == pytest.approx(limits)
    assert facts.signs == {(c.junction, c.road): c.kind for c in extras.controls if c.junction is not None}
    assert facts.motorways == {r.id for r in extras.roads.values() if r.junction is None and r.motorway}
    assert facts.intersections == extras.of_kind("intersection") and facts.roundabouts == extras.of_kind("roundabout")
    assert len(facts.crosswalks) == len(extras.crosswalks)
    for crosswalk in extras.crosswalks:
        assert min(math.dist(crosswalk.centre, (o.centroid.x, o.centroid.y)) for o in facts.crosswalks) < 0.3


def test_the_ramp_or_the_motorway_beside_it(names):
    (ramp,) = places(names, kind="on_ramp")
    assert len(ramp.lane.group.lanes) == 1 and ramp.ramp is ramp.lane and ramp.left_lane.road is not ramp.lane.road
    along = places(names, kind="on_ramp", lanes=3)
    assert {place.turn.intersection.id for place in along} == {ramp.turn.intersection.id} and len(along) == 3
    (beside,) = eval("merges('beside')", names)
    assert beside.lane is ramp.left_lane and beside.ramp is ramp.lane
    (leaving,) = places(names, kind="off_ramp")
    assert len(leaving.exit_lane.group.lanes) == 1
    (left,) = eval("exits('beside')", names)
    assert left.right_lane is leaving.lane


def test_crosswalks_have_the_way_free_before_them(names):
    found = places(names, kind="crosswalk", distance=(60, 80), oncoming=True)
    assert found and all(80 < place.mark < place.length - 30 for place in found)


def test_distance_asks_for_an_approach_as_long(names):
    assert all(place.length > 400 for place in places(names, kind="intersection", distance=400))


def test_others_come_from_their_side(names):
    found = eval("junctions(STRAIGHT, arms=4, others=[From('left'), From('right', LEFT_TURN, passed=True)])", names)
    for place in found:
        ahead = place.lane.centerline[-1] - place.lane.centerline[-2]
        for lane, sign in ((place.from_left, -1), (place.from_right, 1)):
            assert math.sin(ahead.angleWith(lane.centerline[-1] - lane.centerline[-2])) * sign > 0.6
        assert place.others[1] is place.from_right and place.right_pocket.road is place.from_right.road
    assert found


def test_those_with_a_sign_give_way_to_ego(names, extras):
    found = eval("junctions(STRAIGHT, others=[From('left', sign='stop')])", names)
    for place in found:
        junction = place.turn.intersection.id
        assert extras.control(junction, place.from_left.road.id) == "stop"
        assert extras.control(junction, place.lane.road.id) != "stop"
    assert found


def test_leaving_a_field_out_gives_more(names):
    spec = PlaceSpec(kind="intersection", arms=3, control="stop", manoeuvre="straight", lanes=2)
    assert places(names, **spec.model_dump(exclude={"component"})) == []
    counts = {name: len(places(names, **other.model_dump(exclude={"component"})))
              for name, other in relaxed(spec).items()}  # fmt: skip
    assert set(counts) == {"arms", "control", "manoeuvre", "lanes"} and counts["control"]


def test_crosswalks_at_stop_lines(names):
    with_, without = (places(names, kind="intersection", crosswalk=has) for has in (True, False))
    every = places(names, kind="intersection")
    assert len(with_) + len(without) == len(every) and with_ and without
    assert {place.turn.intersection.name for place in without} == {"quiet crossing", "rural tee"}


def test_a_fast_city_street_is_no_motorway(tmp_path, extras):
    streets = [info for info in extras.roads.values() if info.sidewalk]
    assert streets and not any(info.motorway for info in streets)
    text = paths.shipped("maps", "town.xodr").read_text()
    path = tmp_path / "fast.xodr"
    path.write_text(
        text.replace('type="motorway"', 'type="town"')
        .replace('max="50.0"', 'max="110"')
        .replace('max="50"', 'max="110"')
    )
    assert {r.id for r in read_extras(path).roads.values() if r.motorway} == {
        r.id for r in extras.roads.values() if r.motorway
    }


@pytest.mark.nightly
def test_lights_are_told_from_signs_on_ways(tmp_path):
    """CARLA's towns refer to stop signs from the ways through junctions, and stock Scenic counts those as signals."""
    tree = ElementTree.parse(paths.shipped("maps", "town.xodr"))
    marks = {each.get("id") for way in tree.findall("road[@junction='101']") for each in way.iter("signalReference")}
    for signal in tree.iter("signal"):
        if signal.get("id") in marks:
            signal.set("type", "206")
            signal.set("name", "stop")
    path = tmp_path / "signs.xodr"
    tree.write(path)
    there = names_on(path)
    lights, stops = ({place.turn.intersection.id for place in places(there, kind="intersection", control=control)}
                     for control in ("signal", "stop"))  # fmt: skip
    assert (lights, stops) == ({102, 103, 104, 105}, {101, 107, 108, 112})

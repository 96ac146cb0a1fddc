"""Places as Scenic code: each field selects what it says."""

import ast
from xml.etree import ElementTree

import pytest
import shapely

from c2s_engine import paths
from c2s_engine.maps.expressions import nearest, place_code, relaxed
from c2s_engine.maps.extras import read_extras
from c2s_engine.structure import vocabulary
from c2s_engine.structure.specs import PlaceSpec


def places(names, extras, room=0.0, **fields):
    code = place_code(PlaceSpec(**fields), extras, room=room)
    return eval(code.expression, dict(names))


@pytest.mark.parametrize("kind", vocabulary.PlaceKind.__args__)
def test_each_kind_yields_what_it_promises(names, extras, kind):
    code = place_code(PlaceSpec(kind=kind), extras)
    has = {"lanes": "sections", "maneuvers": "startLane", "spots": "x"}[code.yields]
    found = eval(code.expression, dict(names))
    assert found and all(hasattr(place, has) for place in found)


def test_expressions_are_one_static_list(extras):
    allowed = {"network", "ManeuverType", "Vector", "len", "any", "abs", "lane", "road", "m", "i", "a", "x"}
    for kind in vocabulary.PlaceKind.__args__:
        for oncoming in (None, True, False):
            text = place_code(
                PlaceSpec(kind=kind, lanes=2, oncoming=oncoming, sidewalk=True), extras, room=100
            ).expression
            tree = ast.parse(text, mode="eval")
            assert isinstance(tree.body, ast.ListComp | ast.List)
            assert {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)} <= allowed


def test_curves_bend_to_their_side(names, extras):
    for side, sign in (("left", 1), ("right", -1)):
        for lane in places(names, extras, kind="curve", curve=side):
            line = lane.centerline
            assert sign * (line[1] - line[0]).angleWith(line[-1] - line[-2]) > 0.35


def test_plain_roads_have_both_directions(names, extras):
    for kind in ("road", "straight", "curve"):
        assert all(lane.group._opposite is not None for lane in places(names, extras, kind=kind))


@pytest.mark.parametrize("ego_lane", ["leftmost", "middle", "rightmost"])
def test_ego_lanes(names, extras, ego_lane):
    for lane in places(names, extras, kind="motorway", lanes=3, ego_lane=ego_lane):
        ordered = sorted(lane.group.lanes, key=lambda each: -abs(each.sections[0].openDriveID))
        place = ordered.index(lane)
        assert {"rightmost": place == 0, "leftmost": place == len(ordered) - 1}.get(
            ego_lane, 0 < place < len(ordered) - 1)  # fmt: skip


def test_oncoming_means_no_divider(names, extras):
    beside = places(names, extras, kind="straight", oncoming=True, lanes=2)
    divided = places(names, extras, kind="straight", oncoming=False, lanes=2)
    assert beside and divided
    assert not {lane.uid for lane in beside} & {lane.uid for lane in divided}
    boulevard = next(road for road in names["network"].roads if road.name == "Boulevard")
    assert set(boulevard.lanes) <= set(divided)


def test_limits_select_roads(names, extras):
    for lane in places(names, extras, kind="road", speed_limit=30 / 3.6):
        assert extras.limit(lane.road.id) == pytest.approx(30 / 3.6)
    missing = place_code(PlaceSpec(kind="road", speed_limit=39.0), extras)
    assert missing.expression == "[]" and "limit" in missing.missing


def test_signs_face_ego(names, extras):
    for control in ("stop", "yield"):
        for way in places(names, extras, kind="intersection", control=control):
            assert extras.control(way.intersection.id, way.startLane.road.id) == control


def test_ramps_and_roundabouts_are_no_intersections(names, extras):
    others = extras.of_kind("roundabout", "on_ramp", "off_ramp", "transition")
    for arms in (None, 3, 4):
        for manoeuvre in ("left", "right", "straight"):
            found = places(names, extras, kind="intersection", arms=arms, manoeuvre=manoeuvre)
            assert found and not {way.intersection.id for way in found} & others


def test_the_ramp_or_the_motorway_beside_it(names, extras):
    (ramp,) = places(names, extras, kind="on_ramp")
    assert len(ramp.startLane.group.lanes) == 1
    beside = places(names, extras, kind="on_ramp", lanes=3)
    assert {way.intersection.id for way in beside} == {ramp.intersection.id}
    assert ramp not in beside and len(beside) == 3
    (leaving,) = places(names, extras, kind="off_ramp")
    assert len(leaving.endLane.group.lanes) == 1


def test_spots_lie_on_lanes_with_the_way_free_before_them(names, extras):
    network = names["network"]
    for spot in places(names, extras, kind="crosswalk", distance=(60, 80), oncoming=True):
        lane = network.laneAt(spot)
        assert lane is not None and network.intersectionAt(spot) is None
        assert lane.centerline.lineString.project(shapely.Point(spot.x, spot.y)) > 80
        assert lane.centerline.distanceTo(spot) < 0.1


def test_distance_asks_for_an_approach_as_long(names, extras):
    for way in places(names, extras, kind="intersection", distance=400):
        assert way.startLane.centerline.length > 400


def test_the_nearest_that_would_do(names, extras):
    spec = PlaceSpec(kind="intersection", arms=3, control="stop", manoeuvre="straight", lanes=2)
    assert places(names, extras, **spec.model_dump(exclude={"component"})) == []
    counts = {name: len(places(names, extras, **other.model_dump(exclude={"component"})))
              for name, other in relaxed(spec).items()}  # fmt: skip
    assert set(counts) == {"arms", "control", "manoeuvre", "lanes"}
    assert "Without control = stop there are" in nearest(spec, counts)


@pytest.mark.parametrize("kind", ["motorway", "on_ramp", "off_ramp", "roundabout", "crosswalk"])
def test_a_map_without_the_place_says_so(tmp_path, kind):
    path = tmp_path / "bare.xodr"
    path.write_text(
        '<OpenDRIVE><header/><road id="1" length="200" junction="-1"><planView><geometry s="0" x="0" y="0" hdg="0" '
        'length="200"><line/></geometry></planView><lanes><laneSection s="0"><center><lane id="0" type="none"/>'
        '</center><right><lane id="-1" type="driving"><width sOffset="0" a="3" b="0" c="0" d="0"/></lane></right>'
        "</laneSection>"
        "</lanes></road></OpenDRIVE>"
    )
    code = place_code(PlaceSpec(kind=kind), read_extras(path))
    assert code.expression == "[]"
    assert code.missing.startswith("The map has no")


def test_crosswalks_at_stop_lines(names, extras):
    with_, without = (places(names, extras, kind="intersection", crosswalk=has) for has in (True, False))
    every = places(names, extras, kind="intersection")
    assert len(with_) + len(without) == len(every) and with_ and without
    assert {way.intersection.name for way in without} == {"quiet crossing", "rural tee"}


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
def test_lights_are_told_from_signs_on_ways(tmp_path, names):
    """CARLA's towns refer to stop signs from the ways through junctions, and stock Scenic counts those as signals."""
    from scenic.domains.driving.roads import Network

    tree = ElementTree.parse(paths.shipped("maps", "town.xodr"))
    marks = {each.get("id") for way in tree.findall("road[@junction='101']") for each in way.iter("signalReference")}
    for signal in tree.iter("signal"):
        if signal.get("id") in marks:
            signal.set("type", "206")
            signal.set("name", "stop")
    path = tmp_path / "signs.xodr"
    tree.write(path)
    network = Network.fromFile(path, useCache=False, writeCache=False)
    found = places({**names, "network": network}, read_extras(path), kind="intersection", control="signal")
    assert {way.intersection.id for way in found} == {102, 103, 104, 105}
    stops = places({**names, "network": network}, read_extras(path), kind="intersection", control="stop")
    assert {way.intersection.id for way in stops} == {101, 107, 108, 112}

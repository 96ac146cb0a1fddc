"""What is read from the map's own file, and what is refused."""

import gzip
import math
import re

import pytest

from c2s_engine import paths
from c2s_engine.maps.extras import read_extras
from c2s_engine.maps.opendrive import BrokenMap, Piece

ROAD = """<road name="A" id="7" length="{length}" junction="-1">
<type s="0" type="town"><speed max="{limit}" unit="{unit}"/></type>
<planView><geometry s="0" x="10" y="20" hdg="0" length="{length}">{shape}</geometry></planView>
<lanes><laneSection s="0"><center><lane id="0" type="none"/></center>
<right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes>
<objects>{objects}</objects></road>"""


def write(folder, body, head=""):
    path = folder / "some.xodr"
    path.write_text(f'<?xml version="1.0"?>{head}<OpenDRIVE><header/>{body}</OpenDRIVE>')
    return path


def road(**fields):
    values = {"length": 100, "limit": 50, "unit": "km/h", "shape": "<line/>", "objects": ""}
    return ROAD.format(**{**values, **fields})


def test_limits_in_their_units(tmp_path):
    for unit, limit in (("km/h", 50 / 3.6), ("mph", 22.352), ("m/s", 50)):
        assert read_extras(write(tmp_path, road(unit=unit))).limit(7) == pytest.approx(limit)


def test_a_changed_file_is_read_again(tmp_path):
    path = write(tmp_path, road())
    before = read_extras(path)
    assert read_extras(path) is before
    write(tmp_path, road(limit=30.25))
    assert read_extras(path).limit(7) == pytest.approx(30.25 / 3.6)


@pytest.mark.parametrize(
    "corners",
    [
        [f'<cornerLocal u="{u}" v="{v}"/>' for u, v in ((-2, -4), (2, -4), (2, 4), (-2, 4), (-2, -4))],
        [f'<cornerRoad s="{s}" t="{t}"/>' for s, t in ((38, -4), (42, -4), (42, 4), (38, 4))],
        [],
    ],
)
def test_crosswalk_outlines_of_every_form(tmp_path, corners):
    outline = f"<outline>{''.join(corners)}</outline>"
    crossing = f'<object type="crosswalk" id="1" s="40" t="0" hdg="0" width="8" length="4">{outline}</object>'
    (crosswalk,) = read_extras(write(tmp_path, road(objects=crossing))).crosswalks
    assert crosswalk.centre == pytest.approx((50, 20))
    assert {(round(x), round(y)) for x, y in crosswalk.polygon} == {(48, 16), (52, 16), (52, 24), (48, 24)}


@pytest.mark.parametrize(
    ("kind", "terms"),
    [("arc", (0.01,)), ("spiral", (0.01, 0.01)), ("line", ()), ("paramPoly3", (0, 50, 0, 0, 0, 0, 20, 0, 1.0))],
)
def test_headings_follow_the_points(kind, terms):
    piece = Piece(0, 3, 4, 0.5, 50, kind, terms)
    assert piece.at(0)[:2] == pytest.approx((3, 4))
    for s in (5, 20, 40):
        (x0, y0, _), (_, _, heading), (x1, y1, _) = piece.at(s - 0.01), piece.at(s), piece.at(s + 0.01)
        assert math.remainder(math.atan2(y1 - y0, x1 - x0) - heading, math.tau) == pytest.approx(0, abs=1e-3)


def test_spiral_ends_where_its_curvature_says():
    begin, end, length = 0.0, 0.02, 60.0
    assert Piece(0, 0, 0, 0, length, "spiral", (begin, end)).at(length)[2] == pytest.approx((begin + end) / 2 * length)


def test_the_town_knows_its_junctions(extras):
    kinds = [junction.kind for junction in extras.junctions.values()]
    assert {kind: kinds.count(kind) for kind in set(kinds)} == {
        "intersection": 13, "roundabout": 7, "on_ramp": 1, "off_ramp": 1, "transition": 1}  # fmt: skip
    controls = {j.name: sorted(str(extras.control(j.id, r)) for r in j.incoming) for j in extras.junctions.values()}
    assert controls["avenues"] == ["signal"] * 4
    assert controls["all-way stop"] == ["stop"] * 4
    assert controls["stop crossing"] == ["None", "None", "stop", "stop"]
    assert controls["priority street"] == ["None", "None", "yield", "yield"]
    assert controls["quiet crossing"] == ["None"] * 4


def test_controls_stand_right_of_the_lane_and_face_it(extras):
    for control in extras.controls:
        road = extras.geometry[control.road]
        x, y, _ = road.at(control.s)
        left = (control.y - y) * math.cos(control.heading) - (control.x - x) * math.sin(control.heading)
        assert left < -3
        assert math.dist((control.x, control.y), (x, y)) < 20


def test_every_road_of_the_town_has_a_limit(extras):
    limits = {round(info.limit * 3.6) for info in extras.roads.values() if info.junction is None}
    miles = {round(mph * 1.609344) for mph in (25, 35, 45, 55, 65)}
    assert limits == {30, 50, 70, 80, 100, 120, 130} | miles


def test_a_roundabout_without_a_mark_is_found_by_its_ring(tmp_path, extras):
    text = paths.shipped("maps", "town.xodr").read_text()
    unmarked, groups = re.subn("<junctionGroup.*?</junctionGroup>", "", text, flags=re.DOTALL)
    assert groups == 2
    path = tmp_path / "unmarked.xodr"
    path.write_text(unmarked)
    assert read_extras(path).of_kind("roundabout") == extras.of_kind("roundabout")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "no well-formed XML"),
        (b"<OpenDRIVE><road>", "no well-formed XML"),
        (b"<html></html>", "no OpenDRIVE map"),
        (b"<OpenDRIVE></OpenDRIVE>", "no roads"),
        (b"\x00\xff\x13", "no well-formed XML"),
        (b'<!DOCTYPE a [<!ENTITY b "x">]><OpenDRIVE>&b;</OpenDRIVE>', "document type or entities"),
        ('<?xml version="1.0" encoding="UTF-16"?><!DOCTYPE a []><OpenDRIVE/>'.encode("utf-16"), "document type"),
        (b'<OpenDRIVE><road id="x" length="1"/></OpenDRIVE>', "should be a number"),
        (b'<OpenDRIVE><road id="1" length="nan" junction="-1"/></OpenDRIVE>', "no geometry"),
        (gzip.compress(b"0" * 5_000_000, mtime=0), "bad.xodr is a compressed file: unpack it"),
        (b"PK\x03\x04" + b"\0" * 60, "bad.xodr is a compressed file: unpack it"),
        (b"<OpenDRIVE>" + b"<a>" * 1000 + b"</a>" * 1000 + b"</OpenDRIVE>", "more elements, or deeper"),
        (f"<OpenDRIVE>{ROAD}</OpenDRIVE>".replace("{length}", "1e12").encode(), "a length that no road has"),
    ],
    ids=range(13),
)
def test_broken_maps_are_refused_in_one_sentence(tmp_path, content, said):
    path = tmp_path / "bad.xodr"
    path.write_bytes(content)
    with pytest.raises(BrokenMap) as refusal:
        read_extras(path)
    assert said in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_too_many_elements_are_refused_before_all_are_read(tmp_path, monkeypatch):
    monkeypatch.setattr("c2s_engine.maps.opendrive.MAX_ELEMENTS", 50)
    with pytest.raises(BrokenMap, match="more elements"):
        read_extras(write(tmp_path, "".join(road() for _ in range(20))))


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(BrokenMap, match="cannot be read"):
        read_extras(tmp_path / "none.xodr")

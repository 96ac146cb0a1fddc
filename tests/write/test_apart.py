"""Nobody starts inside another: what is open is set apart, what is not is refused, and the layout is that of scenes."""

import math

import pytest

from c2s_engine.paths import shipped
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, PlaceSpec
from c2s_engine.write.typed import ResolveError, make_plan
from c2s_engine.write.typed.layout import Draw, boxes, clashes, draws
from c2s_engine.write.typed.spread import spread
from c2s_engine.write.typed.stations import set_back
from c2s_engine.write.typed.tables import WIDTH
from tests.write.closed import outcome


def made(*things: dict, place: dict | None = None, ego: dict | None = None) -> Structure:
    return Structure(
        place=Component(id="R", spec=PlaceSpec.model_validate(place or {"kind": "straight"})),
        ego=Component(id="E", spec=EgoSpec.model_validate(ego or {})),
        objects=tuple(
            Component(id=f"O{i}", spec=ObjectSpec.model_validate({"name": f"one_{i}", **thing}))
            for i, thing in enumerate(things, 1)
        ),
    )


KERB = {"position": "roadside", "side": "left"}
APART = {
    "at the same kerb": [
        {"type": "bus", "placement": {**KERB, "along": "ahead"}},
        {"type": "kiosk", "placement": KERB},
    ],
    "seen from different ones": [
        {"type": "kiosk", "placement": {"position": "parked", "gap": 30}},
        {"type": "truck", "placement": {"position": "ahead", "gap": 20}},
        {"type": "van", "placement": {"position": "roadside", "of": "O2"}},
    ],
    "works beside a bus": [{"type": "lane_closure", "placement": {"position": "beside"}}],
    "works behind a row": [
        {"type": "truck", "count": 3, "placement": {"position": "parked"}},
        {"type": "construction_zone", "placement": {"position": "behind", "of": "O1"}},
    ],
    "into the next lane": [
        {"type": "stop_sign", "placement": {"position": "right_lane", "gap": 40}},
        {"type": "debris", "placement": {"position": "partly_in_lane", "side": "right"}},
    ],
}


@pytest.mark.parametrize("things", APART.values(), ids=APART)
def test_open_gaps_are_set_apart(things):
    found = spread(made(*things, ego={"type": "bus"}))
    assert not clashes(draws(found, make_plan(found)))


def test_gaps_that_were_solved_for_are_set_apart_too():
    """Both are left to ego, which changes lane before them: solved for one by one, they would stand at one spot."""
    ahead = {"placement": {"position": "ahead"}}
    works = [{"type": "construction_zone", **ahead}, {"type": "cone", "count": 2, **ahead}, {"speed": 16.67, **ahead}]
    ego = {"speed": 16.67, "phases": [{"action": "lane_change", "side": "left"}]}
    found = spread(made(*works, place={"kind": "road", "lanes": 2, "ego_lane": "rightmost"}, ego=ego))
    assert not clashes(draws(found, make_plan(found)))


REFUSED = {
    "at one spot": ([{"placement": {"gap": 20}}, {"placement": {"gap": 21}}], {}),
    "ego pulls out there": (
        [{"type": "kiosk", "placement": {"position": "parked", "along": "abreast"}}],
        {"phases": [{"action": "enter_road"}]},
    ),
    "under ego": ([{"type": "van", "placement": {"gap": -3}}], {}),
}


@pytest.mark.parametrize(("things", "ego"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_apart_is_refused_with_its_fields(things, ego):
    with pytest.raises(ResolveError) as refused:
        spread(made(*things, ego=ego))
    assert any(f"O{len(things)}.placement" in field for field in refused.value.fields)


def test_ranges_that_may_be_apart_are_left_as_they_are():
    things = [{"placement": {"gap": 20}}, {"placement": {"gap": (10, 90)}}]
    assert [c.spec.placement.gap for c in spread(made(*things)).objects] == [20, (10, 90)]


def test_rows_take_as_much_lane_as_they_need():
    row = {"type": "truck", "count": 6, "placement": {"position": "beside", "gap": 20}}
    plan = make_plan(made(row, place={"kind": "roundabout"}))
    assert plan.distance is not None and plan.distance > plan.reach > 75
    crossing = {"type": "truck", "count": 4, "placement": {"position": "crossing_left", "gap": 20}}
    assert make_plan(made(crossing, place={"kind": "intersection"})).lengths["place.from_left"] > 50


async def test_what_is_refused_is_a_diagnostic(engine):
    result, _ = await outcome(engine, made({"placement": {"gap": 20}}, {"placement": {"gap": 21}}), run=False)
    assert result.startswith("refused: O2 starts inside O1") and "O2.placement.gap" in result


STANDING = {"speed": 0, "phases": [{"action": "stationary"}]}
SCENES = {
    "ahead": [{**STANDING, "placement": {"gap": 40}}],
    "abreast": [{**STANDING, "placement": {"position": "beside"}}],
    "oncoming": [{**STANDING, "placement": {"position": "oncoming_lane", "gap": 60}}],
    "behind a kiosk": [
        {"type": "kiosk", "placement": {"position": "roadside", "gap": 30}},
        {"type": "child", "placement": {"position": "roadside", "hidden_by": "O1"}},
    ],
    "behind a parked row": [
        {"type": "van", "count": 2, "spacing": 4, "placement": {"position": "parked", "gap": 50}},
        {"type": "box", "placement": {"position": "behind", "of": "O1", "gap": 5}},
    ],
    "on the other side": [{"type": "barrel", "placement": {"position": "sidewalk", "side": "left", "gap": 20}}],
    "in the way": [{"type": "box", "count": 2, "placement": {"position": "partly_in_lane", "side": "left", "gap": 30}}],
}


@pytest.mark.full
@pytest.mark.parametrize("things", SCENES.values(), ids=SCENES)
async def test_the_layout_is_that_of_the_scene(engine, things):
    structure = made(*things, place={"kind": "straight", "lanes": 1, "oncoming": True}, ego={"speed": 0})
    found = spread(structure)
    layout = boxes(found, make_plan(found), Draw(0, 1))
    _, program = await outcome(engine, structure, run=False)
    report = await engine.check(program, upto="run", folder=str(shipped("maps")), trajectories=True)
    at = [(track.x[0], track.y[0]) for track in report.trajectories[0].tracks]
    expected = [math.hypot(box.s, box.y) for row in layout.values() for box in row]
    assert sorted(math.dist(one, at[0]) for one in at) == pytest.approx(sorted(expected), abs=1.0)


@pytest.mark.parametrize(("ego", "blueprint"), [
    ({}, "*DEBRIS"),
    ({"reaction": "brake"}, "platformgarbage01"),
    ({"phases": [{"action": "collide"}]}, "platformgarbage01"),
    ({"reaction": "brake", "react_to": "O2"}, "*DEBRIS"),
])  # fmt: skip
def test_debris_in_the_way_is_nothing_to_drive_over(writer, ego, blueprint):
    structure = made({"type": "debris"}, {"type": "car", "placement": {"position": "left_lane"}}, ego=ego)
    assert blueprint in writer.write(structure, "O1").code


@pytest.mark.parametrize(("action", "further"), [("enter_road", True), ("stationary", False)])
def test_what_stands_by_one_that_pulls_out_is_out_of_its_way(action, further):
    bus = {"type": "bus", "speed": 0.0, "placement": {"position": "parked", "side": "right"},
           "phases": [{"action": "wait"}, {"action": action}]}  # fmt: skip
    stop = {"type": "bus_stop", "placement": {"position": "roadside", "of": "O1", "side": "right", "along": "abreast"}}
    found = spread(made(bus, stop))
    assert (set_back(found, "O2", make_plan(found)) > WIDTH["bus"] / 2) is further

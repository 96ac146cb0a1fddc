"""A text that asks for what cannot be had gets a program and is told what was left open; an edit is refused."""

import pytest

from c2s_engine.session.settle import settle
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, PlaceSpec


def asks(place: PlaceSpec, position: str = "ahead") -> Structure:
    lead = ObjectSpec(name="lead", placement=Placement(position=position))  # type: ignore[arg-type]
    return Structure(
        place=Component(id="R", spec=place),
        ego=Component(id="E", spec=EgoSpec(speed=20.0)),
        objects=(Component(id="O1", spec=lead),),
    )


@pytest.mark.parametrize(
    ("place", "position", "given_up"),
    [
        (PlaceSpec(kind="motorway", ego_lane="leftmost"), "left_lane", {"ego_lane"}),
        (PlaceSpec(kind="motorway", oncoming=True), "ahead", {"oncoming"}),
        (PlaceSpec(kind="straight", speed_limit=3.0), "ahead", set()),  # which the program posts
    ],
)
async def test_the_least_important_field_is_left_open(engine, place, position, given_up):
    structure, found = await settle(
        asks(place, position), engine.library, engine.check_client, given=None, default=None
    )
    assert found.writer is not None
    assert {a.field for a in structure.place.assumed} == given_up


async def test_what_resolves_is_left_alone(engine):
    structure = asks(PlaceSpec(kind="motorway"))
    settled, found = await settle(structure, engine.library, engine.check_client, given=None, default=None)
    assert settled == structure
    assert found.count > 0


async def test_who_is_in_a_lane_that_is_nowhere_comes_into_egos(engine):
    left = Phase(action="turn_left")
    truck = ObjectSpec(name="truck", placement=Placement(position="left_lane"), phases=(left, Phase(action="collide")))
    structure = Structure(
        place=Component(id="R", spec=PlaceSpec(kind="intersection", manoeuvre="left", lanes=2, ego_lane="rightmost")),
        ego=Component(id="E", spec=EgoSpec(speed=8.0, phases=(left,))),
        objects=(Component(id="O1", spec=truck),),
    )
    settled, found = await settle(structure, engine.library, engine.check_client, given=None, default=None)
    assert found.writer is not None
    assert settled["O1"].spec.placement.position == "ahead"
    assert [u.text for u in settled["O1"].unmet] == ["truck: left lane"]


async def test_a_gap_by_which_one_starts_inside_another_is_left_open(engine):
    one, two = (ObjectSpec(name=f"car_{gap}", placement=Placement(position="ahead", gap=gap)) for gap in (30, 31))
    structure = asks(PlaceSpec(kind="road")).model_copy(
        update={"objects": (Component(id="O1", spec=one), Component(id="O2", spec=two))}
    )
    settled, found = await settle(structure, engine.library, engine.check_client, given=None, default=None)
    assert found.writer is not None
    (note,) = settled["O2"].assumed
    assert note.field == "placement.gap" and "31 m" in note.reason and "inside" in note.reason
    assert settled["O1"] == structure["O1"]

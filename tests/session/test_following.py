"""What an edit of one field leaves another saying follows, and is said; a program by hand is never touched by that."""

import pytest

from c2s_engine.session.sessions import Sessions
from c2s_engine.session.with_consequences import with_consequences
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.edits import SetField, apply
from c2s_engine.structure.progress import Say
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, PlaceSpec


def scene(*phases, **place):
    at = {"position": "right_lane", "along": "ahead"}
    lorry = ObjectSpec(name="lorry", type="truck", placement=at, phases=phases)
    found = Structure(text="A lorry.", objects=(Component(id="O1", spec=lorry),))
    return found.with_component(found.place.model_copy(update={"spec": PlaceSpec(kind="motorway", **place)}))


LEFT = SetField(component="O1", path="placement.position", value="left_lane")


def test_who_cuts_in_from_the_other_lane_cuts_in_the_other_way():
    before = scene(Phase(action="keep_lane"), Phase(action="cut_in", side="left", target="ego"))
    after, said = with_consequences(before, apply(before, LEFT))
    assert [p.side for p in after["O1"].spec.phases] == [None, "right"]
    assert said == ["O1 (lorry) cuts in to the right from there."]
    assert with_consequences(before, apply(before, SetField(component="O1", path="speed", value=20.0)))[1] == []


def test_a_side_that_is_told_stays():
    before = scene(Phase(action="cut_in", side="left", target="ego"))
    told = apply(before, SetField(component="O1", path="phases", value=[{"action": "lane_change", "side": "left"}]))
    after, said = with_consequences(before, apply(told, LEFT))
    assert after["O1"].spec.phases[0].side == "left" and not said


@pytest.mark.parametrize(("lanes", "open_now"), [(2, True), (1, True), (4, False)])
def test_of_two_lanes_none_is_the_middle_one(lanes, open_now):
    before = scene(lanes=3, ego_lane="middle")
    after, said = with_consequences(before, apply(before, SetField(component="R", path="lanes", value=lanes)))
    assert (after.place.spec.ego_lane is None) is open_now is bool(said)


async def test_in_a_session_it_is_said_and_written(engine, tmp_path):
    session = Sessions(tmp_path).open("one", engine)
    try:
        text = "On a motorway with three lanes ego drives in the middle lane. A lorry in the right lane cuts in."
        [e async for e in session.say(text, run=False)]
        events = [e async for e in session.say("put a car with hazard lights on the shoulder 150 m ahead", run=False)]
        events = [e async for e in session.say("move the lorry to the left lane", run=False)]
        assert any(isinstance(e, Say) and "cuts in to the right from there" in e.text for e in events)
        assert "new Truck at place.left_lane" in session.structure["O1"].code
        [e async for e in session.say("the road has only two lanes", run=False)]
        assert "lanes=2" in session.structure.place.code and session.structure.place.spec.ego_lane is None
    finally:
        session.close()


def test_what_somebody_does_is_as_fast_as_is_said_of_it_now():
    before = scene(Phase(action="lane_change", side="left", speed=15.0), Phase(action="keep_lane"))
    after, said = with_consequences(before, apply(before, SetField(component="O1", path="speed", value=10.0)))
    assert after["O1"].spec.phases[0].speed is None and after["O1"].spec.speed == 10.0
    assert said == ["O1 (lorry): its first phase takes the new speed, too (was 54 km/h)."]
    two = scene(Phase(action="lane_change", side="left", speed=15.0), Phase(action="brake", speed=5.0))
    assert with_consequences(two, apply(two, SetField(component="O1", path="speed", value=10.0)))[1] == []


def test_who_gives_way_no_more_has_no_phase_of_giving_way():
    ego = EgoSpec(speed=8.0, reaction="yield", react_to="O1", phases=(
        Phase(action="yield", target="O1"), Phase(action="start"), Phase(action="turn_left")))  # fmt: skip
    before = scene().with_component(Component(id="E", spec=ego))
    after, said = with_consequences(before, apply(before, SetField(component="E", path="reaction", value="none")))
    assert [p.action for p in after.ego.spec.phases] == ["turn_left"] and "no longer gives way" in said[0]

"""By how much one is too early or too late for what is required: another run, moved by so much, shows it."""

import math
from dataclasses import replace

import pytest
from roads import Actor, Scene, ramp

from c2s_engine.require import evaluate, require
from c2s_engine.require.due import to_touch
from c2s_engine.require.evidence import Evidence
from c2s_engine.require.geometry import face
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import EventFact
from c2s_engine.structure.requirements import Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, Trigger

EGO = Actor("ego", "E", speed=10.0)
CROSSES = Actor("van", "O1", speed=8.0, x=-64.0, y=80.0, across=True)
"""At ego's lane at 8 s, as ego is."""
COLLIDES = ObjectSpec(placement=Placement(position="crossing_left"), phases=(Phase(action="collide"),))
LEAD = Component(id="O1", spec=ObjectSpec(name="lead", placement=Placement(position="ahead")))
RUNS_RED = ObjectSpec(placement=Placement(position="crossing_left"), phases=(Phase(action="run_red"),))


def result(spec: ObjectSpec, late: float, check: str) -> Result:
    """What a run shows in which the other comes `late` s after ego."""
    run = Scene([EGO, replace(CROSSES, x=CROSSES.x - 8.0 * late)]).run()
    required = [r for r in require(Structure(objects=(Component(id="O1", spec=spec),))) if r.check == check]
    return evaluate(required, run.facts, run.trajectories)[0]


@pytest.mark.parametrize(("spec", "check"), [(COLLIDES, "contact"), (RUNS_RED, "threatens")])
@pytest.mark.parametrize("late", [-2.5, 2.5])
def test_who_comes_too_early_or_too_late_to_meet_is_told_by_how_much(spec, check, late):
    missed = result(spec, late, check)
    assert missed.holds is False and missed.due is not None
    assert missed.due == pytest.approx(-late, abs=0.7)  # the nearest time at which they meet, and a little inside
    run = Scene([EGO, replace(CROSSES, x=CROSSES.x - 8.0 * (late + missed.due))]).run()
    one, other = (Evidence(run.facts, run.trajectories).motion(a) for a in ("O1", "ego"))
    assert float(min(abs(one.x - other.x) + abs(one.y - other.y))) < 4.0


def test_ways_that_do_not_meet_have_no_time_at_which_they_would():
    run = Scene([EGO, Actor("van", "O1", x=12.0, y=30.0)]).run()
    required = [r for r in require(Structure(objects=(Component(id="O1", spec=COLLIDES),))) if r.check == "contact"]
    (found,) = evaluate(required, run.facts, run.trajectories)
    assert found.holds is False and found.due is None


@pytest.mark.parametrize(("part", "other_part", "late"), [("front", "right", 0.3), ("right", "front", -0.3)])
def test_another_part_touches_where_one_comes_later_or_earlier(part, other_part, late):
    """The van that is there late strikes ego with its front; early it is struck in the side that ego comes to."""
    run = Scene([EGO, replace(CROSSES, x=CROSSES.x - 8.0 * late)], seconds=7.5).run()
    van, ego = (Evidence(run.facts, run.trajectories).motion(a) for a in ("O1", "ego"))
    as_it_is = to_touch(van, ego, lambda own, _: face(own, van.size) == part)
    assert as_it_is is not None and abs(as_it_is) <= 0.1
    moved = to_touch(van, ego, lambda own, _: face(own, van.size) == other_part)
    assert moved is not None and moved * late < 0


@pytest.mark.parametrize(("late", "holds"), [(1.0, True), (1.9, False), (0.1, False)])
def test_a_stated_arrival_where_ways_meet_is_measured(late, holds):
    spec = ObjectSpec(placement=Placement(position="crossing_left", arrives=1.0))
    found = result(spec, late, "arrives_where_ways_meet")
    assert found.holds is holds and found.value == pytest.approx(late, abs=0.3)
    assert (found.due is None) is holds


@pytest.mark.parametrize(("late", "holds"), [(0.0, True), (0.3, True), (-1.5, False), (1.5, False)])
def test_who_comes_towards_ego_is_level_with_another_as_ego_comes_up_to_that_one(late, holds):
    """Ego comes up to the bicycle, 42 m ahead of it at 4 m/s, after 6.4 s."""
    bicycle = ObjectSpec(name="rider", type="bicycle", placement=Placement(position="ahead"))
    coming = ObjectSpec(placement=Placement(position="oncoming_lane", of="O1", arrives=0.0))
    rider = Actor("rider", "O1", speed=4.0, y=42.0, kind="bicycle")
    met = 42.0 + 4.0 * (6.4 + late) + 4.5
    oncoming = Actor("van", "O2", speed=-10.0, x=-3.5, y=met + 10.0 * (6.4 + late), heading=math.pi)
    run = Scene([EGO, rider, oncoming], seconds=9.0).run()
    of = Structure(objects=(Component(id="O1", spec=bicycle), Component(id="O2", spec=coming)))
    (found,) = evaluate([r for r in require(of) if r.check == "arrives_beside"], run.facts, run.trajectories)
    assert found.holds is holds and found.value == pytest.approx(late, abs=0.2)


def test_of_two_that_are_said_to_touch_no_other_moment_is_required():
    said = COLLIDES.model_copy(update={"placement": Placement(position="crossing_left", arrives=0.0)})
    asked = {r.check for r in require(Structure(objects=(Component(id="O1", spec=said),)))}
    assert "contact" in asked and not {c for c in asked if c.startswith("arrives")}


@pytest.mark.parametrize(("gap", "holds"), [(30.0, True), (90.0, False)])
@pytest.mark.parametrize("kind", ["distance", "ttc"])
def test_how_near_is_near_is_left_to_the_run_where_s_does_not_say(gap, holds, kind):
    """Another leaves its lane 2 s after the start, with ego so far from what stands ahead."""
    trigger = Trigger(kind=kind, subject="ego", of="O1")
    leaves = Phase(action="lane_change", trigger=trigger)
    beside = ObjectSpec(placement=Placement(position="left_lane"), phases=(leaves,))
    asked = Structure(objects=(LEAD, Component(id="O2", spec=beside)))
    moves = ramp((0, -3.5), (2, -3.5), (4, -7), (12, -7))
    other = Actor("van", "O2", x=moves, y=10.0, events=(EventFact(time=3.0, event="lane_change"),))
    run = Scene([EGO, Actor("lead", "O1", speed=0.0, y=gap + 24.5), other]).run()
    required = require(asked)
    results = evaluate(required, run.facts, run.trajectories)
    found = next(r for q, r in zip(required, results, strict=True) if q.check == "begins_when")
    assert found.holds is holds


@pytest.mark.parametrize("behind", [0.0, 12.0])
def test_who_comes_over_behind_whom_it_is_to_come_in_front_of_is_told_by_how_much(behind):
    moves = ramp((0, 0), (3, 0), (5, -3.5), (12, -3.5))
    other = Actor("van", "O1", speed=10.0, x=-3.5, y=behind)
    run = Scene([Actor("ego", "E", speed=10.0, x=moves), other]).run()
    cuts_in = Component(id="E", spec=EgoSpec(phases=(Phase(action="cut_in", target="O1"),)))
    beside = Component(id="O1", spec=ObjectSpec(placement=Placement(position="left_lane")))
    asked = Structure(ego=cuts_in, objects=(beside,))
    required = [r for r in require(asked) if r.check == "shown"]
    missed = evaluate(required, run.facts, run.trajectories)[0]
    assert missed.holds is False
    assert missed.due == pytest.approx(-(behind + 4.5 + 4) / 10, abs=0.05)  # a car and 4 m ahead

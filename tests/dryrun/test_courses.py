"""Where each object is on the road, what ego can see of it, and which parts touch: on the town's real roads."""

import numpy as np
import pytest
from test_events import arm_of, ramp

from c2s_engine.dryrun.events.derivation import with_courses
from c2s_engine.dryrun.recording import Recording
from tests.dryrun.conftest import DT

STEPS = 201


def seen(town, *ways, contacts=()):
    return with_courses(Recording(DT, list(ways), list(contacts), [], {}), town.index, town.extras)


def motorway(town):
    """A lane with lanes of its direction on both sides."""
    return next(i.index for i in town.index.lanes if i.left and i.right and i.length > 250)


def test_a_lane_change_shows_in_stays_and_aside(town):
    lane = motorway(town)
    aside = np.clip(np.arange(STEPS) * 0.1 - 5.0, 0.0, 3.5)
    _, found = seen(town, town.ride("ego", lane, 10, 10.0), town.ride("a", lane, 40, 10.0, aside=aside))
    course = found["a"]
    assert [s.to_ego for s in course.stays] == ["own", "left"] and not any(s.against for s in course.stays)
    assert course.aside[0] == pytest.approx(0.0, abs=0.1) and course.aside[-1] == pytest.approx(3.5, abs=0.2)
    assert course.ego_along[0] - found["ego"].along[0] == pytest.approx(30.0, abs=0.5)


@pytest.mark.parametrize(("side", "sign"), [("left", 1.0), ("right", -1.0)])
def test_neighbouring_lanes_lie_to_their_sides(town, side, sign):
    lane = motorway(town)
    _, found = seen(town, town.ride("ego", lane, 10, 10.0), town.ride("a", lane, 20, 10.0, aside=3.5 * sign))
    assert [s.to_ego for s in found["a"].stays] == [side]
    assert found["a"].ego_aside[5] == pytest.approx(3.5 * sign, abs=0.3)


def test_a_way_has_its_junction_with_the_line_before_it(town):
    mine = town.through(108, "STRAIGHT", 0)
    start = town.index.lanes[mine[0]].length - 40
    _, found = seen(town, town.ride("ego", None, start, 8.0, lanes=mine))
    marks = found["ego"].marks
    line = next(m for m in marks if m.kind == "line" and m.name.startswith("108/"))
    junction = next(m for m in marks if m.kind == "junction" and m.name == "108")
    assert 0 <= junction.start - line.start < 12  # before the crosswalk, where there is one
    assert junction.start < junction.end
    assert junction.start - found["ego"].along[0] == pytest.approx(40.0, abs=1.0)
    assert [s.kind for s in found["ego"].stays][:2] == ["lane", "junction"]


def test_who_comes_from_the_side_crosses_egos_way(town):
    mine, theirs = town.through(108, "STRAIGHT", 0), arm_of(town, "STRAIGHT", np.pi / 2)
    ego = town.ride("ego", None, town.index.lanes[mine[0]].length - 30, 8.0, lanes=mine)
    other = town.ride("a", None, town.index.lanes[theirs[0]].length - 30, 8.0, lanes=theirs)
    _, found = seen(town, ego, other)
    assert found["a"].stays[0].to_ego == "crossing"


@pytest.mark.parametrize(("between", "hidden"), [(30.0, True), (60.0, False)])
def test_a_truck_between_takes_the_sight(town, between, hidden):
    lane, still = motorway(town), {"speed": 0.0}
    truck = town.ride("truck", lane, 10 + between, 0.0, kind="truck", size=(10.0, 2.5, 3.2))
    _, found = seen(town, town.ride("ego", lane, 10, **still), truck, town.walk("a", lane, 55.0, 0.0, 0.0))
    assert found["a"].sight == ((0.0, not hidden),)


def test_a_low_thing_takes_no_sight(town):
    lane = motorway(town)
    _, found = seen(town, town.ride("ego", lane, 10, 0.0), town.prop("box", lane, 40), town.walk("a", lane, 55, 0, 0))
    assert found["a"].sight == ((0.0, True),)


@pytest.mark.parametrize(("aside", "parts"), [(0.0, ("front", "rear")), (2.05, ("left", "right"))])
def test_the_parts_that_touch(town, aside, parts):
    lane = motorway(town)
    ahead = 50 + 4.55 if not aside else 50
    ways = town.ride("ego", lane, 10, ramp(8.0, 0, 50, 100)), town.ride("a", lane, ahead, 0.0, aside=aside)
    facts, _ = seen(town, *ways, contacts=[(5.0, 0, 1)])
    assert [(c.part_one, c.part_other) for c in facts.contacts] == [parts]
    assert facts.contacts[0].time == 5.0 and facts.contacts[0].closing > 5.0


def test_a_course_ends_at_the_first_contact_and_is_small(town):
    lane = motorway(town)
    ways = town.ride("ego", lane, 10, 8.0), town.ride("a", lane, 54, 0.0)
    _, found = seen(town, *ways, contacts=[(5.0, 0, 1)])
    assert len(found["ego"].along) == pytest.approx(26, abs=1)
    assert sum(len(c.model_dump_json()) for c in found.values()) < 4000

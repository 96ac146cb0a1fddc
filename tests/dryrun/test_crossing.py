"""Where paths cross: each part of the definitions of cross_path and yield, and of closed lanes, from both sides."""

import numpy as np
import pytest
from test_events import arm_of, ramp, shows

STEPS = 201
CONE = "static.prop.constructioncone"


def halts(distance, speed=8.0, rate=4.0, again=None):
    """A speed profile that comes to a stand after some metres, and drives on at a time (s)."""
    start = (distance - speed**2 / (2 * rate)) / (0.1 * speed)
    down = ramp(speed, 0, start, rate)
    return down if again is None else down + ramp(0, speed, 10 * again, 2.0)


def crossing(t, ego, a, before=30.0, start=30.0, turn=np.pi / 2):
    """ego goes straight over a crossing, `a` comes from the side: m before the junction, and the speeds by step."""
    mine, theirs = t.through(108, "STRAIGHT", 0), arm_of(t, "STRAIGHT", turn)
    return t.facts(
        t.ride("ego", None, t.index.lanes[mine[0]].length - before, ego, lanes=mine),
        t.ride("a", None, t.index.lanes[theirs[0]].length - start, a, lanes=theirs),
    )


@pytest.mark.parametrize(("apart", "expected"), [(9, True), (11, False)])
def test_paths_cross_within_ten_seconds(town, apart, expected):
    assert shows(crossing(town, 8.0, 8.0, start=30 + 8 * apart), "cross_path", "a", "ego") is expected


@pytest.mark.parametrize(
    ("missing", "reaches", "near"), [(-12, True, True), (3, False, True), (30, False, False)], ids=str
)
def test_who_is_halted_before_the_crossing_was_there_only_with_its_body(town, missing, reaches, near):
    """m to the junction; the other crosses the way of who waits near it."""
    facts = crossing(town, 8.0, halts(60 - missing), start=60)
    assert shows(facts, "cross_path", "a", "ego") is reaches
    assert shows(facts, "cross_path", "ego", "a") is near
    expected = near
    assert not shows(facts, "passes_first", "a", "ego")
    assert shows(facts, "passes_first", "ego", "a") is expected


def test_who_has_not_come_and_stands_only_later_was_not_there(town):
    late = halts(147)
    facts = crossing(town, 8.0, late, start=150)
    stands = float(np.flatnonzero(late < 0.2)[0]) / 10
    assert stands > 17 and not shows(facts, "cross_path", "a", "ego"), "ego was through over 10 s before"


@pytest.mark.parametrize("before", np.arange(2.0, 7.5, 0.6))
def test_who_stands_from_the_start_is_halted_too(town, before):
    facts = crossing(town, 0.0, 8.0, before=before)
    assert shows(facts, "cross_path", "a", "ego") and shows(facts, "passes_first", "a", "ego")


def test_yielding_by_a_stop(town):
    facts = crossing(town, halts(27, again=12), 8.0, start=70)
    assert shows(facts, "yield", "ego", "a") and not shows(facts, "yield", "a", "ego")


@pytest.mark.parametrize(("low", "expected"), [(5.0, True), (7.0, False)])
def test_yielding_by_slowing(town, low, expected):
    """8 m/s to 5 (or just to 7) and on again once the other, who is first, is through."""
    speed = ramp(8, low, 5, 2.0) + ramp(0, 8 - low, 60, 2.0)
    facts = crossing(town, speed, 12.0, before=20)
    assert shows(facts, "passes_first", "a", "ego")
    assert shows(facts, "yield", "ego", "a") is expected


def test_still_waiting_at_the_end_for_who_comes(town):
    first = crossing(town, halts(27), 4.0, start=40)
    there = next(e.time for o in first.objects if o.name == "a" for e in o.events if e.event == "passes_first")
    comes = crossing(town, halts(27), 4.0, start=40 + 4 * (19.8 - there))
    assert shows(comes, "yield", "ego", "a")
    gone = crossing(town, halts(27), 8.0, start=40)
    assert not shows(gone, "yield", "ego", "a"), "the other is long through, and it does not go on"


def test_waiting_for_nobody_is_no_yielding(town):
    both = crossing(town, halts(27), halts(27))
    assert not shows(both, "yield", "ego", "a") and not shows(both, "yield", "a", "ego")


def test_who_passes_first_does_not_yield(town):
    facts = crossing(town, halts(75, rate=6.0), 4.0, start=60)
    assert shows(facts, "passes_first", "ego", "a") and not shows(facts, "yield", "ego", "a")


@pytest.mark.parametrize(("at", "aside", "expected"), [
    (360, 0.0, True), (360, 0.4, True), (360, 0.55, False), (360, 1.7, False),  # 0.7 m of 3.75 m are taken
    (290, 0.0, False),  # behind ego's start
    (700, 0.0, False),  # where it does not come
])  # fmt: skip
def test_a_lane_is_closed_where_less_than_two_metres_are_left(town, at, aside, expected):
    ego = town.ride("ego", town.lane(43, 1), 300, 10.0)
    cone = town.prop("c", town.lane(43, 1), at, aside, blueprint="static.prop.streetbarrier")
    assert ("lane_closure" in town.facts(ego, cone).temporary) is expected


def test_any_lane_of_egos_direction_may_be_closed(town):
    ego = town.ride("ego", town.lane(43, 0), 300, 10.0)
    barrier = town.prop("c", town.lane(43, 2), 360, 0.0, blueprint="static.prop.streetbarrier")
    assert "lane_closure" in town.facts(ego, barrier).temporary


@pytest.mark.parametrize(("gap", "expected"), [(2.5, True), (6.0, False)])
def test_obstacles_bar_a_lane_together_only_abreast(town, gap, expected):
    lane = town.lane(43, 1)
    pair = [town.prop("l", lane, 360, 1.3, blueprint=CONE), town.prop("r", lane, 360 + gap, -1.3, blueprint=CONE)]
    ego = town.ride("ego", lane, 300, 10.0)
    assert "lane_closure" not in town.facts(ego, *pair[:1]).temporary
    assert ("lane_closure" in town.facts(ego, *pair).temporary) is expected


@pytest.mark.parametrize(("step", "expected"), [(14, True), (20, False)])
def test_a_construction_zone_needs_three_within_thirty_metres_of_each_other(town, step, expected):
    lane = town.lane(43, 1)
    three = [town.prop(f"c{i}", lane, 340 + step * i, -3.0, blueprint=CONE) for i in range(3)]
    ego = town.ride("ego", lane, 300, 10.0)
    assert ("construction_zone" in town.facts(ego, *three).temporary) is expected

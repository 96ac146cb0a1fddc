"""The scorer: facts that are wrong in one thing lose exactly the atoms of that thing."""

import pytest
from bench_scenes import record, run, thing

from c2s_bench.records import load
from c2s_bench.scorer import score, totals
from c2s_engine.structure.facts import EGO, RoadFacts, StartFact

EXPECT = """
road: {lanes_same_direction: {min: 2}, intersection: none}
infrastructure: [{is: speed_limit, kmh: 50}]
ego: {does: [{follow: lead}], speed_kmh: [40, 60]}
actors:
  - {as: lead, type: car, starts: {relation: ahead, lane: same, gap_m: [10, 40]}, does: [brake_hard]}
  - {as: cutter, type: [van, truck], starts: {relation: ahead, lane: left}, does: [cut_in]}
environment: {weather: rain, time: night}
"""
GOOD_LEAD = thing("lead", does=("brake_hard",), ahead_of_ego=("ahead", "same", 20.0))
GOOD_CUTTER = thing("other", "van", does=("cut_in",), ahead_of_ego=("ahead", "left", 30.0))
GOOD_EGO = thing(EGO, does=(("follow", "lead"),), held_speed=14.0)
SCENE = {
    "road": RoadFacts(lanes_same_direction=3),
    "speed_limits_kmh": (48.5,),
    "weather": ("rain", "wet"),
    "time": ("night",),
}


def lost(facts, expect=EXPECT):
    """The atoms that a program with those facts (of one rollout) loses."""
    return {a.atom for a in score(record(expect), [facts], 1).atoms if a.counts and not a.holds}


def good(*objects, ego=GOOD_EGO, **more):
    return run(*objects, ego=ego, **{**SCENE, **more})


def test_the_right_run_keeps_everything():
    result = score(record(EXPECT), [good(GOOD_LEAD, GOOD_CUTTER)], 1)
    assert lost(good(GOOD_LEAD, GOOD_CUTTER)) == set()
    assert result.sq == result.csr == result.fa == 100
    assert result.layers == {"RL": 100, "TI": 100, "TM": None, "DO": 100, "EN": 100}
    assert len(result.atoms) == 2 + 1 + 2 + 5 + 4 + 2


def test_the_right_scene_without_the_event():
    calm = GOOD_CUTTER.model_copy(update={"events": ()})
    assert lost(good(GOOD_LEAD, calm)) == {"cutter: cut_in"}


def test_the_wrong_actor_loses_its_presence_only():
    bus = GOOD_CUTTER.model_copy(update={"types": ("bus", "vehicle")})
    assert lost(good(GOOD_LEAD, bus)) == {"cutter: van or truck"}


def test_swapped_lanes():
    lead = thing("lead", does=("brake_hard",), ahead_of_ego=("ahead", "left", 20.0))
    cutter = thing("other", "van", does=("cut_in",), ahead_of_ego=("ahead", "same", 30.0))
    assert lost(good(lead, cutter)) == {"lead: starts lane: same", "cutter: starts lane: left"}


def test_no_weather():
    assert lost(good(GOOD_LEAD, GOOD_CUTTER, weather=("clear",), time=("day",))) == {"weather rain", "time night"}


def test_an_actor_that_is_missing_loses_all_that_is_said_of_it():
    missing = lost(good(GOOD_CUTTER))
    assert missing == {
        "lead: car", "lead: starts relation: ahead", "lead: starts lane: same", "lead: starts gap_m: 10 to 40",
        "lead: brake_hard", "ego: follow lead",
    }  # fmt: skip


def test_a_named_partner_must_be_the_one_that_is_meant():
    ego = thing(EGO, does=(("follow", "other"),), held_speed=14.0)
    assert lost(good(GOOD_LEAD, GOOD_CUTTER, ego=ego)) == {"ego: follow lead"}


def test_a_moving_stranger_is_one_failed_atom_and_a_standing_one_is_free():
    stranger = thing("stranger", ahead_of_ego=("behind", "right", 5.0))
    assert lost(good(GOOD_LEAD, GOOD_CUTTER, stranger)) == {"stranger moves, and nothing expects it"}
    parked = stranger.model_copy(update={"moves": False})
    assert lost(good(GOOD_LEAD, GOOD_CUTTER, parked)) == set()


@pytest.mark.parametrize(
    ("speed", "gap", "limit", "expected"),
    [
        (60 / 3.6, 10.0, 52.0, set()),
        (60.1 / 3.6, 20.0, 50.0, {"ego: speed 40 to 60 km/h"}),
        (None, 20.0, 50.0, {"ego: speed 40 to 60 km/h"}),
        (14.0, 40.1, 50.0, {"lead: starts gap_m: 10 to 40"}),
        (14.0, 20.0, 52.1, {"speed_limit 50 km/h"}),
    ],
)
def test_numbers_at_their_bounds(speed, gap, limit, expected):
    lead = thing("lead", does=("brake_hard",), ahead_of_ego=("ahead", "same", gap))
    ego = GOOD_EGO.model_copy(update={"held_speed": speed})
    assert lost(good(lead, GOOD_CUTTER, ego=ego, speed_limits_kmh=(limit,))) == expected


def test_the_assignment_is_by_all_atoms_together_not_by_names_or_order():
    expect = """
    actors:
      - {as: first, type: car, does: [stationary]}
      - {as: second, type: car, starts: {relation: ahead, of: first, hidden_behind: first}, does: [{hits: first}]}
    """
    near = StartFact(relations=("ahead",), gap=3.0)
    a = thing("a", starts={"b": near}, does=(("hits", "b"),), hidden_behind=("b",))
    b = thing("b", does=("stationary",), moves=False)
    assert lost(run(a, b), expect) == set()
    turned = thing("a", starts={"c": near}, does=(("hits", "c"),), hidden_behind=("c",))
    c = thing("c", "cone", moves=False)
    assert lost(run(turned, b, c), expect) == {
        "second: starts relation: ahead of first", "second: starts hidden_behind: first", "second: hits first"
    }  # fmt: skip


WALKERS = "actors: [{as: group, type: pedestrian, count: %s, does: [cross_road]}]"


@pytest.mark.parametrize(
    ("count", "crossing", "idle", "expected"),
    [
        ("3", 3, 0, set()),
        ("3", 2, 0, {"group: 3 pedestrian"}),
        ("3", 4, 0, {"group: 3 pedestrian"}),
        ("3", 2, 1, {"group: cross_road"}),
        ("3", 3, 1, {"i0 moves, and nothing expects it"}),
        ("{min: 2}", 4, 0, set()),
        ("{min: 2}", 1, 0, {"group: at least 2 pedestrian"}),
        ("{min: 2}", 0, 0, {"group: at least 2 pedestrian", "group: cross_road"}),
    ],
)
def test_counts(count, crossing, idle, expected):
    people = [thing(f"p{i}", "pedestrian", does=("cross_road",)) for i in range(crossing)]
    people += [thing(f"i{i}", "pedestrian") for i in range(idle)]
    assert lost(run(*people), WALKERS % count) == expected


def test_any_of_and_optional():
    expect = """
    actors:
      - {as: car, type: car, does: [{any_of: [stop, {follow: ego}]}]}
      - {as: bystander, type: pedestrian, optional: true, does: [walk_along]}
    """
    follows = thing("x", does=(("follow", EGO),))
    walks = thing("w", "pedestrian", does=("walk_along",))
    assert lost(run(follows), expect) == set()
    assert lost(run(thing("x", does=("stop",)), walks), expect) == set()
    assert lost(run(thing("x", does=("brake",))), expect) == {"car: stop or follow ego"}
    alone = score(record(expect), [run(follows)], 1)
    assert [a.excluded for a in alone.atoms] == ["", "", "optional, and not there", "optional, and not there"]
    assert len([a for a in score(record(expect), [run(follows, walks)], 1).atoms if a.counts]) == 4


def test_snow_is_excluded_and_counted():
    result = score(record("environment: {weather: [snow, cloudy], time: day}"), [run(weather=("cloudy",))], 1)
    assert [(a.atom, a.holds, a.counts) for a in result.atoms] == [
        ("weather cloudy", True, True), ("weather snow", False, False), ("time day", False, True),
    ]  # fmt: skip
    assert result.layers["EN"] == 50 and result.excluded == 1
    only = score(record("environment: {weather: snow}"), [run()], 1)
    assert only.layers["EN"] is None and totals([only], [1], [0]).excluded == 1


def test_an_atom_holds_in_over_half_of_the_rollouts():
    rain, dry = run(weather=("rain",)), run(weather=("clear",))
    held = {}
    for wet in range(6):
        result = score(record("environment: {weather: rain}"), [rain] * wet + [dry] * (5 - wet), 5)
        held[wet] = (result.atoms[0].share, result.sq)
    assert held == {0: (0, 0), 1: (0.2, 0), 2: (0.4, 0), 3: (0.6, 100), 4: (0.8, 100), 5: (1, 100)}
    assert score(record("environment: {weather: rain}"), [rain, dry], 2).sq == 0


def test_rollouts_that_broke_off_satisfy_nothing():
    rain = run(weather=("rain",))
    broken = run(weather=("rain",), ended_by="rejected")
    expect = record("environment: {weather: rain}")
    assert score(expect, [rain] * 3 + [broken] * 2, 5).fa == 100
    bad = score(expect, [rain] * 2 + [broken] * 3, 5)
    assert (bad.csr, bad.sq, bad.fa, bad.layers["EN"]) == (0, 0, 0, 0)
    assert score(expect, [], 5).csr == 0
    assert score(expect, [run(weather=("rain",), ended_by="collision")], 1).csr == 100


def test_totals_are_means_over_what_ran():
    expect = record("road: {signalized: true}\nenvironment: {weather: rain}")
    all_right = score(expect, [run(weather=("rain",), road=RoadFacts(signalized=True))], 1)
    half = score(expect, [run(weather=("rain",))], 1)
    none = score(expect, [], 1)
    row = totals([all_right, half, none], [1, 2, 6], [0, 30, 60]).as_dict()
    assert row == pytest.approx(
        {"number": 3, "CSR": 200 / 3, "RT": 3, "tokens": 30, "RL": 50, "TI": None, "TM": None, "DO": None, "EN": 100,
         "SQ": 75, "FA": 50, "excluded": 0}
    )  # fmt: skip


def test_every_shipped_record_can_be_scored_and_an_empty_world_satisfies_little():
    for item in load():
        empty = score(item, [run()], 1)
        assert empty.atoms and 0 <= empty.sq <= 100
        actors = [a for a in item.expect.get("actors", []) if not a.get("optional")]
        assert sum(a.kind == "presence" and a.counts and not a.holds for a in empty.atoms) == len(actors)

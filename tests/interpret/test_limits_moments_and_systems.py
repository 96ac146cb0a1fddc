"""Systems that act, conditions of requirements, alternatives, and amounts in bare numbers."""

import pytest


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("VUT 50 km/h, GVT stationary 60 m ahead. The AEB activates at a TTC of 1.6 s.", 1.6),
        ("Ego drives at 50 km/h towards a stationary car. Emergency braking kicks in at TTC 1.4 s.", 1.4),
    ],
)
def test_a_system_of_ego_brakes(read, text, value):
    spec = read(text).ego.spec
    assert [(p.action, p.trigger.kind, p.trigger.value) for p in spec.phases] == [("brake", "ttc", value)]


def test_what_a_system_does_not_do(read):
    spec = read(
        "Ego drives at 50 km/h towards a stationary car. The AEB does not activate and ego hits the car."
    ).ego.spec
    assert [p.action for p in spec.phases] == ["collide"]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Where a cyclist is detected within 15 m, the system shall reduce the speed to 20 km/h.", 15),
        ("If a cyclist is less than 18 m away, the ego shall reduce its speed to 20 km/h.", 18),
        ("Ego keeps 60 km/h until it is 40 m behind a cyclist, then slows to 20 km/h.", 40),
        ("A cyclist rides ahead of ego. As the gap to the cyclist closes to 12 m, ego slows to 20 km/h.", 12),
    ],
)
def test_the_distance_from_which_on_ego_slows(read, text, value):
    (phase,) = read(text).ego.spec.phases
    assert (phase.action, phase.speed, phase.trigger.value) == ("brake", 5.56, value)


def test_which_behind_a_lane_is_who_drives_in_it(read):
    structure = read("Ego is driving 18 km/h faster than the lorry in the right lane, which drives at 72 km/h.")
    assert (structure.ego.spec.speed, structure.objects[0].spec.speed) == (25, 20)


def test_the_first_of_two_moments_is_that_of_the_verb(read):
    spec = read("Ego overtakes the truck once it is 50 m behind it and returns when it is 20 m past it.").ego.spec
    assert spec.phases[0].trigger.value == 50


def test_over_a_distance_is_no_gap(read):
    (target,) = read("The target vehicle ahead performs a lane change over a distance of 60 m.").objects
    assert target.spec.placement.gap is None


def test_ego_at_first(read):
    spec = read("At first ego follows the bus. When the bus stops, ego pulls out and passes it.").ego.spec
    assert [p.action for p in spec.phases] == ["follow", "lane_change", "overtake"]


@pytest.mark.parametrize(
    ("text", "action", "value"),
    [
        ("V1 was traveling at 40 mph and swerved right when a dog was 30 feet ahead.", "swerve", 9.14),
        ("V1 swerved left just when V2, a van, was 20 m away.", "swerve", 20),
        ("Ego slows to walking pace when it is 10 m from the children.", "brake", 10),
    ],
)
def test_a_moment_behind_right(read, text, action, value):
    (phase,) = read(text).ego.spec.phases
    assert (phase.action, phase.trigger.value, phase.trigger.of) == (action, value, "O1")


@pytest.mark.parametrize(
    "choice", ["had no choice but to", "had no other option than to", "was left with no choice but to"]
)
def test_no_choice_but_to(read, choice):
    spec = read(f"A taxi ahead reverses. Ego {choice} stop.").ego.spec
    assert spec.reaction == "brake" and [p.action for p in spec.phases] == ["stop"]

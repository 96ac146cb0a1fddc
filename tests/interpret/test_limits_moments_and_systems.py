"""Systems that act, conditions of requirements, alternatives, and amounts in bare numbers."""

import pytest


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("VUT 50 km/h, GVT stationary 60 m ahead. The AEB activates at a TTC of 1.6 s.", 1.6),
        ("Ego drives at 50 km/h towards a stationary car. Emergency braking kicks in at TTC 1.4 s.", 1.4),
        ("Scooter ahead 25 km/h; ego 50; brake trigger TTC=2.5 s.", 2.5),
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


def test_a_time_before_ego_is_there(read):
    (pov,) = read("The POV initiates the cut-in 0.8 s before the SV reaches its rear bumper.").objects
    assert [(p.action, p.trigger.kind, p.trigger.value) for p in pov.spec.phases] == [("cut_in", "ttc", 0.8)]


def test_otherwise_is_another_run(read):
    text = "Provided that the left lane is free, the ego shall overtake the tractor; otherwise it shall follow it."
    assert [p.action for p in read(text).ego.spec.phases] == ["overtake"]


def test_who_meant_to_and_lets_another_go(read):
    spec = read("A bus was going to pull out but let ego pass.").objects[0].spec
    assert [p.action for p in spec.phases] == ["yield"]


def test_bare_numbers_of_a_change(read):
    spec = read("I slowed from 65 to about 45 because the semi in front had lost a tire. It was on I-80.").ego.spec
    assert spec.speed == pytest.approx(29.06, abs=0.01) and [p.speed for p in spec.phases] == [20.12]


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("Ego drives a little below the limit of 100 km/h. A van is ahead.", 94),
        ("Ego drives well over the limit, which is 100 km/h. A van is ahead.", 125),
        ("The limit is 100 km/h. Ego drives 20 % over the limit. A van is ahead.", 120),
        ("The limit is 100 km/h. Ego drives 10 km/h over the limit. A van is ahead.", 110),
    ],
)
def test_a_little_over_the_limit(read, text, speed):
    assert read(text).ego.spec.speed == pytest.approx(speed / 3.6, abs=0.02)


@pytest.mark.parametrize("does", ["slams on the brakes", "jams on the brakes", "locks up", "changed lanes"])
def test_a_guy_in_front_is_at_the_wheel(read, does):
    assert read(f"The guy in front of me {does}. I nearly hit him.").objects[0].spec.type == "car"


def test_which_behind_a_lane_is_who_drives_in_it(read):
    structure = read("Ego is driving 18 km/h faster than the lorry in the right lane, which drives at 72 km/h.")
    assert (structure.ego.spec.speed, structure.objects[0].spec.speed) == (25, 20)


def test_how_hard_and_how_long_ego_changes_its_speed(read):
    (phase,) = read("Ego stands at first, then it accelerates with 2 m/s2 to 36 km/h.").ego.spec.phases[-1:]
    assert (phase.rate, phase.speed) == (2, 10)
    (phase,) = read("Ego decelerates at 3 m/s^2 for 2 s.").ego.spec.phases
    assert (phase.rate, phase.duration) == (3, 2)


def test_the_first_of_two_moments_is_that_of_the_verb(read):
    spec = read("Ego overtakes the truck once it is 50 m behind it and returns when it is 20 m past it.").ego.spec
    assert spec.phases[0].trigger.value == 50


def test_braking_that_ends_in_a_stop_keeps_its_moment(read):
    text = "Ego drives at 50 km/h. Ego begins to brake 40 m before the pedestrian, who is crossing, and stops."
    (phase,) = read(text).ego.spec.phases
    assert (phase.action, phase.trigger.kind, phase.trigger.value) == ("stop", "distance", 40)


def test_how_hard_another_brakes_too(read):
    (phase,) = read("The truck ahead brakes with 5 m/s2. The ego does likewise.").ego.spec.phases
    assert (phase.action, phase.rate) == ("brake", 5)


def test_a_lady_behind_is_at_the_wheel(read):
    spec = read("I managed to stop just in time, the lady behind me did not and hit me.").objects[0].spec
    assert spec.type == "car" and [p.action for p in spec.phases] == ["collide"]


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

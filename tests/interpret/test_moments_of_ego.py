"""Ego's own braking and manoeuvres begin when the text says so, down to the speed that it says."""

import pytest

AHEAD = "Ego drives at 60 km/h. A van drives 60 m ahead at 30 km/h. "


@pytest.mark.parametrize(
    ("text", "kind", "value", "of"),
    [
        ("Ego brakes hard when the van is 20 m away.", "distance", 20, "O1"),
        ("When the van is 25 m away, ego brakes.", "distance", 25, "O1"),
        ("The ego vehicle starts decelerating once the distance to the van is less than 40 m.", "distance", 40, "O1"),
        ("Ego brakes at a TTC of 2 s.", "ttc", 2, None),
        ("Ego shall brake when the TTC to the van falls below 1.5 s.", "ttc", 1.5, "O1"),
        ("Ego starts braking 1.5 s before the impact.", "ttc", 1.5, None),
        ("After 4 s ego brakes.", "time", 4, None),
    ],
)
def test_ego_brakes_from_a_moment_on(read, text, kind, value, of):
    structure = read(AHEAD + text)
    (phase,) = [p for p in structure.ego.spec.phases if p.action == "brake"]
    assert (phase.trigger.kind, phase.trigger.value, phase.trigger.of) == (kind, value, of)
    assert structure.ego.spec.reaction == "brake"
    assert structure.objects[0].spec.placement.gap == 60


@pytest.mark.parametrize(
    ("text", "action", "seen"),
    [
        ("As soon as the lead vehicle brakes, ego changes into the left lane.", "lane_change", "brake"),
        ("Once the bus ahead has stopped, ego overtakes it.", "overtake", "stop"),
        ("When the car in front brakes, ego swerves to the left.", "swerve", "brake"),
    ],
)
def test_ego_waits_for_what_another_does(read, text, action, seen):
    spec = read(text).ego.spec
    (phase,) = [p for p in spec.phases if p.action == action]
    assert (phase.trigger.kind, phase.trigger.of, phase.trigger.action) == ("action", "O1", seen)


@pytest.mark.parametrize(
    "text",
    [
        "Ego was changing lanes to the left when the car in front braked.",
        "Ego was attempting to change lanes to the left when the car in front braked.",
    ],
)
def test_what_went_on_already_waits_for_nobody(read, text):
    (phase,) = read(text).ego.spec.phases
    assert phase.action == "lane_change" and phase.trigger is None


def test_the_speed_that_ego_brakes_to(read):
    spec = read("A slow tractor forces the ego to reduce its speed from 100 to 60 km/h.").ego.spec
    assert spec.speed == 27.78 and [(p.action, p.speed) for p in spec.phases] == [("brake", 16.67)]


@pytest.mark.parametrize(
    "text",
    [
        "Ego had slowed to 60 km/h when a dog ran out.",
        "Because of the fog ego has reduced its speed to 60 km/h. A dog runs across the road.",
    ],
)
def test_a_speed_that_was_reached_before_is_the_speed_at_the_start(read, text):
    spec = read(text).ego.spec
    assert spec.speed == 16.67 and not [p for p in spec.phases if p.action == "brake"]


def test_braking_without_a_moment_stays_a_reaction(read):
    spec = read("A van ahead brakes. Ego brakes, too.").ego.spec
    assert spec.reaction == "brake" and spec.phases == ()


def test_a_skid_is_no_distance_at_which_one_brakes(read):
    spec = read("V1 braked, leaving 22 ft of skid, and struck V2, a van that was backing out of a driveway.").ego.spec
    assert all(p.trigger is None for p in spec.phases)

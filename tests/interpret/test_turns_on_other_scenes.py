"""Turns upon scenes of tests and crashes: who stands and is to move, who waits, who rides, who only has a label."""

import pytest

from tests.interpret.demanded import after, assert_same

AEB = (
    "Ego drives at 60 km/h on a straight road. A stationary truck stands in its lane 80 m ahead. A child on a bicycle "
    "crosses from the left when ego is 40 m away."
)
WALKERS = (
    "Ego approaches a crosswalk at 40 km/h at night. Two pedestrians cross from the left and a parked van on the right "
    "hides a child who runs out."
)
CRASH = (
    "V1, a 2015 Honda Accord, was travelling north on a two-lane road. V2, a Ford F-150 pickup, was travelling south. "
    "V1 drifted over the centre line and struck V2 head-on."
)

CELLS = [
    # who waits is to wait for another moment
    (
        AEB,
        "the bicycle should start when ego is 30 m away",
        "trigger at 30 m | trigger distance: 30 m | 30 m instead of 40 m | later: when ego is 30 m away | "
        "the child should start later, at 30 m | the child crosses when ego is 30 m away",
    ),
    # who rides is called by what the scene calls him
    (AEB, "remove the bicycle", "remove the child | the kid on the bike can go | no child"),
    (AEB, "the bicycle at 20 km/h", "the child cycles at 20 km/h | the child rides at 20 km/h"),
    (AEB, "the bicycle comes from the right", "the child comes from the right | the child from the right side"),
    # another speed for another
    (AEB, "ego at 80 km/h", "ego speed 60 -> 80 | bump ego up to 80 | crank ego's speed up to 80 km/h"),
    # another number of them
    (
        WALKERS,
        "four pedestrians",
        "four instead of two | make them four | there are four of them | two more pedestrians",
    ),
    (WALKERS, "remove the pedestrians", "just the child and the van | only the child and the van"),
    # labels
    (CRASH, "ego at 70 km/h. the truck at 70 km/h", "v1 70, v2 70 | V1 and V2 at 70 km/h"),
    (
        CRASH,
        "replace the truck by a bus",
        "V2 should be a bus instead of a pickup | make V2 a bus | V2 was a bus | V2 = bus",
    ),
    (CRASH, "the truck brakes", "V2 brakes | the driver of V2 brakes"),
    (CRASH, "the truck swerves to the right", "V2 swerves to the right | V2 should swerve right"),
    (CRASH, "ego at 90 km/h", "V1 at 90 km/h | V1 travels at 90 km/h | let V1 drive 90"),
]


@pytest.mark.parametrize(("scene", "plain", "wordings"), CELLS, ids=[c[1] for c in CELLS])
def test_a_demand_is_the_same_in_other_words(read, scene: str, plain: str, wordings: str) -> None:
    assert_same(read(scene), plain, wordings)


@pytest.mark.parametrize(
    "text",
    [
        "the truck drives at 20 km/h",
        "the truck isn't stationary but drives 20 km/h",
        "truck 20 km/h",
        "let the truck move slowly, at 20 km/h",
    ],
)
def test_who_stood_and_has_a_speed_moves(read, text: str) -> None:
    truck = after(read(AEB), text)["O1"]
    assert (round(truck.speed, 1), truck.phases) == (5.6, ())


def test_a_walker_in_the_place_of_a_rider_does_as_he_did(read) -> None:
    scene = read(AEB)
    walker = after(scene, "a pedestrian instead of the cyclist")["O2"]
    assert (walker.type, walker.phases) == ("pedestrian", scene["O2"].spec.phases)

"""Turns upon scenes of tests and crashes: who stands and is to move, who waits, who rides, who only has a label."""

import pytest

from tests.interpret.demanded import after, assert_same

AEB = (
    "Ego drives at 60 km/h on a straight road. A stationary truck stands in its lane 80 m ahead. A child on a bicycle "
    "crosses from the left when ego is 40 m away."
)
CRASH = (
    "V1, a 2015 Honda Accord, was travelling north on a two-lane road. V2, a Ford F-150 pickup, was travelling south. "
    "V1 drifted over the centre line and struck V2 head-on."
)

CELLS = [
    # who waits is to wait for another moment
    # who rides is called by what the scene calls him
    # another speed for another
    # another number of them
    # labels
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

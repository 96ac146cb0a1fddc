"""What is told of the time after a crash, and of who sat where, leaves the scene as it is."""

import pytest

BASES = [
    "V1 was eastbound and struck the rear of V2, which was stopped at a light.",
    "V1 was eastbound on a two-lane road. V2 was westbound. V1 crossed the center line and struck V2 head-on.",
]
AFTER = [
    "V1 came to rest facing south in the right lane.",
    "V2 came to rest across both lanes, facing back the way it had come.",
    "After the crash the driver of V2 moved his car to the shoulder.",
    "Following impact, V1 rolled onto its side.",
    "After the collision, V1 left the road to the right.",
    "A passing motorist called 911.",
    "V1 was occupied by the driver and two children.",
    "The driver of V2 fled the scene on foot.",
    "The westbound lanes were closed for three hours.",
    "An ambulance and two police cars attended.",
]
BEFORE = [
    "V1 was occupied by the driver and two children.",
    "The driver of V1 was a 34-year-old woman who was wearing her seat belt.",
]


def _same(read, text: str, base: str) -> bool:
    told, plain = read(text), read(base)
    return [c.spec for c in told.components] == [c.spec for c in plain.components]


@pytest.mark.parametrize("after", AFTER)
@pytest.mark.parametrize("base", BASES)
def test_what_follows_changes_nothing(read, base: str, after: str) -> None:
    assert _same(read, f"{base} {after}", base)


@pytest.mark.parametrize("before", BEFORE)
@pytest.mark.parametrize("base", BASES)
def test_who_sat_in_it_changes_nothing(read, base: str, before: str) -> None:
    assert _same(read, f"{before} {base}", base)


def test_a_straight_road_with_a_light_has_a_junction(read) -> None:
    s = read("V1 struck the rear of V2, which was stopped at a light. The roadway was straight, level and dry.")
    assert s.place.spec.kind == "intersection"

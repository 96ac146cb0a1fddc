"""Lanes told by a side alone, ranges without a unit, the speed of all, and who is named with ego or after others."""

import pytest


@pytest.mark.parametrize("text", ["Junction, ego straight on, car left.", "Ego turns left, car right."])
def test_sides_are_no_lanes_at_a_junction(read, text: str) -> None:
    assert read(text).place.spec.ego_lane is None


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("VUT 50-80, EBT 20, overlap 25 %.", (50, 80)),
        ("A truck merges directly in front of ego. Variation: ego speed 90 to 130, density of fog.", (90, 130)),
    ],
)
def test_a_range_without_a_unit(read, text: str, speed: tuple[float, float]) -> None:
    assert read(text).ego.spec.speed == pytest.approx([v / 3.6 for v in speed], abs=0.01)


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("Ego drives straight on. The other car comes from the left and does not yield. Both 50.", [50, 50]),
    ],
)
def test_the_speed_of_all(read, text: str, speeds: list[float]) -> None:
    s = read(text)
    assert [c.spec.speed for c in (s.ego, *s.objects)] == pytest.approx([v / 3.6 for v in speeds], abs=0.01)


def test_what_a_person_is_not_fast_enough_for(read) -> None:
    text = "At night, unlit road, ego 80 km/h low beam, a pedestrian is walking on the right edge, one more comes."
    assert all(o.spec.speed < 5 for o in read(text).objects)

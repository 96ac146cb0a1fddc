"""Lanes told by a side alone, ranges without a unit, the speed of all, and who is named with ego or after others."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


def test_sides_are_lanes_where_lanes_are_told_of(read) -> None:
    s = read("Two-lane motorway, ego left 120, truck right 80, car behind ego 150.")
    assert s.place.spec.ego_lane == "leftmost"
    assert [(o.spec.type, o.spec.placement.position) for o in s.objects] == [("truck", "right_lane"), ("car", "behind")]
    s = read('"Sandwich": truck left, truck right, ego in between.')
    assert [o.spec.placement.position for o in s.objects] == ["left_lane", "right_lane"]


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
        ("Ego and a van on a motorway, both at 110 km/h. A car overtakes at 140.", [110, 110, 140]),
    ],
)
def test_the_speed_of_all(read, text: str, speeds: list[float]) -> None:
    s = read(text)
    assert [c.spec.speed for c in (s.ego, *s.objects)] == pytest.approx([v / 3.6 for v in speeds], abs=0.01)


@pytest.mark.parametrize(
    "text",
    [
        "Tank truck 60 km/h ahead; ego doesn't brake until TTC 1.5 s.",
        "A van stands ahead. Ego does not brake before the TTC has fallen to 1.5 s.",
    ],
)
def test_what_is_not_done_until_then_is_done_then(read, text: str) -> None:
    braking = next(p for p in read(text).ego.spec.phases if p.action == "brake")
    assert (braking.trigger.kind, braking.trigger.value) == ("ttc", 1.5)


def test_a_lane_for_turning_in_a_note(read) -> None:
    s = read("Ego in left turn lane, green arrow. Opposing car jumps its red and goes straight at about 60.")
    assert s.place.spec.manoeuvre == "left"


def test_who_comes_after_the_oncoming(read) -> None:
    s = read("Unprotected left: ego waits; two oncoming cars go by, then a gap, then a bus. Ego takes the gap.")
    assert [o.spec.placement.position for o in s.objects] == ["opposite_approach", "opposite_approach"]


def test_who_is_as_fast_as_ego_is_no_ego(read) -> None:
    s = read("Ego in the middle lane at 110. A car at the same speed as ego is on the right.")
    assert [(o.spec.type, o.spec.placement.position) for o in s.objects] == [("car", "right_lane")]


def test_what_a_person_is_not_fast_enough_for(read) -> None:
    text = "At night, unlit road, ego 80 km/h low beam, a pedestrian is walking on the right edge, one more comes."
    assert all(o.spec.speed < 5 for o in read(text).objects)

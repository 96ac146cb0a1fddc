"""Lanes that ego shares with whom it comes up to, and sides that are no lanes."""

import pytest


def road(structure):
    return next(c.spec for c in structure.components if c.id == "R")


@pytest.mark.parametrize(
    ("text", "lane"),
    [
        ("Ego follows a truck in the middle lane of a motorway.", "middle"),
        ("Ego approaches a broken-down car in the middle lane of a three-lane motorway.", "middle"),
        ("Ego approaches the tail end of a jam in the middle lane at 120 km/h.", "middle"),
        ("Ego approaches a slow truck in the right lane of a motorway from behind.", "rightmost"),
    ],
)
def test_ego_is_behind_whom_it_comes_up_to(read, text: str, lane: str) -> None:
    s = read(text)
    assert (road(s).ego_lane, s.objects[0].spec.placement.position) == (lane, "ahead")


@pytest.mark.parametrize(
    "text",
    [
        "Ego, in the left lane, approaches a slow truck in the right lane.",
        "Ego comes to a stationary queue in the lane to its right.",
        "Ego approaches a bus in the right lane, which pulls out in front of it.",
    ],
)
def test_who_is_in_another_lane_stays_there(read, text: str) -> None:
    s = read(text)
    assert (road(s).ego_lane, s.objects[0].spec.placement.position) == ("leftmost", "right_lane")


@pytest.mark.parametrize("bend", ["curve to the left", "bend to the right", "sharp bend to the left"])
def test_the_side_of_a_bend_is_no_lane(read, bend: str) -> None:
    s = read(f"A stationary vehicle stands in ego lane behind a {bend}.")
    assert (road(s).kind, s.objects[0].spec.placement.position) == ("curve", "ahead")


@pytest.mark.parametrize("stop", ["at its stop", "at a bus stop", "at the stop"])
def test_a_bus_at_its_stop_is_beside_the_road(read, stop: str) -> None:
    assert read(f"A bus stands {stop} on the right.").objects[0].spec.placement.position == "parked"

"""Titles in quotes, points of a list, bare words of typologies, rows of cars, and numbers that tell a size."""

import pytest


def acts(component) -> list[str]:
    return [p.action for p in component.spec.phases]


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ('Catalogue entry C12 – "Late braking truck". A truck ahead of ego brakes 30 m before it.', ["truck"]),
    ],
)
def test_a_title_in_quotes_names_nobody_else(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_a_title_that_alone_names_somebody_is_read(read) -> None:
    s = read(
        'Scenario: "Obstructed pedestrian, far side". A bus stands in the opposite lane; ego starts 60 m before it.'
    )
    assert "pedestrian" in [o.spec.type for o in s.objects]


def test_points_of_a_list_are_not_the_first_person(read) -> None:
    s = read("Two stages: (i) the lead car swerves around a tyre, (ii) ego sees the tyre at 100 km/h.")
    assert s["O1"].spec.placement.position == "ahead"


def test_nobody_in_a_lane_puts_nobody_there(read) -> None:
    s = read("Ego at 50 km/h, a motorcyclist stands on the right shoulder, nobody in the oncoming lane.")
    assert [o.spec.placement.side for o in s.objects] == ["right"]


def test_a_size_is_no_gap(read) -> None:
    s = read("The vehicle stops for a child (stature 115 cm) that runs out from behind a parked car.")
    assert s["O2"].spec.type == "child" and s["O2"].spec.placement.gap is None


def test_a_crash_that_is_over_does_not_happen(read) -> None:
    s = read("Three stationary vehicles after a crash 150 m ahead block both lanes. Ego drives at 100 km/h.")
    assert all("collide" not in acts(c) for c in (s.ego, *s.objects))
    s = read("A van skids after a crash with a truck.")
    assert any("collide" in acts(c) for c in (s.ego, *s.objects))


def test_a_speed_with_with(read) -> None:
    s = read("Ego overtakes a tractor, oncoming motorcyclist with 110.")
    assert s["O2"].spec.speed == pytest.approx(30.56, abs=0.01)

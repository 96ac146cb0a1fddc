"""Speeds as a part or multiple of another's or of the limit, and values that several are given in order."""

import pytest


def kmh(component) -> float:
    return component.spec.speed * 3.6


@pytest.mark.parametrize(
    ("text", "ego"),
    [
        ("Ego drives at 0.8 times the posted limit of 100 km/h.", 80),
    ],
)
def test_by_the_limit(read, text: str, ego: float) -> None:
    assert kmh(read(text)["E"]) == pytest.approx(ego, abs=0.5)


def test_other_parts_are_no_speeds(read) -> None:
    assert kmh(read("The overlap is 50 %. Ego drives at 50 km/h.")["E"]) == pytest.approx(50, abs=0.1)
    s = read("A truck blocks half of the lane. Ego drives at 50 km/h.")
    assert s["O1"].spec.placement.position == "partly_in_lane" and kmh(s["E"]) == pytest.approx(50, abs=0.1)


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("Ego drives at 50 km/h and the van ahead at 60 km/h.", [50, 60]),
    ],
)
def test_in_order(read, text: str, speeds: list[float]) -> None:
    s = read(text)
    assert [kmh(s["E"]), kmh(s["O1"])] == pytest.approx(speeds, abs=0.5)


def test_who_is_ahead_of_it_is_not_it(read) -> None:
    s = read("Ego drives at 100 km/h and the truck ahead of it at 60 km/h.")
    assert s["O1"].spec.placement.position == "ahead"

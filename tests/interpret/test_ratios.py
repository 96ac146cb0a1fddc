"""Speeds as a part or multiple of another's or of the limit, and values that several are given in order."""

import pytest


def kmh(component) -> float:
    return component.spec.speed * 3.6


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("The car ahead drives at 80 % of the posted limit of 100 km/h.", None, 80),
        ("The lead vehicle travels at 0.6 times the speed of the ego vehicle, which drives at 100 km/h.", 100, 60),
        ("A motorcycle comes from behind in the left lane, 20 % faster than ego at 90 km/h.", 90, 108),
        ("The cyclist ahead rides half as fast as the ego vehicle, which is doing 30 km/h.", 30, 15),
        ("Ego drives at 100 km/h, the car ahead 30 % slower.", 100, 70),
        ("The truck ahead does two thirds of ego's speed, which is 90 km/h.", 90, 60),
        ("Ego drives at 50 km/h. The speed limit is 70 km/h. A vehicle 50 m ahead drives at half that speed.", 50, 35),
        ("The lead car drives at 60 km/h and ego twice as fast.", 120, 60),
        ("Ego is to drive at 100 km/h and the truck ahead of it at 60 percent of it.", 100, 60),
    ],
)
def test_parts_and_multiples(read, text: str, ego: float | None, other: float) -> None:
    s = read(text)
    assert kmh(s["O1"]) == pytest.approx(other, abs=0.5)
    assert ego is None or kmh(s["E"]) == pytest.approx(ego, abs=0.5)


@pytest.mark.parametrize(
    ("text", "ego"),
    [
        ("The speed limit is 80 km/h but the ego vehicle drives 15 % above it.", 92),
        ("Ego drives at 0.8 times the posted limit of 100 km/h.", 80),
        ("Ego drives at 90 percent of the speed limit of 70 km/h.", 63),
    ],
)
def test_by_the_limit(read, text: str, ego: float) -> None:
    assert kmh(read(text)["E"]) == pytest.approx(ego, abs=0.5)


def test_by_ego_whose_speed_is_open(read) -> None:
    s = read("The car in front travels at half the speed of the ego car.")
    assert s["O1"].spec.speed == pytest.approx(s["E"].spec.speed / 2, abs=0.1)
    assert s["O1"].spec.placement.position == "ahead"
    s = read("The pickup is 25 m behind and closing at 10 km/h more than ego.")
    assert kmh(s["O1"]) == pytest.approx(kmh(s["E"]) + 10, abs=0.5)


def test_other_parts_are_no_speeds(read) -> None:
    assert kmh(read("The overlap is 50 %. Ego drives at 50 km/h.")["E"]) == pytest.approx(50, abs=0.1)
    s = read("A truck blocks half of the lane. Ego drives at 50 km/h.")
    assert s["O1"].spec.placement.position == "partly_in_lane" and kmh(s["E"]) == pytest.approx(50, abs=0.1)


@pytest.mark.parametrize(
    ("text", "speeds"),
    [
        ("Ego and the lead car drive at 50 and 30 km/h respectively.", [50, 30]),
        ("The SV and the POV travel at 45 km/h and 20 km/h, respectively.", [45, 20]),
        ("Vehicle 1 and Vehicle 2 were travelling at 30 and 40 km/h. Vehicle 2 was ahead.", [30, 40]),
        ("Ego drives at 50 km/h and the van ahead at 60 km/h.", [50, 60]),
    ],
)
def test_in_order(read, text: str, speeds: list[float]) -> None:
    s = read(text)
    assert [kmh(s["E"]), kmh(s["O1"])] == pytest.approx(speeds, abs=0.5)


def test_distances_in_order(read) -> None:
    s = read("A car and a truck are 20 m and 50 m ahead of ego, respectively.")
    assert [o.spec.placement.gap for o in s.objects] == [20.0, 50.0]


def test_who_is_ahead_of_it_is_not_it(read) -> None:
    s = read("Ego drives at 100 km/h and the truck ahead of it at 60 km/h.")
    assert s["O1"].spec.placement.position == "ahead"

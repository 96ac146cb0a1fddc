"""Speeds of a series of runs, speeds without a unit after other verbs, and two speeds in one breath."""

import pytest


def speeds(s) -> list:
    return [s.ego.spec.speed, *(o.spec.speed for o in s.objects)]


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("Ego at 30, 40 or 50 km/h approaches a stationary car.", 30, 50),
        ("The VUT drives at 20, 25, 30 and 35 km/h towards a stationary car.", 20, 35),
        ("Ego speeds from 10 km/h to 60 km/h in steps of 10 km/h. A stationary car is ahead.", 10, 60),
    ],
)
def test_a_series_is_a_range(read, text: str, low: float, high: float) -> None:
    assert read(text).ego.spec.speed == pytest.approx((low / 3.6, high / 3.6), abs=0.01)


@pytest.mark.parametrize(
    ("text", "own", "other"),
    [
        ("A truck drives at 80 km/h. Ego comes up at 130 in the left lane.", 130, 80),
        ("Ego closes at 110 on a van doing 80.", 110, 80),
        ("Ego 110 km/h in the right lane, a van 90 km/h.", 110, 90),
    ],
)
def test_two_speeds(read, text: str, own: float, other: float) -> None:
    assert speeds(read(text)) == pytest.approx([own / 3.6, other / 3.6], abs=0.01)


def test_the_speed_that_is_taken_up_again(read) -> None:
    phases = read("The lead brakes to 40 and afterwards accelerates back to 80.").objects[0].spec.phases
    assert [(p.action, p.speed) for p in phases] == [("brake", 11.11), ("accelerate", 22.22)]


def test_how_much_a_speed_may_be_off(read) -> None:
    s = read("Ego drives at 50 km/h. The speed is kept within 1 km/h. The lead brakes.")
    assert s.ego.spec.speed == pytest.approx(13.89, abs=0.01)


@pytest.mark.parametrize(
    "text",
    [
        "A truck brakes to a standstill, with the ego vehicle following closely.",
    ],
)
def test_ego_told_behind_the_one_that_acts(read, text: str) -> None:
    lead = read(text).objects[0].spec
    assert lead.placement.position == "ahead" and lead.phases[0].action in ("brake", "stop")

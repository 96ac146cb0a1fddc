"""Two told of together with "respectively", names of test cases with speeds, what is meant but not done, notes."""

import pytest


def starts(s) -> list[tuple]:
    return [(o.spec.placement.position, o.spec.placement.side) for o in s.objects]


@pytest.mark.parametrize(
    ("text", "placed"),
    [
        ("A pedestrian and a cyclist cross from the left and the right, respectively.", ["left", "right"]),
        ("A van and a bus are parked on the left and the right side of the road respectively.", ["left", "right"]),
    ],
)
def test_each_on_its_side(read, text: str, placed: list[str]) -> None:
    assert [side for _, side in starts(read(text))] == placed


def test_each_in_its_lane(read) -> None:
    s = read("The car and the van travel in the left and right lane respectively.")
    assert [position for position, _ in starts(s)] == ["left_lane", "right_lane"]


def test_each_its_way(read) -> None:
    s = read("V1 and V2 were traveling north and south respectively on Main Street.")
    assert starts(s) == [("oncoming_lane", None)]


def test_each_at_its_speed(read) -> None:
    s = read("The ego and the lead vehicle travel at 80 and 60 km/h, respectively.")
    assert (s["E"].spec.speed, s["O1"].spec.speed) == (22.22, 16.67)


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("CCRm 80 km/h, target 20 km/h.", 22.22, 5.56),
        ("CMRs 40 km/h.", 11.11, 0.0),
        ("CMFtap 20 km/h, motorcycle 60 km/h.", 5.56, 16.67),
        ("CCRs, VUT 50 km/h.", 13.89, 0.0),
    ],
)
def test_test_cases_with_speeds(read, text: str, ego: float, other: float) -> None:
    s = read(text)
    assert (s["E"].spec.speed, s["O1"].spec.speed) == (ego, other)


@pytest.mark.parametrize(
    "text",
    [
        "The ego wanted to change lanes but could not because of a truck in the right lane.",
        "The driver meant to turn right but went straight on.",
        "The ego was about to overtake a truck but stayed behind it.",
    ],
)
def test_meant_but_not_done(read, text: str) -> None:
    assert not {p.action for p in read(text)["E"].spec.phases} & {"lane_change", "turn_right", "overtake"}


def test_tempo_and_zones(read) -> None:
    assert read("Ego at tempo 70 on a country road.")["E"].spec.speed == 19.44
    assert read("The ego is in a 50k zone and follows a car.")["R"].spec.speed_limit == 13.89


def test_once_more_in_a_note(read) -> None:
    s = read("An ambulance approaches the ego from behind. Test: ego at 50 km/h, ambulance 100 m behind at 90 km/h.")
    assert [o.spec.speed for o in s.objects] == [25.0]


@pytest.mark.parametrize("how", ["at least", "more than", "about", "up to"])
def test_a_difference_is_nobodys_speed(read, how: str) -> None:
    s = read(
        f"A car approaches the ego from behind with a speed difference of {how} 30 km/h. The ego drives at 50 km/h."
    )
    assert s["E"].spec.speed == 13.89 and s["O1"].spec.speed > 13.89

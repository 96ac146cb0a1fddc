"""Speeds of the right one, gaps by time, spacings, differences, limits that are driven over."""

import pytest


def kmh(value) -> float:
    return round((sum(value) / 2 if isinstance(value, tuple) else value) * 3.6)


@pytest.mark.parametrize(
    ("text", "speed", "limit"),
    [
        ("Ego goes 50 in a 30 zone and a child runs out.", 50, 30),
        ("Ego is doing 80 km/h in a 50 zone behind a bus.", 80, 50),
        ("The car was travelling at 60 in a 40 limit.", 60, 40),
        ("We were doing 45 mph in a 35 mph zone when a dog ran out.", 72, 56),
    ],
)
def test_driven_over_the_limit(read, text: str, speed: int, limit: int) -> None:
    s = read(text)
    assert (kmh(s["E"].spec.speed), kmh(s["R"].spec.speed_limit)) == (speed, limit)


@pytest.mark.parametrize(
    ("text", "speed"),
    [
        ("A tailgater sits 5 m behind ego at 100 km/h.", 100),
        ("Behind ego a bus follows at 50 km/h.", 50),
        ("A van stays 2 seconds behind ego at 90 km/h.", 90),
    ],
)
def test_who_keeps_behind_is_as_fast(read, text: str, speed: int) -> None:
    s = read(text)
    assert kmh(s["E"].spec.speed) == kmh(s["O1"].spec.speed) == speed
    assert s["O1"].spec.placement.position == "behind"


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("A car is approaching from behind, 15 km/h faster than ego at 80 km/h.", 80, 95),
        ("Ego drives at 90 km/h and closes in on a truck at a relative speed of 30 km/h.", 90, 60),
        ("The lead car drives 5 m/s slower than ego, which drives at 25 m/s.", 90, 72),
    ],
)
def test_differences(read, text: str, ego: int, other: int) -> None:
    s = read(text)
    assert (kmh(s["E"].spec.speed), kmh(s["O1"].spec.speed)) == (ego, other)


@pytest.mark.parametrize(
    ("text", "least", "most"),
    [
        ("Ego keeps a time gap of 1.2 s to the car ahead, both driving at 108 km/h.", 36, 44),
        ("The headway to the lead is 0.9 s at 100 km/h.", 25, 31),
        ("The distance between ego and the car in front is 22 m.", 22, 22),
    ],
)
def test_gaps_named_or_by_time(read, text: str, least: float, most: float) -> None:
    gap = read(text)["O1"].spec.placement.gap
    low, high = gap if isinstance(gap, tuple) else (gap, gap)
    assert least <= low <= high <= most


def test_a_lateral_distance_is_no_gap(read) -> None:
    s = read("A cyclist is overtaken with a lateral distance of 1 m at 40 km/h.")
    assert s["O1"].spec.placement.gap is None


def test_a_negative_rate(read) -> None:
    s = read("The lead decelerates at -3 m/s^2 for 2 s.")
    assert s["O1"].spec.phases[0].rate == 3.0


def test_oncoming_traffic_is_not_the_tractor(read) -> None:
    s = read("A constant stream of oncoming traffic keeps ego from overtaking the tractor ahead.")
    assert [o.spec.placement.position for o in s.objects] == ["oncoming_lane", "ahead"]


def test_in_the_blind_spot(read) -> None:
    s = read("A car stays in ego's blind spot on the left.")
    assert (s["O1"].spec.placement.position, s["O1"].spec.placement.along) == ("left_lane", "abreast")
    s = read("A truck sits on ego's right at the same speed.")
    assert s["O1"].spec.speed == s["E"].spec.speed > 0
    s = read("A white van hangs beside ego in the left lane.")
    assert s["O1"].spec.placement.position == "left_lane"


def test_ego_and_another_side_by_side(read) -> None:
    s = read("Ego and a van drive side by side at 70 km/h.")
    assert kmh(s["O1"].spec.speed) == kmh(s["E"].spec.speed) == 70 and s["O1"].spec.placement.position == "beside"


def test_what_is_no_gap(read) -> None:
    s = read("Ego follows a car into a bend of constant radius to the left (R = 125 m), both at 60 km/h.")
    assert s["O1"].spec.placement.gap is None and s["R"].spec.curve == "left"
    s = read("A motorcycle passes ego on its left. No lateral reaction beyond 0.2 m is allowed.")
    assert s["O1"].spec.placement.gap is None


def test_own_speed(read) -> None:
    s = read("The system shall, at an own speed of 50 km/h or less, slow down and let a bus pull out in front.")
    assert kmh(s["E"].spec.speed) == 50


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("Test speed 50 km/h, target speed 20 km/h, both in the same lane, initial headway 4 s.", 50, 20),
        ("The motorcycle is 40 m behind the VUT with a speed that is 20 km/h higher than that of the VUT (70 km/h).",
         70, 90),
        ("I was in the middle lane doing about 60 km/h when a lorry doing 70 km/h pulled out on me.", 60, 70),
    ],
)  # fmt: skip
def test_whose_speed(read, text: str, ego: int, other: int) -> None:
    s = read(text)
    assert (kmh(s["E"].spec.speed), kmh(s["O1"].spec.speed)) == (ego, other)


def test_occupies_egos_lane_and_moves(read) -> None:
    s = read("A slow-moving agricultural vehicle occupies ego's lane 120 m ahead and travels at 15 km/h.")
    assert s["O1"].spec.placement.position == "ahead" and kmh(s["O1"].spec.speed) == 15

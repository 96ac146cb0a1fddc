"""Plain sentences about place, light, things of the farm, and how long a change of speed takes."""

import pytest


def place(structure, cid: str = "O1") -> tuple:
    at = structure[cid].spec.placement
    return at.position, at.side, at.gap


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A pedestrian steps from the nearside pavement onto the road.", ("sidewalk", "right", None)),
        ("The vehicle in the neighbouring lane brakes.", ("left_lane", None, None)),
        ("An e-scooter rides on the sidewalk on the right.", ("sidewalk", "right", None)),
        ("A line of three cyclists rides two metres from the kerb 50 m ahead.", ("ahead", None, 50.0)),
        ("Ego waits at the red light and there is a motorbike to its left.", ("left_lane", None, None)),
        ("A car approaches to the left of ego at the junction.", ("crossing_left", None, None)),
        ("Ego has priority at the roundabout, but a car enters it from the right.", ("crossing_right", None, None)),
        ("A truck drives in the lane next to ego.", ("left_lane", None, None)),
    ],
)
def test_where(read, text: str, expected: tuple) -> None:
    assert place(read(text)) == expected


@pytest.mark.parametrize(
    ("text", "weather", "time"),
    [
        ("It is shortly before sunrise; ego follows a van.", (), "dawn"),
        ("After a downpour the asphalt is still wet; ego drives behind a car.", ("wet",), None),
        ("The downpour has stopped, but the road is slippery. Ego follows a bus.", ("wet",), None),
        ("A cloudburst begins while ego follows a van.", ("heavy_rain",), None),
    ],
)
def test_weather_and_light(read, text: str, weather: tuple, time: str | None) -> None:
    spec = read(text)["G"].spec
    assert (spec.weather, spec.time) == (weather, time)


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("Ego drives behind a slow agricultural vehicle at 25 km/h.", ["truck"]),
        ("A tractor pulls a trailer ahead of ego.", ["truck"]),
        ("The ego vehicle overtakes a car with a caravan.", ["car"]),
        ("A caravan in the adjacent lane drifts towards ego.", ["van"]),
        ("Ego passes a stationary tram at a tram stop, and a passenger crosses in front of it.", ["bus", "pedestrian"]),
    ],
)
def test_what_they_are(read, text: str, types: list[str]) -> None:
    assert [o.spec.type for o in read(text).objects] == types


def test_the_slow_one_has_the_speed(read) -> None:
    s = read("Ego drives behind a slow agricultural vehicle at 25 km/h.")
    assert s["O1"].spec.speed == pytest.approx(6.94, abs=0.01)


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        ("The lead vehicle brakes from 100 km/h to a standstill.", None),
    ],
)
def test_how_long_it_takes(read, text: str, rate: float | None) -> None:
    assert read(text)["O1"].spec.phases[0].rate == rate


@pytest.mark.parametrize(
    ("text", "control"),
    [
        ("The traffic light is out of order, and a car from the left does not yield.", "none"),
        ("At the junction the traffic lights are switched off. A car comes from the right.", "none"),
        ("At the junction the traffic light is red. A car comes from the right.", "signal"),
    ],
)
def test_lights_that_do_not_work(read, text: str, control: str) -> None:
    assert read(text)["R"].spec.control == control


def test_who_is_stood_behind_stands(read) -> None:
    assert read("Our car waits behind a bus at a red light.")["O1"].spec.speed == 0.0

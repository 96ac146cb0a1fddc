"""Signals that are told beside riders without lights, limits without a unit, and the hour beside a part of the day."""

import pytest


@pytest.mark.parametrize(
    ("text", "light"),
    [
        ("The signal for northbound traffic was red, and the AV stopped behind a van.", "red"),
        ("The light for eastbound traffic was green. The AV went straight at the intersection.", "green"),
        ("The AV approached a green signal. A cyclist without lights crossed from the right.", "green"),
        ("I meant to turn right at the traffic lights, which were green for me. A cyclist had no lights.", "green"),
    ],
)
def test_the_light_of_a_direction(read, text: str, light: str) -> None:
    s = read(text)
    assert (s.settings.spec.light, s.place.spec.control) == (light, "signal")


def test_a_junction_without_lights(read) -> None:
    s = read("The AV drove up to a crossing. There were no lights. It went straight and a car came from the right.")
    assert s.place.spec.control == "none"


@pytest.mark.parametrize(
    ("text", "limit"),
    [
        ("V1 was westbound on Larch Lane (posted 25) at 28 mph.", 40),
        ("V1 drove at 50 MPH, posted 30.", 48),
        ("I was driving at 70 km/h, the limit there is 80.", 80),
        ("The ego follows a truck towards roadworks, there is a 60 km/h sign.", 60),
        ("It's a twenty mile an hour limit from here. I brake for children.", 32),
    ],
)
def test_limits_in_few_words(read, text: str, limit: int) -> None:
    assert round(read(text).place.spec.speed_limit * 3.6) == limit


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("It happened on Wednesday evening at about 9.45 p.m. The ego hit a woman.", "night"),
        ("Early on Sunday morning at 2.30 am the ego hit a tree.", "night"),
        ("The ego drives along the road at ten in the evening.", "night"),
        ("At approx. 0150, V1 drifted off the road. The driver had been up since 4 the previous morning.", "night"),
        ("ODD: motorways, day and night. It is night. The ego follows a truck.", "night"),
        ("The sun is just about to set. The ego follows a car.", "dusk"),
        ("On Wednesday evening at about 7 p.m. the ego hit a woman.", "dusk"),
    ],
)
def test_the_hour(read, text: str, time: str) -> None:
    assert read(text).settings.spec.time == time


@pytest.mark.parametrize("how", ["pretty hard", "really heavily", "quite hard"])
def test_how_hard_it_rains(read, how: str) -> None:
    assert read(f"It is raining {how}. The ego follows a truck.").settings.spec.weather == ("heavy_rain",)

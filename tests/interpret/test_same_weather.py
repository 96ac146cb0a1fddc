"""Weather and light that are only implied, or told of the road."""

import pytest


@pytest.mark.parametrize(
    ("words", "weather"),
    [
        ("The wipers are on.", "rain"),
        ("The windscreen wipers are running.", "rain"),
        ("The wipers are on full speed.", "heavy_rain"),
        ("Rain hammers on the roof.", "heavy_rain"),
        ("The fog lights are on because of fog.", "fog"),
        ("The road is rain-soaked.", "wet"),
        ("The lorry throws up spray.", "wet"),
        ("It is clear.", "clear"),
        ("The sky is blue.", "clear"),
    ],
)
def test_weather(read, words: str, weather: str) -> None:
    assert read(f"{words} Ego drives at 50 km/h. A van ahead brakes.").settings.spec.weather == (weather,)


@pytest.mark.parametrize(
    ("words", "time"),
    [
        ("Ego drives under street lighting.", "night"),
        ("Ego drives along at 3 in the morning.", "night"),
        ("The road is lit only by the headlights.", "night"),
        ("It is just after sunset.", "dusk"),
        ("It is after sunset.", "night"),
    ],
)
def test_time(read, words: str, time: str) -> None:
    assert read(f"{words} A van ahead of ego brakes.").settings.spec.time == time

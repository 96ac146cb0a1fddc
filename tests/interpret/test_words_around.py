"""Who is ego by a number or a demand, whose speed it is, and places that only the manner of speaking tells."""

import pytest

from c2s_engine.interpret.reading import scan
from c2s_engine.interpret.surroundings import environment


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("It happened in the small hours.", "night"),
        ("The road is not lit and it was 22:30.", "night"),
        ("Just before sunrise a car braked.", "dawn"),
        ("It was growing dark.", "dusk"),
        ("During the evening rush a car braked.", "day"),
        ("Rain was coming down in sheets.", "heavy_rain"),
        ("The surface was slick with rain.", "wet"),
        ("The sky was grey.", "cloudy"),
        ("A squall caught the van.", "wind"),
    ],
)
def test_light_and_weather(text: str, value: str) -> None:
    plain = scan.normalised(text)
    whole = [(0, len(plain))]
    time = environment.time_of_day(plain, whole)
    assert value in {f.value for f in (*environment.weather(plain, whole), *([time] if time else []))}


def test_what_is_clear_of_somebody_is_no_weather() -> None:
    plain = scan.normalised("V1 was nearly clear. It let the bus clear, and went on when the road was clear.")
    assert not environment.weather(plain, [(0, len(plain))])

"""Who is moved by wind or ice moves; traffic that stands still, however it is said; who crosses is no crossing."""

import pytest


@pytest.mark.parametrize(
    ("text", "action"),
    [
        ("A gust of wind pushes a van from the right lane into the ego's lane on a motorway.", "drift"),
        ("A strong crosswind blows the truck ahead out of its lane.", "drift"),
        ("A patch of black ice sends the oncoming car into the ego's lane.", "drift"),
    ],
)
def test_what_wind_and_ice_move(read, text: str, action: str) -> None:
    s = read(text)
    assert len(s.objects) == 1 and [p.action for p in s["O1"].spec.phases] == [action]


@pytest.mark.parametrize(
    "text",
    [
        "There is a stationary queue ahead of the ego.",
        "Traffic ahead is stationary.",
        "The traffic in front of the ego has come to a halt.",
        "Ahead of the ego, traffic is at a complete standstill.",
    ],
)
def test_standing_traffic(read, text: str) -> None:
    s = read(text)
    assert [o.spec.speed for o in s.objects] == [0.0] and s["O1"].spec.count > 1


@pytest.mark.parametrize("who", ["truck", "tram", "motorcycle"])
def test_who_is_crossing_is_no_crossing(read, who: str) -> None:
    s = read(f"After a {who} crossing from the left has cleared the intersection, the ego turns right.")
    assert s["O1"].spec.placement.position == "crossing_left"


def test_a_sandstorm_hides_the_road(read) -> None:
    assert "fog" in read("In a sandstorm on the highway, a truck ahead brakes.").settings.spec.weather

"""Questions and answers of a witness, abbreviations of the text's own, and what whoever is behind does."""

import pytest

from c2s_engine.interpret.reading.spelling import Mended


def _types(s) -> list[str]:
    return [o.spec.type for o in s.objects]


def _acts(component) -> list[str]:
    return [p.action for p in component.spec.phases or ()]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Q1. Which lane? A1. Right lane. Ego follows a truck.", "Which lane?"),
        ("A. Ego follows a truck. B. The truck brakes.", "A. Ego follows a truck. B."),
    ],
)
def test_only_questions_with_answers_are_read_so(text: str, said: str) -> None:
    assert said in Mended(text).text


@pytest.mark.parametrize(
    "text",
    [
        "This is about the grey Astra, I'm calling that car one. Car one was coming up at 30 mph. The van coming the "
        "other way turned left in front of it. The nose of the Astra hit the side of the van.",
        "The grey Astra, let's call it car one, was coming up at 30 mph. A van coming the other way turned left in "
        "front of it. Car one hit the side of the van.",
        "We will call the grey Astra car one. Car one was coming up at 30 mph. The van coming the other way turned "
        "left in front of it. Car one hit the van.",
    ],
)
def test_who_is_called_by_a_number_is_one(read, text: str) -> None:
    s = read(text)
    assert _types(s) == ["van"]
    assert s.ego.spec.speed == pytest.approx(13.41, abs=0.1)
    assert _acts(s.ego)[-1] == "collide"


@pytest.mark.parametrize(
    ("text", "kind", "speed"),
    [
        (
            "The VUT drives at 40 km/h. The adult target (EPTa) stands on the pavement to the right. At TTC 4 s the "
            "EPTa is propelled at 5 km/h across the road.",
            "pedestrian",
            1.39,
        ),
        (
            "The VUT drives at 40 km/h. The cyclist target (XBT) is towed across the road from the left at 15 km/h. "
            "The VUT brakes for the XBT.",
            "bicycle",
            4.17,
        ),
    ],
)
def test_an_abbreviation_of_the_text_is_the_same_one(read, text: str, kind: str, speed: float) -> None:
    s = read(text)
    assert _types(s) == [kind]
    assert s.objects[0].spec.speed == pytest.approx(speed, abs=0.05)
    assert _acts(s.objects[0]) == ["cross_road"]


@pytest.mark.parametrize(
    "text",
    [
        "The AV brakes and stops. Whatever is following (in the clip a bus in the same lane) carries on and goes by.",
        "The AV brakes and stops. Anything behind it (in this case a bus in the same lane) goes past.",
        "The AV brakes and stops. What follows, a bus in the same lane, carries on and goes by.",
    ],
)
def test_whatever_follows_goes_past(read, text: str) -> None:
    s = read(text)
    assert s.ego.spec.type == "car"
    assert _types(s) == ["bus"]
    assert s.objects[0].spec.placement.position == "behind"
    assert "overtake" in _acts(s.objects[0])


@pytest.mark.parametrize(
    "deed", ["rolled back two metres into my bonnet", "rolled back, a good metre, straight into me"]
)
def test_how_far_one_rolls_back(read, deed: str) -> None:
    s = read(f"I was behind a van at a red light, both of us waiting. Then it {deed}.")
    assert s.ego.spec.speed == 0
    assert _acts(s.objects[0]) == ["reverse", "collide"]


@pytest.mark.parametrize(
    "why",
    [
        "meant that going left was no option",
        "left no room to swerve",
    ],
)
def test_who_leaves_no_way_out_is_only_there(read, why: str) -> None:
    s = read(f"Ego in the right of two lanes. A bus in the left lane, level with ego, {why}. A car ahead braked.")
    assert (s.objects[0].spec.placement.position, s.objects[0].spec.placement.along) == ("left_lane", "abreast")
    assert not _acts(s.objects[0])
    assert "lane_change" not in _acts(s.ego)


def test_somebody_riding_is_a_cyclist(read) -> None:
    assert _types(read("Somebody was riding in front of me at 12 km/h, so I stayed behind.")) == ["bicycle"]
    assert "bicycle" not in _types(read("Somebody riding in a taxi in front of me waved."))


@pytest.mark.parametrize(
    ("text", "weather", "time"),
    [
        ("Rain is allowed, darkness is not: it was done in rain at noon. Ego follows a bus.", ("rain",), "day"),
        ("Ego follows a bus. Night driving is excluded, so it was done in the afternoon.", (), "day"),
        ("A grey afternoon. Ego follows a bus.", ("cloudy",), "day"),
        ("Vehicle 1 was driving toward the setting sun when a bus ahead braked.", (), "dusk"),
        ("Ego follows a bus at night.", (), "night"),
    ],
)
def test_hours_that_are_excluded_and_skies(read, text: str, weather: tuple[str, ...], time: str) -> None:
    settings = read(text).settings.spec
    assert (settings.weather, settings.time) == (weather, time)


def test_green_that_became_amber(read) -> None:
    s = read("I came up to the lights at 50 km/h. Twenty metres out, green became amber. I stopped at the line.")
    assert s.settings.spec.light == "yellow"

"""The same road, junction, signal and crossing in the ways in which people name it."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "A pedestrian uses a crosswalk to cross from the right.",
    ],
)
def test_a_crossing_is_no_pedestrian(read, text: str) -> None:
    s = read(text)
    assert s.place.spec.kind == "crosswalk"
    assert [[p.action for p in o.spec.phases] for o in s.objects] == [["cross_road"]]


@pytest.mark.parametrize(
    ("words", "lanes"),
    [
        ("a two-lane dual carriageway", 2),
        ("a four-lane dual carriageway", 2),
        ("a dual carriageway with 2 lanes per carriageway", 2),
        ("a dual carriageway, 2x2 lanes", 2),
        ("a six-lane motorway", 3),
        ("an undivided two-lane road", 1),
        ("a road with a single lane per direction", 1),
        ("a 1+1 road", 1),
    ],
)
def test_lanes(read, words: str, lanes: int) -> None:
    place = read(f"Ego drives on {words}. A car ahead brakes.").place.spec
    assert place.lanes == lanes and place.kind == ("motorway" if lanes > 1 else "road")
    assert bool(place.oncoming) == (lanes == 1)


@pytest.mark.parametrize(
    "words",
    ["Ego has green.", "The lights are with ego.", "Ego's phase is green.", "The light being green, it does not slow."],
)
def test_the_light_is_green(read, words: str) -> None:
    s = read(f"Ego goes straight at an intersection. {words} A van comes from the right.")
    assert (s.settings.spec.light, s.place.spec.control) == ("green", "signal")


@pytest.mark.parametrize(
    ("words", "control"),
    [
        ("an intersection with right-before-left", "none"),
        ("an intersection lacking any signs or signals", "none"),
        ("an unmarked junction", "none"),
        ("an intersection governed by a signal", "signal"),
        ("a junction with signals", "signal"),
        ("a give-way junction", "yield"),
        ("a priority-controlled junction", "yield"),
    ],
)
def test_what_regulates_it(read, words: str, control: str) -> None:
    assert read(f"Ego goes straight at {words}. A van comes from the right.").place.spec.control == control


@pytest.mark.parametrize("words", ["through a left-hander", "on a leftward curve", "on a road bending left"])
def test_a_bend(read, words: str) -> None:
    place = read(f"Ego drives {words}. A car ahead brakes.").place.spec
    assert (place.kind, place.curve) == ("curve", "left")


@pytest.mark.parametrize(
    "text",
    [
        "Ego drives over the brow of a hill. A stationary car stands behind it.",
    ],
)
def test_beyond_a_crest_is_ahead(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "ahead"


@pytest.mark.parametrize(
    "text",
    [
        "A van on the on-ramp merges in front of ego.",
        "A van merges in front of ego from an entrance ramp.",
        "From the on-ramp a van merges in front of ego.",
    ],
)
def test_from_a_ramp(read, text: str) -> None:
    van = read(text)["O1"].spec
    assert (van.placement.position, [p.action for p in van.phases]) == ("on_ramp", ["cut_in"])


@pytest.mark.parametrize(
    "text",
    ["From the right, a van comes to the intersection.", "At an intersection a van comes from the right-hand arm."],
)
def test_from_an_arm(read, text: str) -> None:
    assert read(text)["O1"].spec.placement.position == "crossing_right"

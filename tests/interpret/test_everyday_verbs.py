"""Verbs of everyday speech, and their false friends."""

import pytest


@pytest.mark.parametrize(
    ("text", "component", "action"),
    [
        ("The lorry thunders past the ego in the left lane.", "O1", "overtake"),
        ("A taxi breezes past us.", "O1", "overtake"),
        ("The pickup careers into the back of the ego.", "O1", "collide"),
        ("The car ahead locks up and the ego piles into it.", "E", "collide"),
        ("The coach ahead bails onto the hard shoulder.", "O1", "leave_road"),
        ("The taxi flips a U-turn in front of the ego.", "O1", "u_turn"),
        ("The ego boots it and scoots around the tractor.", "E", "overtake"),
        ("Ego avoids the stopped car by the left lane.", "E", "lane_change"),
        ("Some idiot in a BMW cuts me up and slams on the brakes.", "O1", "cut_in"),
        ("At the lights a bus flies through on red from the right. The ego brakes.", "O1", "run_red"),
    ],
)
def test_verbs(read, text: str, component: str, action: str) -> None:
    assert action in [p.action for p in read(text)[component].spec.phases]


@pytest.mark.parametrize(
    "text",
    [
        "The lorry thunders past the ego.",
        "The ego winds it up to 90 km/h.",
        "A taxi breezes past the ego where the road winds through the hills.",
    ],
)
def test_no_weather(read, text: str) -> None:
    assert read(text)["G"].spec.weather == ()


def test_red_cars_are_no_lights(read) -> None:
    s = read("The ego stops at a red pickup. The lady in the red hatchback drives on.")
    assert s["R"].spec.control is None and s["G"].spec.light is None

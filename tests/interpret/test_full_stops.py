"""Ego stops for somebody: it brakes for what comes into its way and does so to a stand."""

import pytest

STOPS = [
    "A pedestrian crosses from the right and the ego stops 2 m short of him.",
    "The ego brakes and comes to rest before reaching the deer, which crosses from the left.",
    "A car cuts in from the right lane and slams on the brakes; the ego stops just in time behind it.",
    "The road is blocked by a fallen tree; ego comes to a halt in front of it.",
    "The lead car brakes to a standstill and the ego manages to stop behind it.",
]


@pytest.mark.parametrize("text", STOPS)
def test_it_stops_for_somebody(read, text: str) -> None:
    ego = read(text)["E"].spec
    assert [p.action for p in ego.phases] == ["stop"] and ego.reaction == "brake"


@pytest.mark.parametrize(
    "text",
    [
        "A truck is double-parked. The ego stops behind it, then overtakes it through the oncoming lane.",
        "The lead car stops; ego brakes and changes into the left lane.",
    ],
)
def test_it_gets_past_after_it(read, text: str) -> None:
    assert "stop" not in [p.action for p in read(text)["E"].spec.phases]


def test_it_stops_for_one_who_waits(read) -> None:
    ego = read("The ego vehicle halts for the pedestrian waiting at the zebra crossing.")["E"].spec
    assert [p.action for p in ego.phases] == ["stop"]


def test_it_only_brakes(read) -> None:
    assert read("A car cuts in from the left and ego brakes.")["E"].spec.phases == ()


def test_one_that_is_only_announced(read) -> None:
    s = read("A scene with a single NPC vehicle. An SUV in the left lane cuts in ahead of the ego and brakes.")
    assert len(s.objects) == 1

"""What only asks changes nothing, what is no change says so, and what begins anew is a scenario."""

import pytest

from c2s_engine.interpret.turn import route

SCENE = "Ego follows a car at 50 km/h. The car brakes hard and a pedestrian crosses from the right."


@pytest.mark.parametrize(
    "text",
    [
        "does ego brake for him or go round him, i dont get it from the picture",
        "wait, who is hidden behind whom here",
        "whats the speed of ego",
        "just curious, why 50 km/h",
        "i wonder if the pedestrian is hidden",
        "is a pedestrian on the left sidewalk realistic",
        "can ego still stop in time at 50?",
    ],
)
def test_questions(read, text: str) -> None:
    assert route(text, read(SCENE)).kind == "question"


@pytest.mark.parametrize(
    "text",
    [
        "why is the car so slow? it should drive 60",
        "would it be possible that the pedestrian comes from the left?",
        "i wonder if we could make it night",
        "shouldnt the pedestrian come from the left",
        "when the pedestrian starts, the car brakes",
        "car brakes only to 20 km/h, can you do this?",
    ],
)
def test_demands_that_look_like_questions(read, text: str) -> None:
    turn = route(text, read(SCENE))
    assert turn.kind == "edit" and turn.edits


@pytest.mark.parametrize(
    "text",
    [
        "ok drop this whole thing, next one: at dusk a deer stands in a right bend, ego comes with 90 km/h",
        "forget this one. ego turns right at a junction and a cyclist goes straight on beside it",
        "ok thanks, different scenario now. On a motorway a truck changes lane in front of ego.",
        "enough of that, now something with a tram: ego turns left and a tram comes from behind",
    ],
)
def test_a_new_scenario(read, text: str) -> None:
    assert route(text, read(SCENE)).kind == "scenario"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("the driver of the car opens the door", "doors"),
        ("make the lead car blue", "colours"),
        ("make it better", "did not understand"),
        ("a tunnel would be nice", "did not understand"),
    ],
)
def test_what_cannot_be_done_changes_nothing(read, text: str, why: str) -> None:
    turn = route(text, read(SCENE))
    assert turn.kind == "edit" and not turn.edits and why in turn.reply

"""Who passes ego or comes up from behind: where it starts and how fast; and queues that only a noun tells of."""

import pytest

from c2s_engine.interpret import EmbeddedInterpreter


@pytest.fixture(scope="module")
def interpreter():
    return EmbeddedInterpreter()


@pytest.mark.parametrize(
    "text",
    [
        "The ego is overtaken by a motorcycle on the left, which then brakes hard in front of it.",
        "A van in the left lane overtakes the ego and then cuts in ahead of it.",
    ],
)
def test_who_overtakes_ego_starts_behind_it(interpreter, text):
    other = interpreter.interpret(text).structure["O1"].spec
    assert other.placement.position == "left_lane" and other.placement.along == "behind"


@pytest.mark.parametrize(
    "text",
    [
        "A truck approaching from behind at high speed tailgates the ego at 50 km/h.",
        "An ambulance comes up behind the ego, which drives at 50 km/h.",
        "A car behind the ego comes closer at speed.",
    ],
)
def test_who_comes_up_from_behind_is_faster(interpreter, text):
    structure = interpreter.interpret(text).structure
    assert structure["O1"].spec.placement.position == "behind"
    assert structure["O1"].spec.speed > structure["E"].spec.speed


def test_who_slows_down_begins_as_fast_as_ego(interpreter):
    structure = interpreter.interpret("The vehicle in front slows to 20 km/h on the motorway.").structure
    assert structure["O1"].spec.speed == structure["E"].spec.speed
    assert structure["O1"].spec.phases[0].action == "brake"


@pytest.mark.parametrize(
    "text", ["Ego 60 km/h, stationary queue ahead.", "Ego at 20 m/s, fog, backed-up traffic ahead."]
)
def test_a_queue_is_standing_cars(interpreter, text):
    queue = interpreter.interpret(text).structure["O1"].spec
    assert queue.count > 1 and queue.placement.position == "ahead" and not queue.speed

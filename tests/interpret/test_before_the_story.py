"""What was over before the story begins, vehicles that collide with each other, signals without power, no steering."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "Unit 2 had come to rest in the lane. Unit 1, at 60 mph, struck its rear.",
        "A truck had stopped in the right lane when ego came up behind it.",
        "A car had broken down ahead of the ego.",
    ],
)
def test_what_had_stopped_stands(read, text: str) -> None:
    spec = read(text)["O1"].spec
    assert spec.speed == 0.0 and [p.action for p in spec.phases] == ["stationary"]


def test_two_that_collide_do_not_hit_ego(read) -> None:
    spec = read("Two vehicles ahead of the ego collide and block both lanes.")["O1"].spec
    assert all(p.target != "ego" for p in spec.phases) and spec.phases[0].action == "stop"


def test_dark_signals_are_no_night(read) -> None:
    assert (
        read("The traffic lights are dark and the ego lets a car from the right go first.").settings.spec.time is None
    )


def test_no_steering_is_no_swerve(read) -> None:
    assert read("VUT at 60 km/h approaches a stationary car; no steering.").ego.spec.phases == ()

"""Riders called he or she beside vehicles that stand; those who go over lights without running them."""

import pytest


@pytest.mark.parametrize(
    "text",
    [
        "A lady on a bicycle is ahead of us. A lorry is parked half on the pavement, so she comes out into our lane to "
        "get round it.",
        "A motorcyclist rides ahead of ego. A van stands half on the kerb. He swerves out to get round it.",
    ],
)
def test_the_rider_moves_and_what_stands_stays(read, text: str) -> None:
    rider, still = (c.spec for c in read(text).objects)
    assert rider.phases and rider.phases[0].action in ("overtake", "swerve")
    assert [p.action for p in still.phases] == ["stationary"]


def test_going_over_the_lights_runs_no_red(read) -> None:
    s = read("An SUV waits on the far side to turn left, ego goes straight over the lights.")
    assert "run_red" not in [p.action for p in s["E"].spec.phases]
    van = read("A van goes through the red light from the left, ego has green.").objects[0].spec
    assert "run_red" in [p.action for p in van.phases]

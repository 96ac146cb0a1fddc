"""Times to collision, encroachment and deceleration of motions whose values are known."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from c2s_engine.require.measures import pairs
from c2s_engine.require.natural import _judged
from c2s_engine.structure.facts import Track, Trajectories

STEP = 0.1
NORTH, WEST = 0.0, math.pi / 2


def track(name: str, x: float, y: float, heading: float, speed: float, seconds: float = 6.0) -> Track:
    """Straight on at one speed."""
    times = np.arange(0, seconds, STEP)
    xs, ys = x - math.sin(heading) * speed * times, y + math.cos(heading) * speed * times
    return Track(
        name=name, x=tuple(xs), y=tuple(ys), heading=(heading,) * len(times), speed=(speed,) * len(times), length=4,
        width=2,
    )  # fmt: skip


def pair(other: Track, ego: Track | None = None):
    ways = Trajectories(step=STEP, tracks=(ego or track("ego", 0, 0, NORTH, 20), other))
    return pairs(ways)[0]


def test_behind_a_slower_one() -> None:
    found = pair(track("lead", 0, 44, NORTH, 10))
    assert found.gap[0] == pytest.approx(40) and found.ahead[0] == pytest.approx(44)
    assert found.ttc[0] == pytest.approx(4.0)
    assert found.required[0] == pytest.approx(10**2 / (2 * 40), rel=1e-3)
    assert found.pet is None


def test_beside_one_who_passes() -> None:
    found = pair(track("passing", -3.5, -10, NORTH, 25))
    assert not np.isfinite(found.ttc).any() and not found.required.any()
    assert found.left[0] == pytest.approx(3.5) and found.ahead[0] < 0 < found.ahead[-1]


@pytest.mark.parametrize("late", [0.5, 1.5])
def test_crossing_after_ego(late: float) -> None:
    there = (60 + 2 + 1) / 20  # s: ego's tail has left the strip that the other's box sweeps
    found = pair(track("van", (there + late) * 10 + 2 + 1, 60, WEST, 10, seconds=8))
    assert found.pet is not None
    assert found.pet[0] == pytest.approx(late, abs=2 * STEP)


def test_touching_is_no_time_apart() -> None:
    found = pair(track("van", 30, 60, WEST, 10))
    assert found.pet is not None and found.pet[0] == 0 and found.gap.min() == 0


def test_a_bound_that_is_met_to_the_digit_that_is_shown_is_met():
    time = np.arange(0, 4, 0.1)

    def margin(most):
        motion = SimpleNamespace(time=time, step=0.1, speed=time, lateral=0 * time, acceleration=0 * time + most)
        return next(iter(_judged(motion, {"acceleration": {"value": 4.0}}, sideways=False)))

    assert margin(4.04)[0] == 0.0 and margin(4.04)[1:3] == ("acceleration up to 4 m/s2", "4.0 m/s2")
    assert margin(4.06)[0] < 0 and margin(4.06)[2] == "4.1 m/s2"

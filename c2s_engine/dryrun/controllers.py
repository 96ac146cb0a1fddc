"""The controllers that Scenic's driving behaviours ask the simulation for.

They get the distance from the path (m, left positive) and the speed error (m/s) alone. The path's heading and
curvature are estimated from how the distance changes while the vehicle's own heading and speed are known; the demanded
lateral acceleration is then turned into a steering angle for the speed driven.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

from c2s_engine.dryrun.dynamics import Body, engine, resistance, steering_limit


@dataclass(frozen=True)
class Tuning:
    """`closing`, `damping`: 1/s; `sideways`: the largest lateral speed (m/s); `lateral`, `braking`: m/s2."""

    closing: float
    damping: float
    sideways: float
    lateral: float
    braking: float


FOLLOWING = Tuning(closing=0.9, damping=3.0, sideways=1.5, lateral=5.0, braking=3.8)
TURNING = Tuning(closing=1.4, damping=4.5, sideways=2.5, lateral=8.0, braking=4.25)
CHANGING = Tuning(closing=1.05, damping=3.2, sideways=1.4, lateral=2.5, braking=3.8)


class Longitudinal:
    """From a speed error to a pedal: 0..1 throttle, -1..0 brake."""

    def __init__(self, body: Body, tuning: Tuning) -> None:
        self.body, self.tuning = body, tuning

    def run_step(self, speed_error: float) -> float:
        body = self.body
        wanted = max(-self.tuning.braking, min(3.5, 1.1 * speed_error)) + resistance(body.kind, body.speed)
        if speed_error > -0.15 and body.speed <= 0.0 and speed_error < 0.05:
            return -0.2
        if wanted >= 0.0:
            return min(1.0, wanted / engine(body.kind, body.speed))
        return max(-1.0, wanted / body.kind.braking)


class Lateral:
    """From the distance to a path to a steering value: -1 (left) .. 1 (right)."""

    def __init__(self, body: Body, tuning: Tuning, dt: float, clock: Callable[[], float]) -> None:
        self.body, self.tuning, self.dt, self.clock = body, tuning, dt, clock
        self.path = body.heading
        self.rate = 0.0
        self.last: tuple[float, float, float] | None = None

    def run_step(self, cte: float) -> float:
        body, tuning = self.body, self.tuning
        v = max(abs(body.speed), 0.1)
        self._observe(cte, v)
        error = math.sin(body.heading - self.path)
        reach = min(tuning.sideways, 0.4 * v)
        wanted = -max(-reach, min(reach, tuning.closing * cte))
        push = max(-tuning.lateral, min(tuning.lateral, tuning.damping * (wanted - v * error)))
        floor = max(v, 3.0)
        curvature = self.rate / floor + push / (floor * floor)
        angle = math.atan(body.wheelbase * curvature)
        return max(-1.0, min(1.0, -angle / steering_limit(body.kind, v)))

    def _observe(self, cte: float, v: float) -> None:
        """Follow the path's heading and how fast it turns under the vehicle."""
        body, now = self.body, self.clock()
        if self.last is not None:
            time, distance, heading = self.last
            gone = now - time
            if 0.0 < gone < 2.5 * self.dt:
                step = (cte - distance) / (v * gone)
                self.path += self.rate * gone
                if v > 0.5 and abs(step) < 0.8:
                    seen = 0.5 * (heading + body.heading) - math.asin(step) + 0.5 * self.rate * gone
                    surprise = math.remainder(seen - self.path, math.tau)
                    self.path += 0.55 * surprise
                    most = 4.0 / max(v, 2.0) + 0.35 * v / max(v, 2.0)
                    self.rate = max(-most, min(most, 0.98 * self.rate + 0.16 * surprise / gone))
            elif gone > 0.0:
                self.path, self.rate = body.heading, 0.0
        self.last = (now, cte, body.heading)


def pair(body: Body, tuning: Tuning, dt: float, clock: Callable[[], float]) -> tuple[Longitudinal, Lateral]:
    """The longitudinal and the lateral controller of a vehicle."""
    return Longitudinal(body, tuning), Lateral(body, tuning, dt, clock)

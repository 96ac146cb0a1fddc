"""How vehicles move: pedals and steering to speed and heading, in substeps of 0.02 s.

A kinematic bicycle with a power-limited engine, drag, brakes and a limit of grip. Positions in m, headings in rad
(Scenic's: 0 is north, anticlockwise), speeds in m/s (negative: backwards).
"""

import math
from dataclasses import dataclass

SUBSTEP = 0.02
GRIP = 8.5
"""m/s2: the largest lateral acceleration of a tyre."""


@dataclass(frozen=True)
class VehicleClass:
    """What a class of vehicles can do: m/s2, W/kg, rad; `drag` in 1/m (deceleration = drag * v**2); `mass` in t."""

    acceleration: float
    power: float
    braking: float
    drag: float
    rolling: float = 0.15
    steering: float = 0.7
    handbrake: float = 5.0
    engine_brake: float = 0.6
    mass: float = 1.6


COAST = 0.01
"""Throttle below which the engine brakes."""

CLASSES = {
    "car": VehicleClass(6.0, 100.0, 8.5, 0.00026),
    "van": VehicleClass(4.5, 65.0, 8.0, 0.00035, mass=2.5),
    "pickup": VehicleClass(4.5, 80.0, 8.5, 0.00035, mass=2.3),
    "truck": VehicleClass(3.0, 32.0, 7.0, 0.0003, mass=14.0),
    "bus": VehicleClass(2.5, 28.0, 6.5, 0.0003, steering=0.75, mass=12.0),
    "motorcycle": VehicleClass(6.5, 110.0, 8.0, 0.0006, rolling=0.1, steering=0.55, mass=0.28),
    "bicycle": VehicleClass(2.5, 14.0, 5.0, 0.003, rolling=0.08, steering=0.6, engine_brake=0.0, mass=0.09),
}


def steering_limit(kind: VehicleClass, speed: float) -> float:
    """The wheel angle (rad) of full steering at a speed: it falls as the car is faster."""
    return kind.steering * max(0.55, 1.0 - 0.0125 * abs(speed))


def engine(kind: VehicleClass, speed: float) -> float:
    """The acceleration (m/s2) of full throttle at a speed."""
    return min(kind.acceleration, kind.power / max(abs(speed), 1.0))


def resistance(kind: VehicleClass, speed: float) -> float:
    """The deceleration (m/s2) without pedals."""
    return kind.rolling + kind.drag * speed * speed


class Body:
    """The state of a vehicle's motion."""

    __slots__ = ("kind", "x", "y", "heading", "speed", "sideways", "wheelbase", "throttle", "brake", "steer",
                 "handbrake", "reverse", "yaw_rate", "wheel", "dead")  # fmt: skip

    def __init__(self, kind: VehicleClass, x: float, y: float, heading: float, length: float) -> None:
        self.kind, self.x, self.y, self.heading = kind, x, y, heading
        self.speed = self.sideways = self.yaw_rate = self.wheel = 0.0
        self.wheelbase = 0.6 * length
        self.throttle = self.brake = self.steer = 0.0
        self.handbrake = self.reverse = self.dead = False

    def set_velocity(self, vx: float, vy: float) -> None:
        """Take on a velocity at once (world frame)."""
        sin, cos = math.sin(self.heading), math.cos(self.heading)
        self.speed = -sin * vx + cos * vy
        self.sideways = cos * vx + sin * vy
        if abs(self.sideways) < 1e-6:
            self.sideways = 0.0

    def velocity(self) -> tuple[float, float]:
        """In the world frame."""
        sin, cos = math.sin(self.heading), math.cos(self.heading)
        return -sin * self.speed + cos * self.sideways, cos * self.speed + sin * self.sideways

    def advance(self, dt: float) -> None:
        """One substep of `dt` s."""
        kind, v = self.kind, self.speed
        v = self._along(kind, v, dt)
        if self.sideways:
            self._slide(dt)
        limit = steering_limit(kind, v)
        target = -self.steer * limit
        if v * v > 1.0:
            grip = math.atan(GRIP * self.wheelbase / (v * v))
            target = max(-grip, min(grip, target))
        change = 3.0 * dt
        self.wheel += max(-change, min(change, target - self.wheel))
        slope = math.tan(self.wheel)
        slip = math.atan(0.5 * slope)
        self.yaw_rate = v * math.cos(slip) * slope / self.wheelbase
        middle = self.heading + 0.5 * self.yaw_rate * dt
        course = middle + slip
        sin, cos = math.sin(course), math.cos(course)
        self.x += (-sin * v) * dt
        self.y += (cos * v) * dt
        if self.sideways:
            self.x += math.cos(middle) * self.sideways * dt
            self.y += math.sin(middle) * self.sideways * dt
        self.heading += self.yaw_rate * dt
        self.speed = v

    def _along(self, kind: VehicleClass, v: float, dt: float) -> float:
        if self.dead:
            slow = 6.0
            push = 0.0
        else:
            brake = self.brake
            push = self.throttle * (1.0 - brake) * min(kind.acceleration, kind.power / max(abs(v), 1.0))
            if self.reverse:
                push = -0.6 * push
            slow = brake * kind.braking + kind.drag * v * v + (kind.handbrake if self.handbrake else 0.0)
            if v or not push:
                slow += kind.rolling + (kind.engine_brake if self.throttle < COAST else 0.0)
        v += push * dt
        loss = slow * dt
        if v > loss:
            return v - loss
        if v < -loss:
            return v + loss
        return 0.0 if not push or abs(push) <= slow else v

    def _slide(self, dt: float) -> None:
        loss = GRIP * dt
        self.sideways = math.copysign(max(0.0, abs(self.sideways) - loss), self.sideways)

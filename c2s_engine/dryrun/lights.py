"""Traffic lights: which approaches have them, their phases, and states set by the program.

Approaches of one axis share a phase: green 10 s, yellow 3 s, all red 2 s, then the next axis (CARLA's defaults). A
state that is set moves the junction's cycle there, so that crossing approaches agree with it, and holds for its
approach until that phase would be over.
"""

import math
import random
from dataclasses import dataclass
from typing import Any

import carla

from c2s_engine.maps.extras import ControlPoint, MapExtras

GREEN, YELLOW, ALL_RED = 10.0, 3.0, 2.0
NAMES = {state: str(state).lower() for state in carla.TrafficLightState}
HOLD = 15.0
"""s: how long a state that was set lasts before the cycle goes on."""


@dataclass(eq=False)
class Light(carla.TrafficLight):
    """The light that faces one approach (a road's end at a junction)."""

    junction: str
    road: str
    point: ControlPoint
    plan: "Plan"
    axis: int = 0
    forced: Any = None
    forced_at: float = -1e9

    @property
    def state(self) -> Any:
        if self.forced is not None and (self.plan.frozen or self.plan.now - self.forced_at < HOLD):
            return self.forced
        return self.plan.cycle_state(self.axis)

    def get_state(self) -> Any:
        return self.state

    def set_state(self, state: Any) -> None:
        """Set this light; the crossing approaches follow."""
        self.forced, self.forced_at = state, self.plan.now
        self.plan.jump(self.axis, state)

    def freeze(self, freeze: bool) -> None:
        self.plan.freeze(freeze)

    def get_location(self) -> Any:
        return carla.Location(self.point.x, -self.point.y, 0.0)


class Plan:
    """The cycle of one junction."""

    def __init__(self, offset: float) -> None:
        self.lights: list[Light] = []
        self.axes = 1
        self.now = 0.0
        self.shift = offset
        self.frozen = False

    @property
    def period(self) -> float:
        return max(2, self.axes) * (GREEN + YELLOW + ALL_RED)

    def cycle_state(self, axis: int) -> Any:
        phase = (self.now + self.shift - axis * (GREEN + YELLOW + ALL_RED)) % self.period
        if phase < GREEN:
            return carla.TrafficLightState.Green
        return carla.TrafficLightState.Yellow if phase < GREEN + YELLOW else carla.TrafficLightState.Red

    def jump(self, axis: int, state: Any) -> None:
        """Move the cycle to where that axis shows that state."""
        phase = GREEN + YELLOW + ALL_RED
        start = {carla.TrafficLightState.Green: 0.0, carla.TrafficLightState.Yellow: GREEN}.get(state, phase)
        if self.cycle_state(axis) != state and state in tuple(carla.TrafficLightState)[:3]:
            self.shift = axis * phase + start - self.now

    def freeze(self, frozen: bool) -> None:
        self.frozen = bool(frozen)

    def tick(self, dt: float) -> None:
        if self.frozen:
            self.shift -= dt
        self.now += dt


class Lights:
    """All lights of a map."""

    def __init__(self, extras: MapExtras | None, rng: random.Random) -> None:
        self.plans: dict[str, Plan] = {}
        self.by_approach: dict[tuple[str, str], Light] = {}
        for control in extras.controls if extras else ():
            if control.kind == "signal" and control.junction is not None:
                self._add(control, rng)
        for plan in self.plans.values():
            self._axes(plan)

    def _add(self, control: ControlPoint, rng: random.Random) -> None:
        junction, road = str(control.junction), str(control.road)
        if (junction, road) in self.by_approach:
            return
        plan = self.plans.setdefault(junction, Plan(rng.uniform(0.0, 30.0)))
        light = Light(junction, road, control, plan)
        plan.lights.append(light)
        self.by_approach[junction, road] = light

    @staticmethod
    def _axes(plan: Plan) -> None:
        directions: list[float] = []
        for light in plan.lights:
            heading = light.point.heading % math.pi
            for i, known in enumerate(directions):
                if abs(math.remainder(heading - known, math.pi)) < math.radians(45):
                    light.axis = i
                    break
            else:
                light.axis = len(directions)
                directions.append(heading)
        plan.axes = len(directions)

    def tick(self, dt: float) -> None:
        for plan in self.plans.values():
            plan.tick(dt)

    def freeze(self, frozen: bool) -> None:
        for plan in self.plans.values():
            plan.freeze(frozen)

    def states(self) -> dict[tuple[str, str], str]:
        """The state of every approach, in lower case."""
        return {key: NAMES[light.state] for key, light in self.by_approach.items()}

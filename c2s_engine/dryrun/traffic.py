"""CARLA's traffic manager: vehicles on autopilot follow their lane, keep their distance and stop at red lights."""

import math
import random
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from c2s_engine.dryrun.dynamics import engine, resistance, steering_limit
from c2s_engine.dryrun.roads import RoadIndex, polyline, project

DEFAULT_SPEED = 30 / 3.6
"""m/s, where the map has no limit (CARLA's)."""
MARGIN = 0.7
"""CARLA's traffic drives 30 % below the limit unless told otherwise."""
COMFORT = 3.0
AHEAD = 60.0


@dataclass
class Pilot:
    """What one vehicle was told, and its route (a polyline)."""

    speed: float | None = None
    difference: float | None = None
    ignore_lights: float = 0.0
    ignore_walkers: float = 0.0
    ignore_vehicles: float = 0.0
    gap: float = 2.5
    route: list[Any] | None = None
    line: np.ndarray = field(default_factory=lambda: np.empty((0, 2)))  # m; empty: no way is planned yet
    along: np.ndarray = field(default_factory=lambda: np.empty(0))
    lanes: tuple[int, ...] = ()


class TrafficManager:
    """The settings that actions make, and the drivers behind them."""

    def __init__(self, world: Any, index: RoadIndex, rng: random.Random) -> None:
        self.world, self.index, self.rng = world, index, rng
        self.pilots: dict[int, Pilot] = {}
        self.difference = 0.0

    def _of(self, actor: Any) -> Pilot:
        return self.pilots.setdefault(actor.id, Pilot())

    def get_port(self) -> int:
        return 8000

    def set_synchronous_mode(self, mode: bool) -> None:
        """Always so."""

    def set_random_device_seed(self, seed: int) -> None:
        self.rng.seed(seed)

    def set_desired_speed(self, actor: Any, speed: float) -> None:
        """km/h."""
        self._of(actor).speed = speed / 3.6

    def vehicle_percentage_speed_difference(self, actor: Any, percentage: float) -> None:
        self._of(actor).difference = percentage

    def global_percentage_speed_difference(self, percentage: float) -> None:
        self.difference = percentage

    def auto_lane_change(self, actor: Any, enable: bool) -> None:
        """Autopilots here stay in their lanes unless they are given a route."""

    def set_route(self, actor: Any, path: Any) -> None:
        self._of(actor).route = list(path)

    def set_path(self, actor: Any, path: Any) -> None:
        points = np.array([(p.x, -p.y) for p in path], dtype=float)
        pilot = self._of(actor)
        if len(points) >= 2:
            pilot.line, (pilot.along, _) = points, polyline(points)

    def update_vehicle_lights(self, actor: Any, enable: bool) -> None:
        """Lights are not shown."""

    def ignore_signs_percentage(self, actor: Any, percentage: float) -> None:
        """Signs are not obeyed by autopilots here."""

    def ignore_lights_percentage(self, actor: Any, percentage: float) -> None:
        self._of(actor).ignore_lights = percentage

    def ignore_walkers_percentage(self, actor: Any, percentage: float) -> None:
        self._of(actor).ignore_walkers = percentage

    def ignore_vehicles_percentage(self, actor: Any, percentage: float) -> None:
        self._of(actor).ignore_vehicles = percentage

    def distance_to_leading_vehicle(self, actor: Any, distance: float) -> None:
        self._of(actor).gap = distance

    def force_lane_change(self, actor: Any, direction: bool) -> None:
        """Take the neighbouring lane's path (True: to the right)."""
        body = actor.body
        lane = self.index.lane_at(body.x, body.y, body.heading)
        if lane is None:
            return
        info = self.index.lanes[lane]
        beside = sorted(info.right if direction else info.left)
        if beside:
            self._plan(self._of(actor), beside[0], body)

    def drive(self, actor: Any, dt: float) -> None:
        """Set the pedals and the wheel of a vehicle on autopilot for one step."""
        body, pilot = actor.body, self._of(actor)
        if not pilot.line.size or self._near_end(pilot, body):
            lane = self.index.lane_at(body.x, body.y, body.heading)
            if lane is None:
                body.throttle, body.brake = 0.0, 1.0
                return
            self._plan(pilot, lane, body)
        s, _ = project(pilot.line, pilot.along, np.array([[body.x, body.y]]))
        here = float(s[0])
        self._steer(pilot, body, here)
        self._pedals(actor, pilot, here)

    def _near_end(self, pilot: Pilot, body: Any) -> bool:
        last = pilot.line[-1]
        return math.hypot(last[0] - body.x, last[1] - body.y) < 60.0 and bool(pilot.lanes) and bool(
            self.index.lanes[pilot.lanes[-1]].next)  # fmt: skip

    def _plan(self, pilot: Pilot, lane: int, body: Any) -> None:
        start = self.index.lanes[lane].project(body.x, body.y)[0]
        choose = None
        if pilot.route:
            wishes = [str(w).lower() for w in pilot.route]
            choose = lambda ways: self._wish(ways, wishes)  # noqa: E731
        elif pilot.lanes and lane in pilot.lanes:
            known = set(pilot.lanes)
            choose = lambda ways: next((w for w in ways if w in known), self.rng.choice(ways))  # noqa: E731
        else:
            choose = self.rng.choice
        lanes = self.index.path(lane, 250.0, choose, start)
        pilot.lanes = tuple(lanes)
        pilot.line = self.index.line(lanes)
        pilot.along, _ = polyline(pilot.line)

    def _wish(self, ways: tuple[int, ...], wishes: list[str]) -> int:
        if len(ways) == 1 or not wishes:
            return ways[0]
        wish = wishes.pop(0)
        turns = {w: math.remainder(float(self.index.lanes[w].headings[-1] - self.index.lanes[w].headings[0]), math.tau)
                 for w in ways}  # fmt: skip
        aim = {"left": 1.5, "right": -1.5}.get(wish, 0.0)
        return min(ways, key=lambda w: abs(turns[w] - aim))

    @staticmethod
    def _steer(pilot: Pilot, body: Any, here: float) -> None:
        look = max(3.0, 0.45 * abs(body.speed))
        target = min(here + look, float(pilot.along[-1]))
        x, y = np.interp(target, pilot.along, pilot.line[:, 0]), np.interp(target, pilot.along, pilot.line[:, 1])
        bearing = math.remainder(math.atan2(-(x - body.x), y - body.y) - body.heading, math.tau)
        distance = max(math.hypot(x - body.x, y - body.y), 1.0)
        angle = math.atan(2.0 * body.wheelbase * math.sin(bearing) / distance)
        body.steer = max(-1.0, min(1.0, -angle / steering_limit(body.kind, body.speed)))

    def _pedals(self, actor: Any, pilot: Pilot, here: float) -> None:
        body = actor.body
        wanted = self._cruise(actor, pilot)
        wanted = min(wanted, self._curve(pilot, here))
        stop = self._room(actor, pilot, here)
        if stop < AHEAD:
            wanted = min(wanted, math.sqrt(max(0.0, 2.0 * COMFORT * (stop - pilot.gap))))
        push = max(-body.kind.braking, min(3.0, 1.5 * (wanted - body.speed))) + resistance(body.kind, body.speed)
        if wanted < 0.1 and body.speed < 0.5:
            body.throttle, body.brake = 0.0, 0.5
        elif push >= 0:
            body.throttle, body.brake = min(1.0, push / engine(body.kind, body.speed)), 0.0
        else:
            body.throttle, body.brake = 0.0, min(1.0, -push / body.kind.braking)
        body.reverse = body.handbrake = False

    def _cruise(self, actor: Any, pilot: Pilot) -> float:
        if pilot.speed is not None:
            return pilot.speed
        lane = self.index.lane_at(actor.body.x, actor.body.y, actor.body.heading)
        limit = self.world.limit(self.index.lanes[lane].road) if lane is not None else None
        if pilot.difference is None and not self.difference:
            return (limit or DEFAULT_SPEED) * (MARGIN if limit else 1.0)
        difference = self.difference if pilot.difference is None else pilot.difference
        return (limit or DEFAULT_SPEED) * max(0.0, 1.0 - difference / 100.0)

    @staticmethod
    def _curve(pilot: Pilot, here: float) -> float:
        """Slow enough for the bends of the next 25 m at 2.5 m/s2 sideways."""
        ss = here + np.array([0.0, 4.0, 8.0, 12.0, 16.0, 20.0, 25.0])
        x, y = np.interp(ss, pilot.along, pilot.line[:, 0]), np.interp(ss, pilot.along, pilot.line[:, 1])
        heading = np.arctan2(np.diff(x), np.diff(y))
        step = np.hypot(np.diff(x), np.diff(y))
        turn = np.abs(np.remainder(np.diff(heading) + np.pi, 2 * np.pi) - np.pi) / np.maximum(step[1:], 0.5)
        room = ss[1:-1] - here
        allowed = np.sqrt(2.5 / np.maximum(turn, 1e-4) + 2.0 * COMFORT * room)
        return float(allowed.min())

    def _room(self, actor: Any, pilot: Pilot, here: float) -> float:
        """m of free way ahead: up to whoever stands or drives on it, or to a red light's line."""
        body, room = actor.body, math.inf
        front = here + actor.size[0] / 2
        for other in self.world.actors:
            if other is actor:
                continue
            walker = other.type_id.startswith("walker.")
            if self.rng.random() * 100.0 < (pilot.ignore_walkers if walker else pilot.ignore_vehicles):
                continue
            dx, dy = other.body.x - body.x, other.body.y - body.y
            if dx * dx + dy * dy > 60.0 * 60.0:
                continue
            s, d = project(pilot.line, pilot.along, np.array([[other.body.x, other.body.y]]))
            if s[0] - here > 0.0 and abs(d[0]) < 0.5 * (actor.size[1] + other.size[1]) + 0.3:
                gap = float(s[0]) - front - other.size[0] / 2
                vx, vy = other.body.velocity()
                along = max(0.0, -math.sin(body.heading) * vx + math.cos(body.heading) * vy)
                room = min(room, max(0.0, gap) + along * along / (2.0 * COMFORT))
        if self.rng.random() * 100.0 >= pilot.ignore_lights:
            line = self.world.red_ahead(actor)
            if line is not None:
                room = min(room, max(0.0, line - actor.size[0] / 2) + pilot.gap - 0.5)
        return room

"""CARLA's controller of walkers: leads a person along the sidewalk towards a goal."""

import math
from typing import Any

import carla
import numpy as np
import shapely

from c2s_engine.dryrun.roads import RoadIndex, polyline, project


class Guide(carla.WalkerAIController):
    """Leads its walker along the middle of the sidewalk that it is on, to the end that is nearer to its goal."""

    def __init__(self, walker: Any, index: RoadIndex) -> None:
        self.walker, self.index = walker, index
        self.active, self.is_alive = False, True
        self.speed = 1.4
        self.line: np.ndarray | None = None
        walker.guide = self

    def start(self) -> None:
        self.active = True

    def stop(self) -> None:
        self.active = False
        self.walker.body.speed = 0.0

    def destroy(self) -> None:
        self.stop()
        self.is_alive = False

    def set_max_speed(self, speed: float = 1.4) -> None:
        self.speed = float(speed)

    def go_to_location(self, destination: Any) -> None:
        """Choose the way: along the nearest sidewalk if one is near, else straight to the goal."""
        body = self.walker.body
        here = shapely.Point(body.x, body.y)
        goal = np.array([destination.x, -destination.y]) if destination is not None else None
        walks = self.index.network.sidewalks
        if walks:
            nearest = walks[int(self.index.walks.nearest(here))]
            if nearest.polygon.distance(here) < 3.0:
                points = np.array([p[:2] for p in nearest.centerline.points], dtype=float)
                if goal is not None and np.hypot(*(points[0] - goal)) < np.hypot(*(points[-1] - goal)):
                    points = points[::-1]
                self.line = points
                return
        self.line = None if goal is None else np.array([[body.x, body.y], goal])

    def lead(self, dt: float) -> None:
        """One substep: head for a point of the line 1.5 m ahead; stand at its end."""
        body = self.walker.body
        if self.line is None or len(self.line) < 2:
            body.speed = 0.0
            return
        along, _ = polyline(self.line)
        s, _ = project(self.line, along, np.array([[body.x, body.y]]))
        if s[0] >= along[-1] - 0.3:
            body.speed = 0.0
            return
        target = min(float(s[0]) + 1.5, float(along[-1]))
        x, y = np.interp(target, along, self.line[:, 0]), np.interp(target, along, self.line[:, 1])
        body.heading = math.atan2(-(x - body.x), y - body.y)
        body.speed, body.sideways = self.speed, 0.0

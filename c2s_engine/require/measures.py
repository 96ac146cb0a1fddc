"""What the tracks of a run say in numbers: gaps, time to collision, post-encroachment time, required deceleration.

All arrays have one value a step. Boxes are the objects' own; `ahead` and `left` are measured along ego's whole way
(what it drove and will drive in this run, carried on straight at both ends). SI units.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import shapely

from c2s_engine.structure.facts import EGO, Track, Trajectories

Array = np.ndarray[Any, np.dtype[np.float64]]

HORIZON = 10.0
"""s: a collision that far away is none (Hydén 1987 and most since look at less)."""
STANDING = 0.5
"""m/s: slower than that is standing."""
CROSSING = np.radians(20)
"""Who comes at less of an angle than that follows or meets head-on, and encroaches on no crossing path."""
BEYOND = 300.0


class Line:
    """Ego's way as a line to measure along."""

    def __init__(self, track: Track) -> None:
        points = np.column_stack([track.x, track.y])
        kept = [points[0]]
        for point in points[1:]:
            if np.hypot(*(point - kept[-1])) > 0.3:
                kept.append(point)
        start, end = track.heading[0], track.heading[-1]
        first = kept[0] - BEYOND * np.array([-np.sin(start), np.cos(start)])
        last = kept[-1] + BEYOND * np.array([-np.sin(end), np.cos(end)])
        self.line = shapely.LineString([first, *kept, last])

    def place(self, track: Track) -> tuple[Array, Array]:
        """(m along, m to the left) of a track's centre at each step."""
        points = shapely.points(np.column_stack([track.x, track.y]))
        along = shapely.line_locate_point(self.line, points)
        near = shapely.line_interpolate_point(self.line, along)
        on = shapely.line_interpolate_point(self.line, along + 0.5)
        dx, dy = shapely.get_x(on) - shapely.get_x(near), shapely.get_y(on) - shapely.get_y(near)
        px, py = shapely.get_x(points) - shapely.get_x(near), shapely.get_y(points) - shapely.get_y(near)
        side = np.sign(dx * py - dy * px)
        return along, side * np.hypot(px, py)


def boxes(track: Track) -> Any:
    """The object's box at each step, as polygons."""
    x, y, heading = (np.asarray(v) for v in (track.x, track.y, track.heading))
    sin, cos = np.sin(heading), np.cos(heading)
    half = ((1, -1), (-1, -1), (-1, 1), (1, 1))
    ring = [
        np.column_stack([
            x - a * sin * track.length / 2 + b * cos * track.width / 2,
            y + a * cos * track.length / 2 + b * sin * track.width / 2,
        ])
        for a, b in half
    ]  # fmt: skip
    return shapely.polygons(np.stack(ring, axis=1))


@dataclass(frozen=True)
class Pair:
    """Ego and one other."""

    step: float
    ego: Track
    other: Track
    line: Line

    @cached_property
    def gap(self) -> Array:
        """m between the two boxes; 0 where they touch."""
        return np.asarray(shapely.distance(boxes(self.ego), boxes(self.other)))

    @cached_property
    def ahead(self) -> Array:
        """m along ego's way from ego's centre to the other's; negative behind."""
        return self.line.place(self.other)[0] - self.line.place(self.ego)[0]

    @cached_property
    def left(self) -> Array:
        """m from ego's way to the other's centre; negative to the right."""
        return self.line.place(self.other)[1]

    @cached_property
    def ttc(self) -> Array:
        """s until the boxes touch if both keep speed and heading (swept boxes, separating axes); inf where they do not.

        0 from the first contact on is no longer a time to collision and is left out: inf there."""
        found = _time_to_touch(self.ego, self.other)
        found[found > HORIZON] = np.inf
        touched = np.flatnonzero(self.gap <= 0)
        if len(touched):
            found[touched[0] + 1 :] = np.inf
        return found

    @cached_property
    def required(self) -> Array:
        """m/s2 that ego must brake with so as not to reach the other on its way (DRAC)."""
        reach = (self.ego.width + self.other.width) / 2
        along = np.gradient(self.line.place(self.other)[0], self.step)
        closing = np.asarray(self.ego.speed) - along
        gap = self.gap
        inside = (self.ahead > 0) & (np.abs(self.left) < reach + 0.3) & (closing > 0.1) & (gap > 0.1)
        touched = np.flatnonzero(gap <= 0)
        if len(touched):
            inside[touched[0] :] = False
        return np.where(inside, closing**2 / (2 * np.maximum(gap, 0.1)), 0.0)

    @cached_property
    def pet(self) -> tuple[float, float] | None:
        """(s between the one leaving and the other reaching a place on both ways, when the later one reached it);
        None where their ways do not cross while both move. 0: they touch."""
        a, b = boxes(self.ego), boxes(self.other)
        moving_a, moving_b = np.asarray(self.ego.speed) > STANDING, np.asarray(self.other.speed) > STANDING
        tree = shapely.STRtree(b)
        i, j = tree.query(a, predicate="intersects")
        turn = np.abs(_wrapped(np.asarray(self.ego.heading)[i] - np.asarray(self.other.heading)[j]))
        kept = moving_a[i] & moving_b[j] & (turn > CROSSING) & (turn < np.pi - CROSSING)
        if not kept.any():
            return None
        i, j = i[kept], j[kept]
        apart = np.abs(i - j)
        best = int(np.argmin(apart))
        return float(apart[best] * self.step), float(max(i[best], j[best]) * self.step)


def pairs(ways: Trajectories) -> list[Pair]:
    """Ego with each other object, in the run's order; none where there is no ego."""
    ego = next((t for t in ways.tracks if t.name == EGO), None)
    if ego is None or not ego.x:
        return []
    line = Line(ego)
    return [Pair(ways.step, ego, t, line) for t in ways.tracks if t is not ego]


def _wrapped(angle: Array) -> Array:
    return np.remainder(angle + np.pi, 2 * np.pi) - np.pi


def _time_to_touch(a: Track, b: Track) -> Array:
    """s until two boxes that keep their velocities touch, at each step; inf where they never do."""
    ax, ay, ah, av = (np.asarray(v) for v in (a.x, a.y, a.heading, a.speed))
    bx, by, bh, bv = (np.asarray(v) for v in (b.x, b.y, b.heading, b.speed))
    dx, dy = bx - ax, by - ay
    vx, vy = -bv * np.sin(bh) + av * np.sin(ah), bv * np.cos(bh) - av * np.cos(ah)
    begin, end = np.zeros(len(ax)), np.full(len(ax), np.inf)
    for heading in (ah, bh):
        for nx, ny in ((-np.sin(heading), np.cos(heading)), (np.cos(heading), np.sin(heading))):
            reach = _half(a, ah, nx, ny) + _half(b, bh, nx, ny)
            at, speed = dx * nx + dy * ny, vx * nx + vy * ny
            with np.errstate(divide="ignore", invalid="ignore"):
                one, two = (-reach - at) / speed, (reach - at) / speed
            still = np.abs(speed) < 1e-9
            inside = np.abs(at) <= reach
            begin = np.maximum(begin, np.where(still, np.where(inside, 0, np.inf), np.minimum(one, two)))
            end = np.minimum(end, np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(one, two)))
    return np.where((begin <= end) & (end >= 0), begin, np.inf)


def _half(track: Track, heading: Array, nx: Array, ny: Array) -> Array:
    """Half a box's extent along a direction."""
    along = np.abs(-np.sin(heading) * nx + np.cos(heading) * ny)
    across = np.abs(np.cos(heading) * nx + np.sin(heading) * ny)
    return track.length / 2 * along + track.width / 2 * across

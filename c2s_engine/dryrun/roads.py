"""The road network as arrays: which lane a point is in, where along it, and what comes next. One index per network.

Positions in m, headings in rad (Scenic's: 0 is north, anticlockwise).
"""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
import shapely

TOUCH = 0.1
"""m: a point so near to a lane is in it (lanes of one road may leave slivers between them)."""


@dataclass
class LaneInfo:
    """A lane (also of a junction): its middle line and its neighbours, by index."""

    index: int
    lane: Any
    road: str
    points: np.ndarray
    along: np.ndarray
    headings: np.ndarray
    junction: str | None
    left: set[int] = field(default_factory=set)
    right: set[int] = field(default_factory=set)
    opposite: set[int] = field(default_factory=set)
    next: tuple[int, ...] = ()
    width: float = 3.5

    @property
    def length(self) -> float:
        return float(self.along[-1])

    def project(self, x: float, y: float) -> tuple[float, float]:
        """(distance along, distance to the left) of a point."""
        s, d = self.project_many(np.array([[x, y]]))
        return float(s[0]), float(d[0])

    def project_many(self, xy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The same for many points at once; beyond the ends the end segments go on."""
        return project(self.points, self.along, xy)

    def heading_at(self, s: float) -> float:
        """The lane's direction at a distance along it."""
        i = int(np.searchsorted(self.along, s, side="right")) - 1
        return float(self.headings[min(max(i, 0), len(self.headings) - 1)])

    def point_at(self, s: float) -> tuple[float, float]:
        """The point of the middle line at a distance along it."""
        return float(np.interp(s, self.along, self.points[:, 0])), float(np.interp(s, self.along, self.points[:, 1]))


def project(points: np.ndarray, along: np.ndarray, xy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Project points on a polyline: (distance along, distance to the left); the end segments go on beyond the ends."""
    a, b = points[:-1], points[1:]
    ab = b - a
    length = np.maximum(np.hypot(ab[:, 0], ab[:, 1]), 1e-9)
    unit = ab / length[:, None]
    rel = xy[:, None, :] - a[None, :, :]
    t = rel[..., 0] * unit[:, 0] + rel[..., 1] * unit[:, 1]
    low = np.zeros(len(length))
    high = length.copy()
    low[0], high[-1] = -np.inf, np.inf
    t = np.clip(t, low, high)
    dx = rel[..., 0] - t * unit[:, 0]
    dy = rel[..., 1] - t * unit[:, 1]
    distance = np.hypot(dx, dy)
    best = distance.argmin(axis=1)
    rows = np.arange(len(xy))
    s = along[best] + t[rows, best]
    side = unit[best, 0] * rel[rows, best, 1] - unit[best, 1] * rel[rows, best, 0]
    return s, np.where(side >= 0, distance[rows, best], -distance[rows, best])


def polyline(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(distances along, headings of the segments) of a polyline."""
    step = np.diff(points, axis=0)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(step[:, 0], step[:, 1]))])
    return along, np.arctan2(-step[:, 0], step[:, 1])


class RoadIndex:
    """Fast questions to a network."""

    def __init__(self, network: Any) -> None:
        self.network = network
        self.lanes: list[LaneInfo] = []
        self.number: dict[str, int] = {}
        junction_of = {
            maneuver.connectingLane.uid: str(crossing.id)
            for crossing in network.intersections
            for maneuver in crossing.maneuvers
            if maneuver.connectingLane is not None
        }
        for i, lane in enumerate(network.lanes):
            points = np.array([p[:2] for p in lane.centerline.points], dtype=float)
            keep = np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 1e-6])
            points = points[keep]
            along, headings = polyline(points)
            width = lane.polygon.area / max(float(along[-1]), 1.0)
            road = str(lane.road.id)
            self.lanes.append(LaneInfo(i, lane, road, points, along, headings, junction_of.get(lane.uid), width=width))
            self.number[lane.uid] = i
        self.tree = shapely.STRtree([lane.polygon for lane in network.lanes])
        for info in self.lanes:
            self._link(info)

    def _link(self, info: LaneInfo) -> None:
        lane = info.lane
        for section in lane.sections:
            for neighbour, found in ((section._laneToLeft, info.left), (section._laneToRight, info.right)):
                if neighbour is not None and neighbour.isForward == section.isForward:
                    found.add(self.number[neighbour.lane.uid])
        if lane.group._opposite is not None:
            info.opposite.update(self.number[other.uid] for other in lane.group._opposite.lanes)
        ways = []
        for maneuver in lane.maneuvers:
            target = maneuver.connectingLane or maneuver.endLane
            ways.append(self.number[target.uid])
        if not ways and lane._successor is not None and getattr(lane._successor, "uid", None) in self.number:
            ways.append(self.number[lane._successor.uid])
        info.next = tuple(dict.fromkeys(ways))

    def warm(self) -> None:
        """Make the parts that are made on first use."""
        _ = self.junctions, self.off_road, self.walks, self.previous
        for tree in (self.tree, self.off_road, self.walks):
            tree.query(shapely.Point(0.0, 0.0))

    @cached_property
    def junctions(self) -> dict[str, Any]:
        """Scenic's intersections by the id that the map gives them."""
        return {str(crossing.id): crossing for crossing in self.network.intersections}

    @cached_property
    def _hulls(self) -> tuple[list[str], shapely.STRtree]:
        names = list(self.junctions)
        return names, shapely.STRtree([shapely.convex_hull(self.junctions[n].polygon) for n in names])

    def junctions_around(self, xy: np.ndarray) -> list[str | None]:
        """The junction between whose ways, or beside them, each point (x, y) lies: who rides past on no lane."""
        names, tree = self._hulls
        found: list[str | None] = [None] * len(xy)
        for point, hull in tree.query(shapely.points(xy), predicate="within").T:
            found[int(point)] = names[int(hull)]
        return found

    @cached_property
    def off_road(self) -> shapely.STRtree:
        """Shoulders, parking lanes and sidewalks."""
        return shapely.STRtree([e.polygon for e in (*self.network.shoulders, *self.network.sidewalks)])

    @cached_property
    def walks(self) -> shapely.STRtree:
        """Sidewalks."""
        return shapely.STRtree([e.polygon for e in self.network.sidewalks])

    @cached_property
    def previous(self) -> dict[int, tuple[int, ...]]:
        """The lanes that lead into each lane."""
        found: dict[int, list[int]] = {}
        for info in self.lanes:
            for other in info.next:
                found.setdefault(other, []).append(info.index)
        return {i: tuple(v) for i, v in found.items()}

    def containing(self, xy: np.ndarray, distance: float = TOUCH) -> list[list[int]]:
        """For each point the indices of the lanes that hold it."""
        found: list[list[int]] = [[] for _ in range(len(xy))]
        if len(xy):
            points, lanes = self.tree.query(shapely.points(xy), predicate="dwithin", distance=distance)
            for point, lane in zip(points.tolist(), lanes.tolist(), strict=True):
                found[point].append(lane)
        return found

    def lane_at(self, x: float, y: float, heading: float | None = None) -> int | None:
        """The lane that a point is in; of several the one whose direction and middle fit best."""
        candidates = self.containing(np.array([[x, y]]))[0]
        if not candidates:
            return None
        return min(candidates, key=lambda i: self.misfit(i, x, y, heading))

    def misfit(self, index: int, x: float, y: float, heading: float | None) -> float:
        """How badly a lane fits a vehicle there: m to the side, 4 a radian of heading."""
        s, d = self.lanes[index].project(x, y)
        turn = (
            0.0
            if heading is None
            else abs(np.remainder(heading - self.lanes[index].heading_at(s) + np.pi, 2 * np.pi) - np.pi)
        )
        return abs(d) + 4.0 * float(turn)

    def ahead(self, index: int, choose: Any = None) -> int | None:
        """The lane that continues a lane: the straightest, or the one that `choose` picks."""
        ways = self.lanes[index].next
        if not ways:
            return None
        if choose is not None:
            return choose(ways)
        end = self.lanes[index].headings[-1]

        def bend(i: int) -> float:
            return abs(float(np.remainder(self.lanes[i].headings[-1] - end + np.pi, 2 * np.pi) - np.pi))

        return min(ways, key=bend)

    def path(self, index: int, length: float, choose: Any = None, start: float = 0.0) -> list[int]:
        """The lane and those that continue it, at least `length` m from `start` on."""
        found, total = [index], self.lanes[index].length - start
        while total < length:
            nxt = self.ahead(found[-1], choose)
            if nxt is None or len(found) > 60:
                break
            found.append(nxt)
            total += self.lanes[nxt].length
        return found

    def line(self, indices: list[int]) -> np.ndarray:
        """The middle lines of consecutive lanes as one polyline."""
        points = np.concatenate([self.lanes[i].points for i in indices])
        keep = np.concatenate([[True], np.hypot(*np.diff(points, axis=0).T) > 0.05])
        return points[keep]


_indices: dict[int, RoadIndex] = {}


def index_of(network: Any) -> RoadIndex:
    """The index of a network, made once."""
    found = _indices.get(id(network))
    if found is None or found.network is not network:
        found = _indices[id(network)] = RoadIndex(network)
    return found

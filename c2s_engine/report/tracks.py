"""The tracks of a run as a table that a person can read: twice a second, who is where and how fast."""

from typing import Any

import numpy as np
import shapely

from c2s_engine.require.measures import Pair, pairs
from c2s_engine.structure.facts import EGO, Track, Trajectories

EVERY = 0.5
"""s between two rows."""
OFF_LANES = ("crosswalk", "junction", "shoulder", "sidewalk")


class Roads:
    """The road parts around a run."""

    def __init__(self, ways: Trajectories) -> None:
        self.rings = {k: [shapely.Polygon(r) for r in rings] for k, rings in ways.outline.items()}

    def lane(self, x: float, y: float) -> int | None:
        """The number of the lane polygon that a point lies in."""
        point = shapely.Point(x, y)
        return next((n for n, ring in enumerate(self.rings.get("lane", [])) if ring.covers(point)), None)

    def part(self, x: float, y: float) -> str:
        """The kind of road part that a point lies in; empty: none."""
        point = shapely.Point(x, y)
        lane = self.lane(x, y) is not None
        kinds = ("crosswalk", "junction") if lane else OFF_LANES
        found = next((k for k in kinds if any(r.covers(point) for r in self.rings.get(k, []))), "")
        return found or ("lane" if lane else "")


def rows(ways: Trajectories, every: float = EVERY) -> list[dict[str, Any]]:
    """One row each `every` s: time (s), ego's speed (km/h) and road part; each other's speed (km/h), gap between the
    boxes (m), m ahead along ego's way (negative: behind), m to the left of it (negative: right), and where it is."""
    ego = next((t for t in ways.tracks if t.name == EGO), None)
    if ego is None:
        return []
    roads, known = Roads(ways), pairs(ways)
    steps = range(0, len(ego.x), max(1, round(every / ways.step)))
    found = []
    for k in steps:
        others = {p.other.name: _row(p, k, roads) for p in known}
        place = roads.part(ego.x[k], ego.y[k]) or "off the road"
        found.append({"time": round(k * ways.step, 2), "speed": _kmh(ego, k), "where": place, "others": others})
    return found


def _row(pair: Pair, k: int, roads: Roads) -> dict[str, Any]:
    return {
        "speed": _kmh(pair.other, k),
        "gap": _rounded(pair.gap[k]),
        "ahead": _rounded(pair.ahead[k]),
        "left": _rounded(pair.left[k]),
        "where": _relation(pair, k, roads),
    }


def _rounded(value: float) -> float:
    """To 0.1, without a minus before nothing."""
    return round(float(value), 1) + 0.0


def _kmh(track: Track, k: int) -> float:
    return _rounded(track.speed[k] * 3.6)


def _relation(pair: Pair, k: int, roads: Roads) -> str:
    """Where the other is, as seen from ego: on which lane, in the junction, beside the road."""
    ego, other = pair.ego, pair.other
    part = roads.part(other.x[k], other.y[k])
    lane = roads.lane(other.x[k], other.y[k])
    if lane is None:
        return part or "off the road"
    beside = f", {part}" if part != "lane" else ""
    if lane == roads.lane(ego.x[k], ego.y[k]):
        return f"ego's lane{beside}"
    turn = np.degrees(np.abs(np.remainder(other.heading[k] - ego.heading[k] + np.pi, 2 * np.pi) - np.pi))
    if abs(pair.left[k]) < (ego.width + 1) / 2:
        return f"on ego's way{beside}"
    if other.kind == "walker" or 45 <= turn <= 135:
        return f"{'lane' if other.kind == 'walker' else 'crossing road'}{beside}"
    side = "left" if pair.left[k] > 0 else "right"
    return f"{'lane' if turn < 45 else 'oncoming lane'} to the {side}{beside}"

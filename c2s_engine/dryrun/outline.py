"""The road around a run as plain polygons, for the pictures. In the check process only (it needs the network)."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely

from c2s_engine.dryrun.recording import Recording
from c2s_engine.maps.extras import MapExtras

Ring = tuple[tuple[float, float], ...]
Box = tuple[float, float, float, float]
MARGIN = 30.0
"""m around the actors that are shown."""
ARROW_EVERY, ARROW_LONG, ARROW_WIDE = 25.0, 3.0, 1.2
"""m between the arrows of a lane, and their size."""


def box_of(recording: Recording) -> Box:
    """(west, south, east, north) of what moves and stands in a run, with a margin."""
    xs = [float(v) for p in recording.paths for v in (p.x.min(), p.x.max())]
    ys = [float(v) for p in recording.paths for v in (p.y.min(), p.y.max())]
    return min(xs) - MARGIN, min(ys) - MARGIN, max(xs) + MARGIN, max(ys) + MARGIN


def map_outline(network: Any, box: Box, extras: MapExtras | None = None) -> dict[str, tuple[Ring, ...]]:
    """Outlines by kind (sidewalk, shoulder, junction, lane, crosswalk, arrow) within a box; m, in drawing order."""
    area = shapely.box(*box)
    crosswalks = [shapely.Polygon(c.polygon) for c in extras.crosswalks] if extras else []
    kinds: dict[str, list[Any]] = {
        "sidewalk": [e.polygon for e in network.sidewalks],
        "shoulder": [e.polygon for e in network.shoulders],
        "junction": [e.polygon for e in network.intersections],
        "lane": [lane.polygon for road in network.roads for lane in road.lanes],
        "crosswalk": crosswalks,
    }
    outlines = {kind: tuple(_rings(shapes, area)) for kind, shapes in kinds.items() if shapes}
    lanes = [lane.centerline.lineString for road in network.roads for lane in road.lanes]
    return {**outlines, "arrow": tuple(_arrows(lanes, area))}


def _arrows(lines: list[Any], area: Any) -> Iterator[Ring]:
    """Small triangles along the lanes that point where one drives: tip first."""
    for line in lines:
        if not line.intersects(area):
            continue
        for along in np.arange(ARROW_EVERY / 2, line.length, ARROW_EVERY):
            (x, y), (tip_x, tip_y) = (line.interpolate(a).coords[0][:2] for a in (along, along + ARROW_LONG))
            long = math.hypot(tip_x - x, tip_y - y)
            if long > 0 and area.contains(shapely.Point(x, y)):
                aside = (tip_y - y) / long * ARROW_WIDE / 2, (x - tip_x) / long * ARROW_WIDE / 2
                ring = (tip_x, tip_y), (x + aside[0], y + aside[1]), (x - aside[0], y - aside[1])
                yield tuple((round(a, 2), round(b, 2)) for a, b in ring)


def _rings(shapes: list[Any], area: Any) -> list[Ring]:
    found: list[Ring] = []
    for shape in shapes:
        if not shape.intersects(area):
            continue
        parts = shapely.get_parts(shape.intersection(area).simplify(0.05))
        rings = [part.exterior.coords for part in parts if part.geom_type == "Polygon"]
        found += [tuple((round(x, 2), round(y, 2)) for x, y in ring) for ring in rings]
    return found

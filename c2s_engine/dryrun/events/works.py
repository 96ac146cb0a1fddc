"""Temporary changes of the road on ego's path: works, cones, barriers, debris, closed lanes, warning signs."""

import numpy as np
import shapely
from scipy.spatial import cKDTree
from scipy.spatial.distance import pdist

from c2s_engine.dryrun.contacts import corners
from c2s_engine.dryrun.events.kinds import temporary_kind
from c2s_engine.dryrun.events.road import BESIDE, EgoPath
from c2s_engine.dryrun.events.situation import Seen
from c2s_engine.dryrun.roads import LaneInfo

TOGETHER = 30.0
"""m: the parts of one construction zone lie no further apart."""
WIDE = 2.0
"""m of a lane that must be left for it to be open."""
FAR = 150.0
"""m from the path within which cones, barriers, debris and signs count."""
ABREAST = 3.0
"""m along the lane within which obstacles bar it together: no car drives a slalom between them."""


def temporary(path: EgoPath) -> tuple[str, ...]:
    """construction_zone, cones, barrier, debris, lane_closure, warning_sign."""
    things = [(o, temporary_kind(o.path)) for o in path.situation.others if o.kind == "prop"]
    away = {id(o): path.line.distance(shapely.Point(o.x[0], o.y[0])) for o, _ in things}
    found = {kind for o, kind in things if kind and away[id(o)] <= FAR}
    near = [(o, kind) for o, kind in things if kind and away[id(o)] <= BESIDE]
    parts = [o for o, kind in near if kind in ("cones", "barrier")]
    if _zone(parts, [o for o, kind in near if kind == "warning_sign"]):
        found.add("construction_zone")
    if _closed(path):
        found.add("lane_closure")
    return tuple(sorted(found))


def _zone(parts: list[Seen], signs: list[Seen]) -> bool:
    if not parts:
        return False
    places = np.array([[o.x[0], o.y[0]] for o in parts])
    tree = cKDTree(places)
    for i, around in enumerate(tree.query_ball_point(places, TOGETHER)):
        others = places[[k for k in around if k != i]]
        if len(others) > 1 and pdist(others).min() <= TOGETHER:
            return True
    return any(tree.query([o.x[0], o.y[0]])[0] <= TOGETHER for o in signs)


def _closed(path: EgoPath) -> bool:
    """Whether obstacles leave less than 2 m of a lane of ego's direction, abreast of its path."""
    things = [o for o in path.situation.others if o.kind == "prop" and not o.moves]
    if not things:
        return False
    boxes = [np.array(corners(o.x[0], o.y[0], o.heading[0], o.path.length, o.path.width)) for o in things]
    return any(_barred(path, info, boxes) for info in _carriageway(path))


def _carriageway(path: EgoPath) -> list[LaneInfo]:
    """The lanes of the path and all beside them in its direction."""
    lanes = path.situation.index.lanes
    found, todo = set(path.lanes), list(path.lanes)
    while todo:
        info = lanes[todo.pop()]
        more = (info.left | info.right) - found
        found |= more
        todo += more
    return [lanes[i] for i in sorted(found)]


def _barred(path: EgoPath, info: LaneInfo, boxes: list[np.ndarray]) -> bool:
    """Whether the obstacles (corners, m) that stand in a lane, and abreast of the path, bar it."""
    taken = []
    for box in boxes:
        s, d = info.project_many(box)
        if s.max() < 0.0 or s.min() > info.length or d.min() >= info.width / 2 or d.max() <= -info.width / 2:
            continue
        middle = info.point_at(float(np.clip(s.mean(), 0.0, info.length)))
        if path.abreast(*middle):
            taken.append((float(s.mean()), float(d.min()), float(d.max())))
    return bool(taken) and room(taken, info.width) < WIDE


def room(taken: list[tuple[float, float, float]], width: float) -> float:
    """The widest free part (m) of a lane at its narrowest. `taken`: (m along, from, to: m to the left) by obstacle."""
    least = width
    for s, _, _ in taken:
        group = sorted((low, high) for at, low, high in taken if abs(at - s) <= ABREAST)
        edge, best = -width / 2, 0.0
        for low, high in group:
            best = max(best, min(low, width / 2) - edge)
            edge = max(edge, high)
        least = min(least, max(best, width / 2 - edge))
    return least

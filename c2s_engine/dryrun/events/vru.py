"""Events of persons, riders and animals: crossing ego's lane, moving along the road."""

from collections.abc import Iterator

import numpy as np
import shapely

from c2s_engine.dryrun.events.kinds import is_vru
from c2s_engine.dryrun.events.motion import fact
from c2s_engine.dryrun.events.situation import Seen, Situation, wrap
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.structure.facts import EventFact


def vru(seen: Seen, situation: Situation) -> Iterator[EventFact]:
    """All events of this module that a road user shows."""
    if not is_vru(seen.path):
        return
    for other in situation.objects:
        if other is not seen and other.drives:
            step = cross_road(seen, other, situation)
            if step is not None:
                yield fact("cross_road", situation, step, other.name)
    step = along_road(seen, situation)
    if step is not None:
        yield fact("ride_along" if seen.drives else "walk_along", situation, step)


def cross_road(seen: Seen, other: Seen, situation: Situation) -> int | None:
    """The step at which it is over the other's lane, or in it at the end."""
    for part in _parts(other, situation):
        inside = shapely.contains_xy(part, seen.x, seen.y)
        if not inside.any():
            continue
        if seen.drives and _rides_along(seen, inside, situation):
            continue
        first, last = int(np.argmax(inside)), int(len(inside) - 1 - np.argmax(inside[::-1]))
        if inside[-1]:
            return last if first > 0 else None  # who stood there from the first has crossed nothing
        if first > 0 and _sides(seen, other, first - 1, last + 1):
            return last + 1
    return None


def _parts(other: Seen, situation: Situation) -> list[shapely.Geometry]:
    """The lanes that the other is in or turns into, joined."""
    lanes = list(dict.fromkeys(other.driven))
    if not lanes:
        return []
    joined = shapely.union_all([situation.index.lanes[i].lane.polygon for i in lanes])
    return list(getattr(joined, "geoms", [joined]))


def _sides(seen: Seen, other: Seen, before: int, after: int) -> bool:
    """Whether it is on different sides of the other's lane at two steps."""
    index = other.situation.index
    line = index.line(list(dict.fromkeys(other.driven)))
    from c2s_engine.dryrun.roads import polyline, project

    along, _ = polyline(line)
    _, d = project(line, along, seen.xy[[before, after]])
    return bool(d[0] * d[1] < 0)


def _rides_along(seen: Seen, inside: np.ndarray, situation: Situation) -> bool:
    """Whether a rider in the lane goes along it rather than across."""
    steps = np.flatnonzero(inside & (seen.speed > 0.5))
    if not len(steps):
        return True
    turns = _turn_to_road(seen, situation, steps)
    return bool(np.median(np.minimum(turns, np.pi - turns)) < np.radians(35))


def _turn_to_road(seen: Seen, situation: Situation, steps: np.ndarray) -> np.ndarray:
    """The angle between its motion and the nearest lane's direction, 0..pi."""
    index = situation.index
    points = shapely.points(seen.xy[steps])
    nearest = index.tree.nearest(points)
    course = np.arctan2(-seen.vx[steps], seen.vy[steps])
    found = np.empty(len(steps))
    for lane in np.unique(nearest):
        mask = nearest == lane
        info = index.lanes[int(lane)]
        s, _ = info.project_many(seen.xy[steps][mask])
        segment = np.clip(np.searchsorted(info.along, s, side="right") - 1, 0, len(info.headings) - 1)
        found[mask] = np.abs(wrap(course[mask] - info.headings[segment]))
    return found


def along_road(seen: Seen, situation: Situation) -> int | None:
    """The step at which it has moved far enough along a road, in or against its direction."""
    name = "ride_along" if seen.drives else "walk_along"
    limits = definitions()[name]
    steps = np.flatnonzero(seen.speed > 0.2)
    if not len(steps) or not seen.moves:
        return None
    steps = steps[steps > 0]
    turn = _turn_to_road(seen, situation, steps)
    points = shapely.points(seen.xy[steps])
    near = situation.index.tree.query_nearest(points, return_distance=True, all_matches=False)[1] < limits.beside
    along = (np.minimum(turn, np.pi - turn) <= np.radians(limits.turn)) & near
    gone = np.cumsum(np.where(along, np.diff(seen.travelled)[steps - 1], 0.0))
    far = np.flatnonzero(gone > limits.distance)
    return int(steps[far[0]]) if len(far) else None

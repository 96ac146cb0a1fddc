"""Where two paths cross or merge, and who is there when."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation, wrap
from c2s_engine.dryrun.events.table import definitions


@dataclass(frozen=True)
class Meeting:
    """A point where the paths of `one` and `other` meet. Steps at which each is there (None: it does not get there)."""

    x: float
    y: float
    one: int | None
    other: int | None
    one_near: int
    other_near: int
    """Step from which each is as near to the point as it gets."""
    one_short: float
    other_short: float
    """m that are missing to the point at the end."""


RESTART = 15.0
"""m: who stood so shortly before the end still has ahead what it stood for."""
STRUCK = 10.0
"""m ahead of the middle of one in a contact that still count as its path: what it was about to cross."""
BEHIND = -2
AHEAD = -1
"""Instead of a step: points that lie behind where it started, and ahead of where it stands at the end."""


def line_of(seen: Seen, situation: Situation) -> tuple[np.ndarray, np.ndarray]:
    """(points, step of each) of its path, the lane behind it, and before who stands (or just did), or was halted by a
    contact, the lane ahead."""
    moved = np.concatenate([[True], np.diff(seen.travelled) > 1e-3])
    points, steps = seen.xy[moved], np.flatnonzero(moved)
    recent = seen.travelled > seen.travelled[-1] - RESTART
    stood = (seen.speed[recent] < definitions()["yield"].standing).any() or not seen.moves
    if stood or seen.until < situation.last:
        ahead = _ahead(seen, situation, definitions()["cross_path"].extend if stood else STRUCK)
        points = np.concatenate([points, ahead])
        steps = np.concatenate([steps, np.full(len(ahead), AHEAD)])
    back = _behind(seen)
    return np.concatenate([back, points]), np.concatenate([np.full(len(back), BEHIND), steps])


def _behind(seen: Seen) -> np.ndarray:
    """The lane's line behind its start, nearest last: who drives there follows it and does not meet it."""
    if not seen.drives or seen.way is None or seen.start_lane is None:
        return np.empty((0, 2))
    way = seen.way
    s = float(way.place(seen.xy[:1])[0][0])
    if abs(wrap(seen.heading[0] - way.heading_at(s))) > np.pi / 2:
        return np.empty((0, 2))
    ss = np.arange(max(0.0, s - 150.0), s - 1.0, 1.0)
    return np.column_stack([np.interp(ss, way.along, way.points[:, 0]), np.interp(ss, way.along, way.points[:, 1])])


def _ahead(seen: Seen, situation: Situation, length: float) -> np.ndarray:
    if seen.kind == "prop":
        return np.empty((0, 2))
    lane = seen.lanes[-1]
    if seen.drives and lane != NOWHERE:
        info = situation.index.lanes[int(lane)]
        s = info.project(seen.x[-1], seen.y[-1])[0]
        points = situation.index.line(situation.index.path(int(lane), length, start=s))
        step = np.hypot(*np.diff(points, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(step)])
        ss = np.arange(s + 1.0, min(s + length, along[-1]), 1.0)
        return np.column_stack([np.interp(ss, along, points[:, 0]), np.interp(ss, along, points[:, 1])])
    if not seen.moves:
        return np.empty((0, 2))
    out = np.arange(1.0, min(length, 10.0), 1.0)
    heading = seen.heading[-1]
    return np.column_stack([seen.x[-1] - np.sin(heading) * out, seen.y[-1] + np.cos(heading) * out])


def _dense(points: np.ndarray, steps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """No two neighbouring points further apart than 1 m."""
    if len(points) < 2:
        return points, steps.astype(float)
    gaps = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(gaps)])
    count = max(2, int(along[-1]) + 2)
    ss = np.linspace(0.0, along[-1], count)
    known = steps >= 0
    first, limit = along[known][0], along[known][-1]
    when = np.interp(ss, along[known], steps[known].astype(float))
    when[ss > limit + 1e-6] = AHEAD
    when[ss < first - 1e-6] = BEHIND
    return np.column_stack([np.interp(ss, along, points[:, 0]), np.interp(ss, along, points[:, 1])]), when


def meeting(one: Seen, other: Seen, situation: Situation) -> Meeting | None:
    """The first point where one's path comes onto the other's, that it was not on from the beginning."""
    limits = definitions()["cross_path"]
    if "prop" in (one.kind, other.kind) or not (one.moves or other.moves):
        return None
    a, at = _dense(*line_of(one, situation))
    b, bt = _dense(*line_of(other, situation))
    if len(a) < 2 or len(b) < 2:
        return None
    if a[:, 0].max() + 2 < b[:, 0].min() or b[:, 0].max() + 2 < a[:, 0].min() \
            or a[:, 1].max() + 2 < b[:, 1].min() or b[:, 1].max() + 2 < a[:, 1].min():  # fmt: skip
        return None
    (to_b, on_b), (to_a, on_a) = cKDTree(b).query(a), cKDTree(a).query(b)
    k0, j0 = int(np.argmax(at != BEHIND)), int(np.argmax(bt != BEHIND))
    k = _first_on(to_b[k0:], limits)
    if k is not None:
        k += k0
        j = int(on_b[k])
    else:
        first = _first_on(to_a[j0:], limits)
        if first is None:
            return None
        j = first
        j += j0
        k = int(on_a[j])
    if bt[j] == BEHIND or at[k] == BEHIND:
        return None
    return Meeting(
        float(a[k, 0]), float(a[k, 1]), _when(at, k), _when(bt, j), _nearest(one, a[k]), _nearest(other, a[k]),
        _missing(at, k), _missing(bt, j),
    )  # fmt: skip


def _first_on(distance: np.ndarray, limits) -> int | None:  # type: ignore[no-untyped-def]
    """The first point on the other's path after one that is off it."""
    off = np.flatnonzero(distance > limits.apart)
    if not len(off):
        return None
    on = np.flatnonzero(distance[off[0] :] < limits.near)
    return int(off[0] + on[0]) if len(on) else None


def _when(steps: np.ndarray, k: int) -> int | None:
    return int(round(float(steps[k]))) if steps[k] >= 0 else None


def _nearest(seen: Seen, point: np.ndarray) -> int:
    away = np.hypot(seen.x - point[0], seen.y - point[1])
    return int(np.argmax(away <= away.min() + 0.3))


def _missing(steps: np.ndarray, k: int) -> float:
    """m from where it is at the end to the k-th point, if that is still ahead (the points lie 1 m apart)."""
    return float(k - np.flatnonzero(steps[:k] != AHEAD).max(initial=-1)) if steps[k] == AHEAD else 0.0


class Meetings:
    """The meeting of each pair, found once."""

    def __init__(self, situation: Situation) -> None:
        self.situation = situation
        self._known: dict[tuple[int, int], Meeting | None] = {}

    def of(self, one: Seen, other: Seen) -> Meeting | None:
        key = id(one), id(other)
        if key not in self._known:
            found = meeting(one, other, self.situation)
            self._known[key] = found
            self._known[key[::-1]] = None if found is None else Meeting(
                found.x, found.y, found.other, found.one, found.other_near, found.one_near, found.other_short,
                found.one_short,
            )  # fmt: skip
        return self._known[key]

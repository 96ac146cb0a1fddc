"""By how much one would have to come later or earlier for two to meet, or for the said parts of them to touch.

Both are taken as they drove in the run: nobody answers to the other's coming at another time.
"""

from collections.abc import Callable

import numpy as np

from c2s_engine.require.evidence import Motion
from c2s_engine.require.geometry import touching

STANDS, SLOWS = 0.3, 1.0
"""m/s below which one stands, m/s2 with which it brakes."""
STEP = 0.1
"""s by which times are told apart."""
INSIDE = 0.3
"""s by which a meeting is more than a graze, where that is possible."""
FURTHEST = 2.0
"""s within which another part is looked for, and for which motion goes on as it is behind a contact."""

Point = tuple[float, float]


def to_meet(one: Motion, other: Motion) -> float | None:
    """s by which `one` would have to be later (below 0: earlier) to touch `other`; None where their ways are apart."""
    every = max(1, round(STEP / one.step))
    i, j = _meeting(one.poses[::every], other.poses[::every], one, other)
    if not len(i):
        return None
    by = np.unique(j - i)
    groups = np.split(by, np.flatnonzero(np.diff(by) > 1) + 1)
    low, high = min(((g[0], g[-1]) for g in groups), key=lambda g: max(g[0], -g[1], 0))
    inside = min(INSIDE / (every * one.step), (high - low) / 2)
    return round(float(min(max(0.0, low + inside), high - inside)) * every * one.step, 2)


def arrival(one: Motion, other: Motion) -> float | None:
    """s by which `one` comes after `other` to where their ways meet (below 0: before it); None where they do not."""
    every = max(1, round(STEP / one.step))
    hit = _meeting(_going_on(one)[::every], _going_on(other)[::every], one, other)
    if not len(hit[0]) and one.speed[-1] < STANDS:  # it stops before: were it not to
        hit = _meeting(_unbraked(one)[::every], _going_on(other)[::every], one, other)
    return round(float(hit[0].min() - hit[1].min()) * every * one.step, 2) if len(hit[0]) else None


def conflict_begins(one: Motion, other: Motion) -> float | None:
    """When the second of two is where their ways meet, s; None where they do not."""
    hit = meeting_steps(one, other)
    return float(max(hit[0].min(), hit[1].min())) * one.step if len(hit[0]) else None


def meeting_steps(one: Motion, other: Motion) -> tuple[np.ndarray, np.ndarray]:
    """The steps of both at which they would touch, were they there at the same time."""
    every = max(1, round(STEP / one.step))
    i, j = _meeting(one.poses[::every], other.poses[::every], one, other)
    return i * every, j * every


def _meeting(a: np.ndarray, b: np.ndarray, one: Motion, other: Motion) -> tuple[np.ndarray, np.ndarray]:
    """The steps of both at which they would touch, were they there at the same time."""
    apart = np.hypot(a[:, None, 0] - b[None, :, 0], a[:, None, 1] - b[None, :, 1])
    i, j = np.nonzero(apart < 0.5 * (sum(one.size) + sum(other.size)))
    hit = touching(a[i], b[j], one.size, other.size) if len(i) else np.zeros(0, bool)
    return i[hit], j[hit]


def to_touch(one: Motion, other: Motion, wanted: Callable[[Point, Point], bool]) -> float | None:
    """The same for two that do touch, and not where it is wanted, to touch first there: m ahead and to the left of the
    middle of each."""
    every = max(1, round(STEP / one.step))
    a, b = _going_on(one)[::every], _going_on(other)[::every]
    tries = round(FURTHEST / (every * one.step))
    for by in sorted(range(-tries, tries + 1), key=abs)[1:]:
        n = min(len(a), len(b)) - abs(by)
        first, second = a[max(0, -by) :][:n], b[max(0, by) :][:n]
        hit = touching(first, second, one.size, other.size)
        if hit.any():
            k = int(hit.argmax())
            if wanted(*_touch(first[k], second[k], one.size, other.size)):
                return round(by * every * one.step, 2)
    return None


def _going_on(motion: Motion) -> np.ndarray:
    """Poses, and how it would go on behind them at the same speed in the same bend."""
    poses, steps = motion.poses, round(FURTHEST / motion.step)
    turning = poses[-1, 2] - poses[max(0, len(poses) - 4), 2]
    heading = poses[-1, 2] + turning / 3 * np.arange(1, steps + 1)
    gone = motion.speed[-1] * motion.step
    x = poses[-1, 0] - np.cumsum(np.sin(heading)) * gone
    y = poses[-1, 1] + np.cumsum(np.cos(heading)) * gone
    return np.concatenate([poses, np.column_stack([x, y, heading])])


def _unbraked(motion: Motion) -> np.ndarray:
    """Poses up to where it begins to brake to its last stand, and how it would go straight on at that speed."""
    driving = np.flatnonzero((motion.acceleration > -SLOWS) & (motion.speed >= STANDS))
    last = int(driving[-1]) if len(driving) else 0
    steps = len(motion.time) - last + round(FURTHEST / motion.step)
    gone = motion.speed[last] * motion.step * np.arange(1, steps + 1)
    x, y, heading = motion.poses[last]
    onward = np.column_stack([x - np.sin(heading) * gone, y + np.cos(heading) * gone, np.full(steps, heading)])
    return np.concatenate([motion.poses[: last + 1], onward])


def _touch(one: np.ndarray, other: np.ndarray, size: Point, other_size: Point) -> tuple[Point, Point]:
    """The middle of what two boxes share, by points of their outlines, seen from each."""
    points = np.concatenate([_outline(one, size), _outline(other, other_size)])
    shared = [p for p in points if _within(p, one, size) and _within(p, other, other_size)]
    middle = np.mean(shared or [(one[:2] + other[:2]) / 2], axis=0)
    return _seen_from(one, middle), _seen_from(other, middle)


def _outline(pose: np.ndarray, size: Point) -> np.ndarray:
    side = np.linspace(-0.5, 0.5, 21)
    half = np.full_like(side, 0.5)
    edges = [(side, half), (side, -half), (half, side), (-half, side)]
    ahead, left = (np.concatenate(c) for c in zip(*((a * size[0], b * size[1]) for a, b in edges), strict=True))
    sin, cos = np.sin(pose[2]), np.cos(pose[2])
    return np.column_stack([pose[0] - sin * ahead - cos * left, pose[1] + cos * ahead - sin * left])


def _seen_from(pose: np.ndarray, point: np.ndarray) -> tuple[float, float]:
    dx, dy = point - pose[:2]
    sin, cos = np.sin(pose[2]), np.cos(pose[2])
    return float(-sin * dx + cos * dy), float(-cos * dx - sin * dy)


def _within(point: np.ndarray, pose: np.ndarray, size: Point) -> bool:
    ahead, left = _seen_from(pose, point)
    return abs(ahead) <= size[0] / 2 + 0.05 and abs(left) <= size[1] / 2 + 0.05

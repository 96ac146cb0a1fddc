"""Boxes in motion: when they touch, would touch, or pass the same place one after the other. Arrays; m, s, rad."""

import numpy as np

HORIZON = 4.0
"""s for which motion is thought to go on as it is, for the time to collision."""


def face(point: tuple[float, float], size: tuple[float, float]) -> str:
    """The side of a box of (length, width) that a point (m ahead and to the left of its middle) is nearest to."""
    ahead, left = point
    if size[0] / 2 - abs(ahead) <= size[1] / 2 - abs(left):
        return "front" if ahead > 0 else "rear"
    return "left" if left > 0 else "right"


def lead(of: np.ndarray, other: np.ndarray) -> np.ndarray:
    """m by which the other's middle is ahead of one's, along that one's heading; poses (..., [x, y, heading])."""
    dx, dy = other[..., 0] - of[..., 0], other[..., 1] - of[..., 1]
    return -np.sin(of[..., 2]) * dx + np.cos(of[..., 2]) * dy


def touching(a: np.ndarray, b: np.ndarray, size_a: tuple[float, float], size_b: tuple[float, float]) -> np.ndarray:
    """Whether boxes at poses (..., [x, y, heading]) overlap; the poses are broadcast, sizes are (length, width)."""
    dx, dy = b[..., 0] - a[..., 0], b[..., 1] - a[..., 1]
    c, s = np.abs(np.cos(b[..., 2] - a[..., 2])), np.abs(np.sin(b[..., 2] - a[..., 2]))
    apart = np.zeros(dx.shape, bool)
    for heading, one, other in ((a[..., 2], size_a, size_b), (b[..., 2], size_b, size_a)):
        sin, cos = np.sin(heading), np.cos(heading)
        apart |= np.abs(-sin * dx + cos * dy) > 0.5 * (one[0] + other[0] * c + other[1] * s)
        apart |= np.abs(cos * dx + sin * dy) > 0.5 * (one[1] + other[0] * s + other[1] * c)
    return ~apart


def post_encroachment(a: np.ndarray, b: np.ndarray, size_a: tuple[float, float], size_b: tuple[float, float],
                      step: float) -> float:  # fmt: skip
    """s between the one's leaving a place and the other's coming to it, at the least; inf where no place is shared."""
    every = max(1, round(0.2 / step))
    one, other = a[::every, None, :], b[None, ::every, :]
    near = np.hypot(one[..., 0] - other[..., 0], one[..., 1] - other[..., 1]) < 0.5 * (sum(size_a) + sum(size_b))
    i, j = np.nonzero(near)
    if not len(i):
        return float("inf")
    hit = touching(a[::every][i], b[::every][j], size_a, size_b)
    return float(np.abs(i[hit] - j[hit]).min() * every * step) if hit.any() else float("inf")


def time_to_collision(a: np.ndarray, b: np.ndarray, size_a: tuple[float, float], size_b: tuple[float, float],
                      step: float) -> np.ndarray:  # fmt: skip
    """s to contact at each step if both go on as they are; inf where they would not touch within the horizon."""
    ahead = np.arange(0.0, HORIZON + 1e-9, 0.2)
    moved = [p[:, None, :2] + ahead[None, :, None] * np.gradient(p[:, :2], step, axis=0)[:, None, :] for p in (a, b)]
    poses = [
        np.concatenate([m, np.broadcast_to(p[:, None, 2:3], (*m.shape[:2], 1))], axis=2)
        for m, p in zip(moved, (a, b), strict=True)
    ]
    hit = touching(poses[0], poses[1], size_a, size_b)
    return np.where(hit.any(axis=1), ahead[hit.argmax(axis=1)], np.inf)


def box_distance(a: np.ndarray, b: np.ndarray, size_a: tuple[float, float], size_b: tuple[float, float]) -> np.ndarray:
    """m between two boxes at each step; 0 where they touch."""
    nearest = np.minimum(_corner_distance(a, b, size_a, size_b), _corner_distance(b, a, size_b, size_a))
    return np.where(touching(a, b, size_a, size_b), 0.0, nearest)


def _corner_distance(a: np.ndarray, b: np.ndarray, size_a: tuple[float, float],
                     size_b: tuple[float, float]) -> np.ndarray:  # fmt: skip
    """m from the nearest corner of the first box to the second at each step, if they do not overlap."""
    sin, cos = np.sin(b[:, 2]), np.cos(b[:, 2])
    found = np.full(max(len(a), len(b)), np.inf)
    for ahead, left in ((0.5, 0.5), (0.5, -0.5), (-0.5, 0.5), (-0.5, -0.5)):
        ahead, left = ahead * size_a[0], left * size_a[1]
        dx = a[:, 0] - np.sin(a[:, 2]) * ahead - np.cos(a[:, 2]) * left - b[:, 0]
        dy = a[:, 1] + np.cos(a[:, 2]) * ahead - np.sin(a[:, 2]) * left - b[:, 1]
        along, aside = np.abs(-sin * dx + cos * dy), np.abs(cos * dx + sin * dy)
        found = np.minimum(found, np.hypot(np.maximum(along - size_b[0] / 2, 0), np.maximum(aside - size_b[1] / 2, 0)))
    return found

"""How one moves to the side: the times of a lane change, as Drive of the driving library makes it. m, s, m/s, m/s2."""

import math

from c2s_engine.structure.quantity import middle
from c2s_engine.structure.specs import Phase
from c2s_engine.write.typed.tables import LANE_WIDTH, WIDTH

SHIFT = 2.2
"""m/s at which lanes are changed where nothing is said, as Drive does."""
SIDEWAYS = 3.0
"""m/s2 at which that is gained, as in the driving library; who moves faster, at the last moment, gains it faster."""
ANSWERS = 0.1
"""s until the body goes where the wheels point."""
SETTLED = 0.3
"""m from the middle of its lane within which one is in it."""
LATERAL = {"cut_in", "cut_out", "lane_change"}
"""What has its moment as it comes over the lane line."""


def gained_at(shift: float) -> float:
    """m/s2 at which one gains so many m/s to the side."""
    return max(SIDEWAYS, 2 * shift - 2)


def sideways(metres: float, shift: float) -> float:
    """s until one has moved so far to the side."""
    rate = gained_at(shift)
    gained = shift**2 / (2 * rate)
    return math.sqrt(2 * metres / rate) if metres < gained else shift / rate + (metres - gained) / shift


BEGUN = 0.3
"""m to the side by which one that is as wide as its lane has begun to come over the line."""


def to_line(kind: str, phase: Phase) -> float:
    """s from the beginning of a phase until the side of a vehicle of a kind comes over the lane line."""
    if phase.action not in LATERAL:
        return 0.0
    return sideways(max((LANE_WIDTH - WIDTH[kind]) / 2, BEGUN), shift_of(phase)) + ANSWERS


def said(phase: Phase) -> float | None:
    """m/s at which S has one move sideways in a phase, by itself or by how long the change of lane lasts; None: it does
    not say."""
    if phase.lateral_speed is not None:
        return middle(phase.lateral_speed)
    if phase.duration is None or phase.action not in LATERAL or phase.abandoned:
        return None
    lasts = middle(phase.duration) - ANSWERS
    return next((s / 10 for s in range(30, 4, -1) if sideways(LANE_WIDTH - 2 * SETTLED, s / 10) >= lasts), 0.4)


def shift_of(phase: Phase) -> float:
    """m/s at which one moves sideways in a phase."""
    return said(phase) or SHIFT


def headway(gap: float, speed: float) -> tuple[float, float]:
    """(s, m) for `following_speed`: how the gap that one keeps grows with the speed, and what it is at a stand."""
    standing = min(gap, 4.0)
    return (gap - standing) / max(speed, 1.0), standing

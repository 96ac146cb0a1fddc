"""Paths of lines and arcs in the plane: poses, fillets between poses, and how they are written to OpenDRIVE."""

import math
from dataclasses import dataclass

Piece = tuple[str, float, float]
"""("line", length, 0) or ("arc", length, curvature with left positive); m, 1/m."""


@dataclass(frozen=True)
class Pose:
    """A point (m) and a heading (rad, counterclockwise from the x axis)."""

    x: float
    y: float
    heading: float

    def moved(self, ahead: float, left: float = 0.0, turn: float = 0.0) -> "Pose":
        """The pose so far ahead and to the left, turned by so much."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return Pose(self.x + ahead * c - left * s, self.y + ahead * s + left * c, self.heading + turn)

    def after(self, piece: Piece) -> "Pose":
        """The pose at the end of a piece that begins here."""
        kind, length, curvature = piece
        if kind == "line":
            return self.moved(length)
        turn = length * curvature
        return self.moved(math.sin(turn) / curvature, (1 - math.cos(turn)) / curvature, turn)

    @property
    def reversed(self) -> "Pose":
        return Pose(self.x, self.y, self.heading + math.pi)


def length_of(pieces: list[Piece]) -> float:
    return sum(length for _, length, _ in pieces)


def arc(turn: float, radius: float) -> list[Piece]:
    """An arc that turns by so much (rad, left positive), in pieces short enough to be sampled finely by a parser."""
    whole = abs(turn) * radius
    count = max(1, math.ceil(whole / min(60.0, radius)))
    return [("arc", whole / count, math.copysign(1 / radius, turn))] * count


def turning_round(start: Pose, end: Pose, radius: float = 5.2, run: float = 14.0) -> list[Piece]:
    """The way from a pose to one beside it to the left that looks back: a half circle, of at least that radius, for
    which the way first swings to the right over `run` where the poses are nearer."""
    gap = (end.y - start.y) * math.cos(start.heading) - (end.x - start.x) * math.sin(start.heading)
    if gap >= 2 * radius:
        return between(start, end)
    return [*between(start, start.moved(run, gap - 2 * radius)), *arc(math.pi, radius), ("line", run, 0.0)]


def between(start: Pose, end: Pose) -> list[Piece]:
    """The way from pose to pose: a line, an S of two arcs, a half circle, or a line-arc-line fillet."""
    turn = math.remainder(end.heading - start.heading, math.tau)
    dx, dy = end.x - start.x, end.y - start.y
    c, s = math.cos(start.heading), math.sin(start.heading)
    ahead, left = dx * c + dy * s, dy * c - dx * s
    if abs(turn) < 1e-6:
        if abs(left) < 1e-6:
            return [("line", ahead, 0.0)]
        half = 2 * math.atan2(left, ahead)
        radius = (ahead**2 + left**2) / (4 * abs(left))
        return arc(half, radius) + arc(-half, radius)
    if abs(abs(turn) - math.pi) < 1e-6:
        run = [("line", ahead, 0.0)] if ahead > 1e-6 else []
        return run + arc(math.copysign(math.pi, left), abs(left) / 2)
    to_corner = ahead - left / math.tan(turn)
    from_corner = left / math.sin(turn)
    reach = min(to_corner, from_corner)
    if reach <= 0:
        raise ValueError(f"no line-arc-line path leads from {start} to {end}")
    pieces: list[Piece] = []
    if to_corner - reach > 1e-3:
        pieces.append(("line", to_corner - reach, 0.0))
    pieces += arc(turn, reach / math.tan(abs(turn) / 2))
    if from_corner - reach > 1e-3:
        pieces.append(("line", from_corner - reach, 0.0))
    return pieces

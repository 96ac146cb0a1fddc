"""What is compared of a manoeuvre: numbers of the ways that its run recorded, in the frame of each way's own start."""

import math
from collections.abc import Callable
from typing import NamedTuple

from c2s_engine.structure.facts import Track, Trajectories

STANDS = 0.2
"""m/s below which somebody stands."""


class Way(NamedTuple):
    """A track seen from its start, a sample each `step` s: m ahead and to the left of that, rad to the left, m/s."""

    step: float
    along: list[float]
    aside: list[float]
    turned: list[float]
    speed: list[float]
    gaps: list[float]

    def at(self, values: list[float], seconds: float) -> float | None:
        k = round(seconds / self.step)
        return values[k] if k < len(values) else None

    def first(self, fits: Callable[[float], bool], begin: int = 0) -> int | None:
        """The first sample from `begin` on whose speed fits."""
        return next((k for k in range(begin, len(self.speed)) if fits(self.speed[k])), None)

    def standing(self) -> int | None:
        """The first sample at which it stands after it has moved."""
        moved = self.first(lambda v: v > 2 * STANDS)
        return None if moved is None else self.first(lambda v: v < STANDS, moved)


def way_of(found: Trajectories, who: int) -> Way:
    """The way of the first (0, ego) or second (1) object; `gaps`: from bumper to bumper to the other one, m."""
    track = found.tracks[who]
    sin, cos = math.sin(track.heading[0]), math.cos(track.heading[0])
    moved = [(x - track.x[0], y - track.y[0]) for x, y in zip(track.x, track.y, strict=True)]
    turned = [0.0]
    for before, after in zip(track.heading, track.heading[1:], strict=False):
        turned.append(turned[-1] + math.remainder(after - before, 2 * math.pi))
    return Way(
        step=found.step,
        along=[y * cos - x * sin for x, y in moved],
        aside=[-x * cos - y * sin for x, y in moved],
        turned=turned,
        speed=list(track.speed),
        gaps=_gaps(track, found.tracks[1 - who]) if len(found.tracks) > 1 else [],
    )


def _gaps(one: Track, two: Track) -> list[float]:
    apart = (math.hypot(a - c, b - d) for a, b, c, d in zip(one.x, one.y, two.x, two.y, strict=True))
    return [metres - (one.length + two.length) / 2 for metres in apart]


def _turned(way: Way, seconds: float) -> float | None:
    turned = way.at(way.turned, seconds)
    return None if turned is None else math.degrees(turned)


def _reaches(way: Way, speed: float) -> float | None:
    k = way.first(lambda v: v >= speed)
    return None if k is None else k * way.step


def _stands(way: Way) -> float | None:
    k = way.standing()
    return None if k is None else k * way.step


def _stops_at(way: Way) -> float | None:
    k = way.standing()
    return None if k is None else way.along[k]


def _braking_distance(way: Way, speed: float) -> float | None:
    """From where it was as fast as that for the last time before it stood (between two samples) to the stand."""
    end = way.standing()
    faster = [k for k in range(end or 0) if way.speed[k] >= speed]
    if end is None or not faster:
        return None
    k = faster[-1]
    share = (way.speed[k] - speed) / (way.speed[k] - way.speed[k + 1])
    return way.along[end] - way.along[k] - share * (way.along[k + 1] - way.along[k])


MEASURES: dict[str, tuple[str, str, Callable[..., float | None]]] = {
    "speed": ("speed at {} s", "m/s", lambda way, seconds: way.at(way.speed, seconds)),
    "reaches": ("time to {} m/s", "s", _reaches),
    "along": ("way ahead at {} s", "m", lambda way, seconds: way.at(way.along, seconds)),
    "aside": ("way to the left at {} s", "m", lambda way, seconds: way.at(way.aside, seconds)),
    "most_aside": ("farthest to a side", "m", lambda way: max(way.aside, key=abs)),
    "turned": ("turned to the left at {} s", "deg", _turned),
    "stands": ("time to a stand", "s", _stands),
    "stops_at": ("way to a stand", "m", _stops_at),
    "braking_distance": ("way from {} m/s to a stand", "m", _braking_distance),
    "gap": ("gap at {} s", "m", lambda way, seconds: way.at(way.gaps, seconds)),
    "least_gap": ("least gap", "m", lambda way: min(way.gaps)),
}
"""By name: how it is told, its unit, and what it is of a way (None where it did not come to that) and its argument."""

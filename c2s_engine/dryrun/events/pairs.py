"""Events between two objects: all of them together, contact, and coming nearer."""

from collections.abc import Iterator

import numpy as np
import shapely

from c2s_engine.dryrun.contacts import corners
from c2s_engine.dryrun.events.crossing import cross_path, passes_first, yields
from c2s_engine.dryrun.events.following import beside, cut_in, cut_out, follow, lets_by, overtake
from c2s_engine.dryrun.events.meetings import Meetings
from c2s_engine.dryrun.events.motion import fact
from c2s_engine.dryrun.events.situation import Seen, Situation
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.structure.facts import EventFact


def pairs(seen: Seen, other: Seen, situation: Situation, meetings: Meetings) -> Iterator[EventFact]:
    """All events of this module that an object shows towards another."""
    yield from hits(seen, other, situation)
    if not seen.moves and not other.moves:
        return
    found: list[tuple[str, int | None]] = [("approach", approach(seen, other))]
    placed = beside(seen, other, situation) if seen.drives and other.drives and seen.moves else None
    if placed is not None:
        found += [
            ("follow", follow(seen, other, placed, situation)),
            ("cut_in", cut_in(seen, other, placed, situation)),
            ("cut_out", cut_out(seen, placed, situation)),
            ("overtake", overtake(seen, other, placed)),
            ("yield", lets_by(seen, other, placed)),
        ]
    met = meetings.of(seen, other)
    if met is not None:
        found += [
            ("cross_path", cross_path(seen, other, met, situation)),
            ("passes_first", passes_first(met)),
            ("yield", yields(seen, other, met, situation)),
        ]
    for name, step in found:
        if step is not None:
            yield fact(name, situation, step, other.name)


def hits(seen: Seen, other: Seen, situation: Situation) -> Iterator[EventFact]:
    """The contact of the two, from either's side."""
    for time, i, j in situation.recording.contacts:
        touched = situation.objects[i], situation.objects[j]
        if touched in ((seen, other), (other, seen)):
            yield EventFact(event="hits", time=round(time, 2), other=other.name)


def gaps(one: Seen, other: Seen) -> np.ndarray:
    """m between the boxes at each step, about: between the ellipses of their sizes along the line between them."""
    n = min(len(one.x), len(other.x))
    dx, dy = other.x[:n] - one.x[:n], other.y[:n] - one.y[:n]
    away = np.hypot(dx, dy)
    bearing = np.arctan2(-dx, dy)

    def reach(seen: Seen) -> np.ndarray:
        turn = bearing - seen.heading[:n]
        c, s = np.abs(np.cos(turn)), np.abs(np.sin(turn))
        length, width = seen.path.length / 2, seen.path.width / 2
        return np.minimum(length / np.maximum(c, 1e-6), width / np.maximum(s, 1e-6))

    return np.maximum(0.0, away - reach(one) - reach(other))


def approach(seen: Seen, other: Seen) -> int | None:
    """The step at which the gap has closed enough."""
    limits = definitions()["approach"]
    gap = gaps(seen, other)
    most = np.maximum.accumulate(gap)
    closed = np.flatnonzero((gap <= most * (1 - limits.share)) & (most - gap > limits.least))
    return int(closed[0]) if len(closed) else None


def box_gap(one: Seen, other: Seen, step: int = 0) -> float:
    """m between the two boxes at a step."""
    a, b = (
        shapely.Polygon(
            corners(float(o.x[step]), float(o.y[step]), float(o.heading[step]), o.path.length, o.path.width)
        )
        for o in (one, other)
    )
    return float(a.distance(b))

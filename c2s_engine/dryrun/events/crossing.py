"""Events where two paths meet: crossing, passing first, yielding."""

import numpy as np

from c2s_engine.dryrun.events.meetings import Meeting
from c2s_engine.dryrun.events.situation import Seen, Situation
from c2s_engine.dryrun.events.table import definitions


def cross_path(seen: Seen, other: Seen, met: Meeting, situation: Situation) -> int | None:
    """The step at which it is where the other's path goes, its middle or at least its body, and the other has been at
    that point or waits before it."""
    span = definitions()["cross_path"].time / situation.step
    if met.one is not None and met.other is not None:
        return max(met.one, met.other) if abs(met.one - met.other) <= span else None
    touch = situation.touched.get(frozenset((seen.name, other.name)))
    if touch is not None:  # each has halted the other
        return touch
    if met.one is not None:
        return _halted(other, met.other_short, met.one, span)
    if met.other is not None and met.one_short <= _reach(seen, other):
        return _halted(seen, met.one_short, met.other, span)
    return None


def _reach(seen: Seen, other: Seen) -> float:
    """m to the point where the paths meet at which its front is in the way of the other's side."""
    return (seen.path.length + other.path.width) / 2


def _halted(seen: Seen, short: float, passing: int, span: float) -> int | None:
    """The step within the span (steps) of the other's passing at which it stands before the point, if near to it.

    `short`: m that are missing to the point when the run ends.
    """
    limits = definitions()["cross_path"]
    missing = short + seen.travelled[-1] - seen.travelled
    stands = (seen.speed < limits.standing) & (missing <= limits.halted)
    steps = np.flatnonzero(stands & (np.abs(np.arange(len(stands)) - passing) <= span))
    return max(passing, int(steps[0])) if len(steps) else None


def passes_first(met: Meeting) -> int | None:
    """The step at which it is through the point where their paths meet, if that is before the other."""
    if met.one is None:
        return None
    return met.one if met.other is None or met.one < met.other else None


def yields(seen: Seen, other: Seen, met: Meeting, situation: Situation) -> int | None:
    """The step from which it lets the other pass first."""
    limits = definitions()["yield"]
    if not other.moves or seen.kind == "prop" or _is_first(met):
        return None
    until = seen.until if met.other is None else min(met.other, seen.until)
    near = np.flatnonzero(np.hypot(seen.x - met.x, seen.y - met.y)[: until + 1] <= limits.near)
    if not len(near):
        return None
    first = int(near[0])
    speed = seen.speed[first : until + 1]
    slowed = np.flatnonzero((np.maximum.accumulate(speed) - speed > limits.loss) | (speed < limits.standing))
    if not len(slowed):
        return None
    waits = first + int(slowed[0])
    return waits if _goes_on(seen, met) or _still_waits(seen, other, met) else None


def _is_first(met: Meeting) -> bool:
    """Whether it comes to the point before the other, or the other never does."""
    return met.one is not None and (met.other is None or met.one <= met.other)


def _goes_on(seen: Seen, met: Meeting) -> bool:
    """Whether it drives on once the other has passed."""
    if met.other is None or met.other >= seen.until:
        return False
    after = seen.speed[met.other :]
    return met.one is not None or float(after.max() - after[0]) > definitions()["yield"].gain


def _still_waits(seen: Seen, other: Seen, met: Meeting) -> bool:
    """Whether it stands at the end for an other that comes (that moved since it stands), and is not yet through."""
    limits = definitions()["yield"]
    if seen.speed[-1] >= limits.standing or met.one is not None:
        return False
    if met.other is not None:
        beyond = other.travelled[-1] - other.travelled[min(met.other, other.until)]
        return bool(beyond <= 0.5 * (other.path.length + seen.path.width))
    moved = np.flatnonzero(seen.speed >= limits.standing)
    return bool((other.speed[int(moved[-1]) + 1 if len(moved) else 0 :] > limits.standing).any())

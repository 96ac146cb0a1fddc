"""Events of an object's own motion: standing, stopping, braking, gaining speed, going backwards."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.dryrun.events.situation import Seen, Situation
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.structure.facts import EventFact

TURNED_BACK = -0.7
"""The cosine between two ways on foot, one after the other, under which the second leads back."""


def stretches(mask: np.ndarray) -> list[tuple[int, int]]:
    """(first, last) of each run of true steps."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def fact(name: str, situation: Situation, step: int, other: str | None = None) -> EventFact:
    """An event at a step."""
    return EventFact(event=name, time=round(step * situation.step, 2), other=other)


def motion(seen: Seen, situation: Situation) -> Iterator[EventFact]:
    """All events of this module that an object shows."""
    if not seen.moves:
        yield fact("stationary", situation, 0)
        return
    for name, step in (
        ("stop", stop(seen, situation)),
        ("brake", braking(seen, situation, "brake")),
        ("brake_hard", braking(seen, situation, "brake_hard")),
        ("accelerate", accelerate(seen, situation)),
        ("slow", slow(seen, situation)),
        ("reverse", reverse(seen, situation)),
    ):
        if step is not None:
            yield fact(name, situation, step)


def stop(seen: Seen, situation: Situation) -> int | None:
    """The step at which it comes to a stand."""
    limits = definitions()["stop"]
    moving = np.flatnonzero(seen.speed >= limits.moving)
    if not len(moving):
        return None
    standing = (seen.speed < limits.standing) & (np.arange(len(seen.speed)) > moving[0])
    long = situation.at(limits.time)
    return next((a for a, b in stretches(standing) if b - a + 1 >= long), None)


def slowing(seen: Seen, situation: Situation, rate: float, loss: float) -> int | None:
    """The first step from which it slows by over `loss` at `rate` or more."""
    speed = seen.speed
    if len(speed) < 2:
        return None
    change = np.diff(speed) / situation.step
    if len(change) >= 3:
        smooth = np.convolve(change, np.ones(3) / 3, mode="same")
        hard = (np.minimum(change, smooth) <= -rate) & (change <= -0.8 * rate) | (change <= -rate)
    else:
        hard = change <= -rate
    joined = hard.copy()
    joined[1:-1] |= hard[:-2] & hard[2:]
    for a, b in stretches(joined):
        if speed[a] - speed[b + 1] > loss and speed[a] - speed[b + 1] >= rate * (b + 1 - a) * situation.step * 0.97:
            return a
    return None


def braking(seen: Seen, situation: Situation, name: str) -> int | None:
    """brake or brake_hard, by their thresholds."""
    limits = definitions()[name]
    return slowing(seen, situation, limits.rate, limits.loss)


def accelerate(seen: Seen, situation: Situation) -> int | None:
    """The step at which it has gained enough, after its first second of moving."""
    limits = definitions()["accelerate"]
    moving = np.flatnonzero(seen.speed > limits.moving)
    if not len(moving):
        return None
    first = int(moving[0]) + situation.at(limits.after)
    speed = seen.speed[first:]
    if not len(speed):
        return None
    gained = np.flatnonzero(speed - np.minimum.accumulate(speed) > limits.gain)
    return first + int(gained[0]) if len(gained) else None


def slow(seen: Seen, situation: Situation) -> int | None:
    """Whether its top speed is low, in itself or beside the fastest vehicle's."""
    limits = definitions()["slow"]
    top = float(seen.speed.max())
    fastest = max((float(o.speed.max()) for o in situation.objects if o.drives), default=0.0)
    return 0 if top < limits.speed or top < limits.share * fastest else None


def reverse(seen: Seen, situation: Situation) -> int | None:
    """The step at which it has gone backwards far enough; on foot: back the way it came."""
    limits = definitions()["reverse"]
    if not seen.drives:
        moving = np.flatnonzero(seen.speed > 0.2)
        ways = np.column_stack([seen.vx, seen.vy])[moving] / seen.speed[moving, None]
        for k in np.flatnonzero((ways[1:] * ways[:-1]).sum(axis=1) < TURNED_BACK) + 1:
            returned = np.flatnonzero((seen.xy[moving[k] :] - seen.xy[moving[k]]) @ ways[k] > limits.distance)
            if len(returned):
                return int(moving[k] + returned[0])
        return None
    back = np.concatenate([[0.0], np.maximum(0.0, -seen.forward[1:])]) * situation.step
    for a, b in stretches(seen.forward < -0.05):
        total = np.cumsum(back[a : b + 1])
        if total[-1] > limits.distance:
            return a + int(np.argmax(total > limits.distance))
    return None


def held_speed(seen: Seen) -> float | None:
    """The speed (m/s) held for the longest while in motion: the middle of the fullest 1 m/s."""
    speed = np.sort(seen.speed[seen.speed > 0.5])
    if not len(speed) or not seen.moves:
        return None
    upper = np.searchsorted(speed, speed + 1.0, side="right")
    best = int((upper - np.arange(len(speed))).argmax())
    return float(np.median(speed[best : upper[best]]))

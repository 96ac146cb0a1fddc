"""Events between two objects: following, cutting in, overtaking, crossing paths, yielding, contact."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.dryrun.contacts import corners
from c2s_engine.dryrun.events.lanes import changes
from c2s_engine.dryrun.events.meetings import Meeting, Meetings
from c2s_engine.dryrun.events.motion import fact, stretches
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.structure.facts import EventFact


def pairs(seen: Seen, other: Seen, situation: Situation, meetings: Meetings) -> Iterator[EventFact]:
    """All events of this module that an object shows towards another."""
    yield from hits(seen, other, situation)
    if not seen.moves and not other.moves:
        return
    found: list[tuple[str, int | None]] = [("approach", approach(seen, other))]
    if seen.drives and other.drives and seen.moves:
        found += [
            ("follow", follow(seen, other, situation)),
            ("cut_in", cut_in(seen, other, situation)),
            ("cut_out", cut_out(seen, other, situation)),
            ("overtake", overtake(seen, other)),
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


def _along(seen: Seen, other: Seen) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
    """(lead of `seen`, its distance from the way, steps) measured on the way that `other` drives."""
    if other.way is None:
        return None
    n = min(len(seen.x), len(other.x))
    (s, d), (mine, _) = other.placed(seen), other.placed(other)
    return s[:n] - mine[:n], d[:n], np.arange(n)


def _in_lane(seen: Seen, other: Seen, n: int) -> np.ndarray:
    """At which steps `seen` is in a lane that `other` is in or comes to."""
    own = {int(lane) for lane in other.driven}
    return np.isin(seen.lanes[:n], list(own)) & (seen.lanes[:n] != NOWHERE) if own else np.zeros(n, bool)


def _same_lane(seen: Seen, other: Seen, situation: Situation, n: int) -> np.ndarray:
    """At which steps the two are in one lane, or in one that continues the other's."""
    found = np.zeros(n, bool)
    known: dict[tuple[int, int], bool] = {}
    for step, (a, b) in enumerate(zip(seen.lanes[:n].tolist(), other.lanes[:n].tolist(), strict=True)):
        if NOWHERE in (a, b):
            continue
        if (a, b) not in known:
            known[a, b] = a == b or _leads(situation, a, b) or _leads(situation, b, a) or _linked(seen, other, a, b)
        found[step] = known[a, b]
    return found


def _leads(situation: Situation, a: int, b: int) -> bool:
    return b in situation.index.path(a, 120.0 + situation.index.lanes[a].length)


def _linked(seen: Seen, other: Seen, a: int, b: int) -> bool:
    """Whether the two lanes lie on one driven way."""
    return any(a in o.driven and b in o.driven and not _changed_between(o, a, b) for o in (seen, other))


def _changed_between(seen: Seen, a: int, b: int) -> bool:
    order = seen.driven
    low, high = sorted((order.index(a), order.index(b)))
    lanes = seen.situation.index.lanes
    return any(
        y not in lanes[x].next and x != y for x, y in zip(order[low:high], order[low + 1 : high + 1], strict=True)
    )


def follow(seen: Seen, other: Seen, situation: Situation) -> int | None:
    """The step from which it is behind the other in one lane, if that lasts."""
    limits = definitions()["follow"]
    placed = _along(seen, other)
    if placed is None or other.kind == "bicycle" and not other.moves:
        return None
    lead, _, steps = placed
    behind = (lead < 0) & (lead > -limits.within) & _same_lane(seen, other, situation, len(steps))
    for a, b in stretches(behind):
        if (b - a) * situation.step >= limits.time - 1e-6 and seen.travelled[b] - seen.travelled[a] > limits.travels:
            return a
    return None


def cut_in(seen: Seen, other: Seen, situation: Situation) -> int | None:
    """The step at which it is in the other's lane, close ahead of it, having come from another lane."""
    limits = definitions()["cut_in"]
    placed = _along(seen, other)
    if placed is None:
        return None
    lead, _, steps = placed
    n = len(steps)
    same = _same_lane(seen, other, situation, n)
    apart = 0.5 * (seen.path.length + other.path.length)
    for a, b in stretches(same):
        if a == 0 or b - a + 1 < situation.at(limits.time) and b != n - 1:
            continue
        gap = lead[a] - apart
        came = seen.lanes[a - 1] not in (NOWHERE, seen.lanes[a]) and seen.speed[a] > 0.3
        if came and lead[a] > 0 and gap <= limits.within and other.lanes[a] == other.lanes[a - 1]:
            return a
    return None


def cut_out(seen: Seen, other: Seen, situation: Situation) -> int | None:
    """The step at which it leaves the other's lane, having been ahead in it."""
    limits = definitions()["cut_out"]
    placed = _along(seen, other)
    if placed is None:
        return None
    lead, _, steps = placed
    n = len(steps)
    same = _same_lane(seen, other, situation, n)
    moves = {step for _, step, _, _ in changes(seen, situation)}
    off = {a for lane, a, _ in seen.runs if lane == NOWHERE and a}
    for step in sorted(moves | off):
        before = step - 1
        if (
            0 < step < n
            and same[max(0, before - 2) : step].any()
            and not same[min(step, n - 1)]
            and 0 < lead[before] < limits.within
        ):
            return step
    return None


def overtake(seen: Seen, other: Seen) -> int | None:
    """The step at which it is ahead of the other, having begun behind it."""
    limits = definitions()["overtake"]
    placed = _along(seen, other)
    if placed is None:
        return None
    lead, d, _ = placed
    apart = 0.5 * (seen.path.length + other.path.length)
    near = np.abs(d) < limits.beside
    if lead[0] >= -0.5 * apart or not near[0] or lead[-1] <= apart or not near[-1]:
        return None
    return int(np.argmax(lead > apart))


def cross_path(seen: Seen, other: Seen, met: Meeting, situation: Situation) -> int | None:
    """The step at which the second of the two is at the point where their paths meet, or waits before it."""
    limits = definitions()["cross_path"]
    if met.one is None and met.one_short > limits.halted or met.other is None and met.other_short > limits.halted:
        return None
    if met.one is None and met.other is None:
        return None
    span = limits.time / situation.step
    first = met.one if met.one is not None else met.one_near
    second = met.other if met.other is not None else met.other_near
    if met.one is not None and met.other is not None:
        return max(first, second) if abs(first - second) <= span else None
    halted, passing = (second, first) if met.other is None else (first, second)
    return max(halted, passing) if passing >= halted - span else None


def passes_first(met: Meeting) -> int | None:
    """The step at which it is through the point where their paths meet, if that is before the other."""
    if met.one is None:
        return None
    return met.one if met.other is None or met.one < met.other else None


def yields(seen: Seen, other: Seen, met: Meeting, situation: Situation) -> int | None:
    """The step from which it lets the other pass first."""
    limits = definitions()["yield"]
    if not other.moves or seen.kind == "prop":
        return None
    end = met.one if met.one is not None else seen.until
    passed = met.other
    if passed is not None and met.one is not None and met.one <= passed:
        return None
    away = np.hypot(seen.x - met.x, seen.y - met.y)
    near = np.flatnonzero(away[: end + 1] <= limits.near)
    if not len(near):
        return None
    first = int(near[0])
    if passed is not None and passed < first:
        return None
    until = min(end, passed if passed is not None else seen.until)
    speed = seen.speed[first : until + 1]
    if not len(speed):
        return None
    slowed = np.flatnonzero((np.maximum.accumulate(speed) - speed > limits.loss) | (speed < limits.standing))
    if not len(slowed):
        return None
    after = seen.speed[until:]
    waiting = seen.speed[-1] < limits.standing
    goes_on = passed is not None and (met.one is not None or float(after.max()) > float(after[0]) + 0.5)
    comes = other.speed[min(other.until, first) :].max() > limits.standing
    if goes_on or waiting and comes:
        return first + int(slowed[0])
    return None


def box_gap(one: Seen, other: Seen, step: int = 0) -> float:
    """m between the two boxes at a step."""
    import shapely

    a, b = (
        shapely.Polygon(
            corners(float(o.x[step]), float(o.y[step]), float(o.heading[step]), o.path.length, o.path.width)
        )
        for o in (one, other)
    )
    return float(a.distance(b))

"""Events of two vehicles in one lane: following, cutting in and out, overtaking."""

from dataclasses import dataclass

import numpy as np

from c2s_engine.dryrun.events.lanes import across, changes
from c2s_engine.dryrun.events.motion import stretches
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation
from c2s_engine.dryrun.events.table import definitions


@dataclass(frozen=True)
class Beside:
    """Where one is on the way that another drives, by step: m ahead of it, m to its left, whether in its lane."""

    lead: np.ndarray
    aside: np.ndarray
    same: np.ndarray


def beside(seen: Seen, other: Seen, situation: Situation) -> Beside | None:
    """Where it is along the other's way, or along its own where the other is on no lane but stands out into its own;
    else None."""
    n = min(len(seen.x), len(other.x))
    if other.way is not None:
        (s, d), (mine, _) = other.placed(seen), other.placed(other)
    elif seen.way is not None:
        (s, _), (mine, d) = seen.placed(seen), seen.placed(other)
        if np.abs(d).min() - other.path.width / 2 > definitions()["overtake"].edge:
            return None
    else:
        return None
    return Beside(s[:n] - mine[:n], d[:n], _same_lane(seen, other, situation, n))


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


def follow(seen: Seen, other: Seen, placed: Beside, situation: Situation) -> int | None:
    """The step from which it is behind the other in one lane, if that lasts."""
    limits = definitions()["follow"]
    if other.kind == "bicycle" and not other.moves:
        return None
    behind = (placed.lead < 0) & (placed.lead > -limits.within) & placed.same
    for a, b in stretches(behind):
        if (b - a) * situation.step >= limits.time - 1e-6 and seen.travelled[b] - seen.travelled[a] > limits.travels:
            return a
    return None


def cut_in(seen: Seen, other: Seen, placed: Beside, situation: Situation) -> int | None:
    """The step at which it is in the other's lane, close ahead of it, having come from another lane."""
    limits = definitions()["cut_in"]
    lead, same, n = placed.lead, placed.same, len(placed.lead)
    apart = 0.5 * (seen.path.length + other.path.length)
    for a, b in stretches(same):
        if a == 0 or b - a + 1 < situation.at(limits.time) and b != n - 1:
            continue
        gap = lead[a] - apart
        came = seen.lanes[a - 1] not in (NOWHERE, seen.lanes[a]) and seen.speed[a] > 0.3
        came = came and not across(seen, situation, int(seen.lanes[a]), a)
        if came and lead[a] > 0 and gap <= limits.within and other.lanes[a] == other.lanes[a - 1]:
            return a
    return None


def cut_out(seen: Seen, placed: Beside, situation: Situation) -> int | None:
    """The step at which it leaves the other's lane, having been ahead in it."""
    limits = definitions()["cut_out"]
    lead, same, n = placed.lead, placed.same, len(placed.lead)
    moves = {step for _, step, _, _ in changes(seen, situation)}
    off = {a for lane, a, _ in seen.runs if lane == NOWHERE and a
           and not across(seen, situation, int(seen.lanes[a - 1]), a - 1)}  # fmt: skip
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


def lets_by(seen: Seen, other: Seen, placed: Beside) -> int | None:
    """The step from which it slows for the other, which comes from behind and gets past, after which it goes on."""
    limits = definitions()["yield"]
    if overtake(other, seen, Beside(-placed.lead, placed.aside, placed.same)) is None:
        return None
    passed = int(np.argmax(placed.lead < 0))
    first = int(np.argmax(placed.lead < limits.near))
    speed = seen.speed[first : passed + 1]
    slowed = np.flatnonzero(np.maximum.accumulate(speed) - speed > limits.loss)
    if not len(slowed) or seen.speed[passed:].max() - seen.speed[passed] <= limits.gain:
        return None
    return first + int(slowed[0])


def overtake(seen: Seen, other: Seen, placed: Beside) -> int | None:
    """The step at which it is ahead of the other, having begun behind it; what one does that has turned off, or goes
    across, does not count."""
    limits = definitions()["overtake"]
    lead, apart = placed.lead, 0.5 * (seen.path.length + other.path.length)
    near = np.abs(placed.aside) < limits.beside
    n = min(len(lead), len(seen.path.heading), len(other.path.heading))
    off = np.cos(seen.path.heading[:n] - other.path.heading[:n]) < 0.9
    if off.all():
        return None
    first = int(np.argmin(off))
    last = first + int(off[first:].argmax()) - 1 if off[first:].any() else len(lead) - 1
    if lead[first] >= -0.5 * apart or not near[first] or lead[last] <= apart or not near[last]:
        return None
    return first + int(np.argmax(lead[first:] > apart))

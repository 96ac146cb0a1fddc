"""Events on lanes: keeping, changing, drifting over their lines, leaving and entering the road."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.dryrun.events.motion import fact, stretches
from c2s_engine.dryrun.events.situation import NOWHERE, Seen, Situation, wrap
from c2s_engine.dryrun.events.table import definitions
from c2s_engine.structure.facts import EventFact


def lanes(seen: Seen, situation: Situation) -> Iterator[EventFact]:
    """All events of this module that an object shows."""
    if not seen.moves:
        return
    for name, step in (("enter_road", enter_road(seen, situation)), ("leave_road", leave_road(seen, situation))):
        if step is not None:
            yield fact(name, situation, step)
    if not seen.drives:
        return
    for name, step in (
        ("keep_lane", keep_lane(seen, situation)),
        ("swerve", swerve(seen)),
        ("skid", skid(seen, situation)),
        ("drift", drift(seen, situation)),
        ("oncoming_intrusion", oncoming_intrusion(seen, situation)),
    ):
        if step is not None:
            yield fact(name, situation, step)
    for side, step, _, _ in changes(seen, situation):
        yield fact("lane_change", situation, step)
        yield fact(f"lane_change_{side}", situation, step)


def continues(situation: Situation, a: int, b: int) -> bool:
    """Whether lane b is the continuation of a (or the other way round, for who drives against it)."""
    index = situation.index
    if a == b or b in index.lanes[a].next or a in index.lanes[b].next:
        return True
    return any(b in index.lanes[n].next for n in index.lanes[a].next if index.lanes[n].length < 15.0)


def keep_lane(seen: Seen, situation: Situation) -> int | None:
    """Whether it moves far enough and each lane that it is in continues the one before."""
    if seen.travelled[-1] <= definitions()["keep_lane"].distance or (seen.lanes == NOWHERE).any():
        return None
    used = [lane for lane, _, _ in seen.runs]
    return 0 if all(continues(situation, a, b) for a, b in zip(used, used[1:], strict=False)) else None


def beside(situation: Situation, a: int, b: int) -> str | None:
    """The side on which b, or the lane that b continues, is a's neighbour; lanes of the other direction are left."""
    lanes = situation.index.lanes
    info = lanes[a]
    before = situation.index.previous
    for other in (b, *(p for p in before.get(b, ()))):
        if other in info.left:
            return "left"
        if other in info.right:
            return "right"
    for onward in info.next:
        if b in lanes[onward].left:
            return "left"
        if b in lanes[onward].right:
            return "right"
    if b in info.opposite:
        return "left" if not situation.index.network.driveOnLeft else "right"
    return None


def _against(seen: Seen, situation: Situation, lane: int, step: int) -> bool:
    info = situation.index.lanes[lane]
    s, _ = info.project(seen.x[step], seen.y[step])
    return abs(float(wrap(seen.heading[step] - info.heading_at(s)))) > np.pi / 2


def across(seen: Seen, situation: Situation, lane: int, step: int) -> bool:
    """Whether it stands across a lane at a step: who crosses a road, or turns round on it, changes no lane there."""
    info = situation.index.lanes[lane]
    s, _ = info.project(seen.x[step], seen.y[step])
    turn = abs(np.sin(seen.heading[step] - info.heading_at(s)))
    return bool(turn > np.sin(np.radians(definitions()["lane_change"].turn)))


def changes(seen: Seen, situation: Situation) -> list[tuple[str, int, int, int]]:
    """(side, step, from, to) of each change into a neighbouring lane, as the driver sees the sides."""
    long = situation.at(definitions()["lane_change"].time)
    stays = [(lane, a, b) for lane, a, b in seen.runs if lane != NOWHERE and (b - a + 1 >= long or b == seen.until)]
    found = []
    for (one, _, _), (other, first, _) in zip(stays, stays[1:], strict=False):
        if one == other or continues(situation, one, other) or across(seen, situation, one, first):
            continue
        side = beside(situation, one, other)
        if side is None:
            continue
        if _against(seen, situation, one, first):
            side = "right" if side == "left" or other in situation.index.lanes[one].opposite else "left"
        found.append((side, first, one, other))
    return found


def swerve(seen: Seen) -> int | None:
    """The step at which it is back near its lane's middle after it was beside it."""
    limits = definitions()["swerve"]
    aside = np.abs(seen.aside())
    out = False
    been = False
    for step, value in enumerate(aside):
        if value < limits.back:
            if out:
                return step
            been = True
        elif been and value > limits.aside:
            out = True
    return None


def skid(seen: Seen, situation: Situation) -> int | None:
    """The step from which it slides at an angle to its heading."""
    limits = definitions()["skid"]
    turn = np.abs(wrap(np.arctan2(-seen.vx, seen.vy) - seen.heading[: len(seen.vx)]))
    slides = (turn > np.radians(limits.turn)) & (turn < np.pi / 2) & (seen.speed > limits.speed)
    return next((a for a, b in stretches(slides) if b - a + 1 >= situation.at(limits.time)), None)


def drift(seen: Seen, situation: Situation) -> int | None:
    """The step at which a side of it crosses a line of its lane slowly."""
    if seen.way is None:
        return None
    limits = definitions()["drift"]
    aside = seen.aside()
    lane = situation.index.lanes[next(int(i) for i in seen.lanes if i != NOWHERE)]
    turn = np.abs(np.sin(seen.heading - seen.way.headings_at(seen.placed(seen)[0])))
    half = 0.5 * (seen.path.width * np.sqrt(1 - turn**2) + seen.path.length * np.minimum(turn, 0.35))
    half = np.minimum(half, lane.width / 2 - 2 * limits.over)  # CARLA has buses that are wider than lanes
    over = np.abs(aside) + half - lane.width / 2
    inside = over <= 0
    rate = np.abs(np.gradient(aside, situation.step)) if len(aside) > 2 else np.zeros(len(aside))
    first = int(np.argmax(inside)) if inside.any() else None
    if first is None:
        return None
    for step in range(max(first, 1), len(aside)):
        if (
            over[step] > limits.over
            and over[step - 1] <= limits.over
            and rate[step] < limits.sideways
            and seen.speed[step] > 0.5
            and not (seen.lanes[step] != NOWHERE and across(seen, situation, int(seen.lanes[step]), step))
        ):
            return step
    return None


def _outside(seen: Seen) -> np.ndarray:
    return seen.lanes == NOWHERE


def enter_road(seen: Seen, situation: Situation) -> int | None:
    """The step at which it is on a driving lane, having started off them or stood there."""
    limits, outside = definitions()["enter_road"], _outside(seen)
    long = situation.at(limits.time)
    off = {b + 1: a for a, b in stretches(outside) if a == 0 or (seen.speed[a : b + 1] < limits.standing).any()}
    return next((a for a, b in stretches(~outside) if a in off and (b - a + 1 >= long or b == seen.until)), None)


def leave_road(seen: Seen, situation: Situation) -> int | None:
    """The step at which it is off all driving lanes, having been on one."""
    outside = _outside(seen)
    if outside.all():
        return None
    first = int(np.argmax(~outside))
    long = situation.at(definitions()["leave_road"].time)
    return next((a for a, b in stretches(outside) if a > first and (b - a + 1 >= long or b == seen.until)), None)


def oncoming_intrusion(seen: Seen, situation: Situation) -> int | None:
    """The step from which it travels against the direction of a lane outside junctions."""
    limits = definitions()["oncoming_intrusion"]
    course = np.arctan2(-seen.vx, seen.vy)
    for lane, a, b in seen.runs:
        info = situation.index.lanes[lane] if lane != NOWHERE else None
        if info is None or info.junction is not None:
            continue
        s, _ = info.project_many(seen.xy[a : b + 1])
        segment = np.clip(np.searchsorted(info.along, s, side="right") - 1, 0, len(info.headings) - 1)
        turn = np.abs(wrap(course[a : b + 1] - info.headings[segment]))
        against = (
            (turn > np.radians(limits.turn)) & (seen.speed[a : b + 1] > limits.speed) & (seen.forward[a : b + 1] > 0)
        )
        for first, last in stretches(against):
            if last - first + 1 >= situation.at(limits.time):
                return a + first
    return None

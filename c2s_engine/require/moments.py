"""The numbers of a phase at its moment: the gap as it comes over the lane line or begins to brake, how fast it moves
sideways, what it waits, how far it goes before it breaks off."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence, Motion, stretches
from c2s_engine.require.geometry import lead
from c2s_engine.require.results import between, scored, span, unknown, words
from c2s_engine.require.scene import TURNS, Scene, bounds
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.objects import SLOWS
from c2s_engine.structure.quantity import Quantity, high, low
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import Phase
from c2s_engine.structure.vocabulary import VEHICLES

OVER_LINE = ("cut_in", "cut_out", "lane_change")
SETS_OUT = ("enter_road", "cross_road", "leave_road", "move_along", "reverse")
"""What begins as somebody who stood sets out, long before it is seen on the road."""
SIDEWAYS = (*OVER_LINE, "swerve", "drift")
HAS_MOMENT = (*SLOWS, *SETS_OUT, *SIDEWAYS, "accelerate", "start", "overtake", "lose_control", "u_turn")
"""Actions whose beginning is seen."""
LANE = 3.5
"""m, of most maps' lanes."""
BEGUN = 0.3
"""m to the side by which one has begun to move there, which it has from when it was `AT_REST`, m."""
AT_REST = 0.05
TURNS_OFF = 0.8
"""rad by which one on foot that comes along the road turns towards it."""
STRAIGHT = 0.02
"""rad of heading within which one has not yet begun to turn."""
NEAR = 60.0
"""m within which one is for whom another waits."""
LATE = 3.0
"""s before a contact within which one swerves too late."""
WAITS = 20.0
"""m before a junction within which one waits there."""
HELD = 0.8
"""rad that one who waits in the middle of a junction has turned by then at most."""
LONGEST = 8.0
"""s that a move to the side takes at most until it is seen."""


def required(scene: Scene, actor: str, path: str, phase: Phase, of: str) -> Iterator[Requirement]:
    """What a phase states in numbers of its moment; `of`: the requirement that it is seen."""
    name, said, cid = scene.named(actor), phase.action.replace("_", " "), component_of(actor)
    if phase.gap is not None and phase.action in (*OVER_LINE, *SLOWS, "follow") and scene.stated(cid, f"{path}.gap"):
        other = phase.target or EGO
        later = phase.action == "follow" and not path.endswith(".0")  # it first has to come to that gap
        lasting = {"follow": "in the end" if later else "all along"}
        when = lasting.get(phase.action, "as it begins" if phase.action in SLOWS else "as it comes over the lane line")
        if other != actor:
            yield scene.make("place", "gap_then", actor, f"{path}.gap", f"{name}: {said} {low(phase.gap):g} m from "
                             f"{scene.named(other)}, {when}.", other=other, of=of, action=phase.action,
                             later=later, least=low(phase.gap), most=high(phase.gap))  # fmt: skip
    lasts = phase.duration if phase.action in OVER_LINE and not phase.abandoned else None
    if lasts is not None and scene.stated(cid, f"{path}.duration"):
        yield scene.make("phase", "lasts", actor, f"{path}.duration", f"{name}: {said} in {low(lasts):g} s.", of=of,
                         least=low(lasts), most=high(lasts))  # fmt: skip
    if phase.lateral_speed is not None and phase.action in SIDEWAYS and scene.stated(cid, f"{path}.lateral_speed"):
        yield scene.make("speed", "moves_aside", actor, f"{path}.lateral_speed", f"{name}: {said} at "
                         f"{low(phase.lateral_speed):g} m/s sideways.", of=of, action=phase.action,
                         least=low(phase.lateral_speed), most=high(phase.lateral_speed))  # fmt: skip


def delays(scene: Scene) -> Iterator[Requirement]:
    """That phases begin so long after the start, or after what they wait for, as is said: after all that is seen."""
    for actor, i, phase in scene.phases():
        trigger, path, cid = phase.trigger, f"phases.{i}", component_of(actor)
        if trigger is None or trigger.kind not in ("time", "action") or trigger.subject not in (None, actor):
            continue
        since = due(phase)
        if trigger.delay is None and since is None or not says_when(scene, cid, path, phase):
            continue
        after: Quantity = since if since is not None else trigger.delay or 0.0
        when = f"{low(after):g} s " + ("later" if since is None else "after the start")
        yield scene.make("order", "delayed", actor, f"{path}.delay", f"{scene.named(actor)}: "
                         f"{phase.action.replace('_', ' ')} {when}.", of=f"{cid}.{path}.{phase.action}",
                         action=phase.action, after=_awaited(scene, trigger.of, trigger.action), other=trigger.of,
                         its=trigger.action or "", least=low(after), most=high(after))  # fmt: skip


def says_when(scene: Scene, cid: str, path: str, phase: Phase) -> bool:
    """Whether S itself says the time, or the delay, of a phase's trigger: the planner chose neither."""
    field = "delay" if phase.trigger is not None and phase.trigger.delay is not None else "value"
    return scene.stated(cid, f"{path}.trigger") and scene.stated(cid, f"{path}.trigger.{field}")


def due(phase: Phase) -> Quantity | None:
    """How long after the start of the run (s) a phase begins that has a moment; None: no such time is said."""
    t = phase.trigger
    if t is None or t.kind != "time" or t.value is None or t.subject or phase.action not in HAS_MOMENT:
        return None
    delay = t.delay or 0.0
    return low(t.value) + low(delay), high(t.value) + high(delay)


def _awaited(scene: Scene, of: str | None, action: str | None) -> str:
    """The requirement that what is waited for is seen; '' for none."""
    for actor, i, phase in scene.phases():
        if actor == of and phase.action == action:
            return f"{component_of(actor)}.phases.{i}.{action}"
    return ""


def beside(motion: Motion) -> np.ndarray:
    """m to the left of where it drives first, at each step, over lane changes too."""
    aside = motion.of_course("aside")
    steps = np.diff(aside, prepend=aside[:1])
    # its way may go on in another lane from one sample to the next
    window = min(max(1, round(0.4 / motion.step)), len(steps))
    moved = np.convolve(steps, np.ones(window), mode="same")
    steps[np.abs(moved) > LANE / 2] = 0.0
    return np.asarray(np.cumsum(steps))


def onset(motion: Motion, action: str, time: float) -> float:
    """When what is seen of an action at a time began, s."""
    at = motion.at(time)
    if action in (*SIDEWAYS, "overtake", "oncoming"):  # who overtakes begins as it pulls out
        first = motion.at(time - LONGEST)
        moved = np.abs(beside(motion)[first : at + 1] - beside(motion)[first])
        if not (moved > BEGUN).any():
            return time
        begun = int((moved > BEGUN).argmax())
        while begun > 0 and AT_REST < moved[begun - 1] < moved[begun]:
            begun -= 1
        return float(motion.time[first + begun])
    if action in (*SLOWS, "accelerate"):
        sign, rate = (-1 if action in SLOWS else 1), bounds()["phase"]["change_rate"]["value"] / 2
        while at > 0 and sign * motion.acceleration[at] <= rate and motion.time[at] > time - 1.0:
            at -= 1
        while at > 0 and sign * motion.acceleration[at - 1] > rate:
            at -= 1
        return float(motion.time[at])
    if action == "u_turn":
        away = np.abs(motion.heading[: at + 1] - motion.heading[at])
        before = np.flatnonzero(away > away.max() - STRAIGHT)
        return float(motion.time[before[-1]])
    if action in TURNS:  # one that holds in the junction turns as it sets off again
        turned = np.abs(motion.heading - motion.heading[at])
        held = np.flatnonzero((motion.speed < STANDING) & (turned < HELD) & (motion.time > time))
        there = motion.stay(float(motion.time[held[-1]])) if held.size else None
        if there is not None and there.kind == "junction":
            return float(motion.time[min(int(held[-1]) + 1, len(motion.time) - 1)])
    if action in (*SETS_OUT, *TURNS) and (stood := np.flatnonzero(motion.speed[: at + 1] < STANDING)).size:
        begun = min(int(stood[-1]) + 1, at)
        if action in ("enter_road", "cross_road"):  # who came along the road before turns first
            ways = np.unwrap(np.arctan2(np.diff(motion.y[begun : at + 1]), np.diff(motion.x[begun : at + 1])))
            turned = np.flatnonzero(np.abs(ways - ways[-1:]) > TURNS_OFF)
            begun += int(turned[-1]) + 1 if len(turned) else 0
        return float(motion.time[begun])
    return time


def swerves(motion: Motion) -> list[float]:
    """When each of its swerves begins, to whichever side, after which it comes back."""
    aside, least = beside(motion), bounds()["phase"]["swerve"]["value"]
    near = bounds()["reaction"]["aside"]["value"]
    outs = sorted(out for side in (1, -1) for out in stretches(side * aside > least))
    begun = (np.flatnonzero(np.abs(aside[:a]) < near) for a, b in outs if (np.abs(aside[b:]) < least).any())
    return [float(motion.time[before[-1]]) for before in begun if len(before)]


def cut_off(motion: Motion) -> list[float]:
    """When one begins to move aside that is still at it when it touches somebody."""
    first = motion.at(motion.time[-1] - LATE)
    moved = np.abs(beside(motion)[first:] - beside(motion)[first]) > BEGUN / 2
    return [float(motion.time[first + int(moved.argmax())])] if motion.contact is not None and moved.any() else []


def over_line(motion: Motion, time: float) -> float | None:
    """When its side comes over the lane line in a move to the side that is seen at a time, s."""
    first, last = motion.at(time - LONGEST), motion.at(time + 1.0)
    room = max((LANE - motion.size[1]) / 2, BEGUN)  # what is as wide as its lane has begun to come over then
    moved = np.abs(beside(motion)[first : last + 1] - beside(motion)[first]) >= room
    return float(motion.time[first + int(moved.argmax())]) if moved.any() else None


def lengthwise(one: Motion, other: Motion, at: int) -> float:
    """m along the road from bumper to bumper of two at a step; below 0 where they are side by side."""
    a, b = min(at, len(one.x) - 1), min(at, len(other.x) - 1)
    return float(abs(lead(other.poses[b], one.poses[a])) - (one.size[0] + other.size[0]) / 2)


def gap_then(requirement: Requirement, evidence: Evidence) -> Result:
    v, limits = requirement.values, bounds()["phase"]
    (least, most), action, said = span(requirement), str(v["action"]), words(requirement, "m")
    motion, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    time = evidence.times.get(str(v["of"]))
    if motion is None or other is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    room = max(limits["gap"]["value"], limits["gap_share"]["value"] * most)
    if v["later"]:
        when = list(range(motion.at(time), min(len(motion.x), len(other.x))))
        gaps = [lengthwise(motion, other, at) for at in when]
        off = np.abs(np.array(gaps) - np.clip(gaps, least, most))
        best = int((off < room / 2).argmax()) or int(off.argmin())
        gap, moment = gaps[best], float(motion.time[when[best]])
        evidence.times[requirement.id] = moment
    elif action == "follow":
        when = _while_followed(motion, other, time)
        gaps = [lengthwise(motion, other, at) for at in when]
        gap = gaps[int(np.abs(np.array(gaps) - (least + most) / 2).argmax())]
        moment = time
    else:
        over = over_line(motion, time) if action in OVER_LINE else onset(motion, action, time)
        if over is None:
            return unknown(requirement, said, "not judged: it crosses no lane line")
        gap, moment = lengthwise(motion, other, motion.at(over)), over
    return between(requirement, gap, room, said, f"{gap:.1f} m", moment)


def _while_followed(motion: Motion, other: Motion, time: float) -> list[int]:
    """The steps from when both have settled, or it follows, until either changes its speed or moves aside."""
    first = motion.at(max(time, bounds()["natural"]["settles"]["value"]))
    last = min(len(motion.x), len(other.x)) - 1
    changed = [
        np.flatnonzero((np.abs(m.smooth[: last + 1] - m.smooth[first]) > 1.0)
                       | (np.abs(beside(m)[: last + 1] - beside(m)[first]) > BEGUN))
        for m in (motion, other)
    ]  # fmt: skip
    ends = [int(c[c > first][0]) for c in changed if (c > first).any()]
    return list(range(first, max(first + 1, min([last, *ends]))))


def too_late(motion: Motion, other: Motion | None) -> float | None:
    """s by which one that comes over the lane line behind somebody would have to be there later (below 0: earlier) to
    do so well ahead; None: it does not come over."""
    moved = np.abs(beside(motion)) >= (LANE - motion.size[1]) / 2
    if other is None or not moved.any():
        return None
    at = min(int(moved.argmax()), len(other.x) - 1)
    ahead = -float(lead(motion.poses[at], other.poses[at]))
    wanted = (motion.size[0] + other.size[0]) / 2 + bounds()["phase"]["gap"]["value"] * 4
    return round(-max(wanted - ahead, 0.0) / max(float(other.speed[at]), 1.0), 2) or None


def moves_aside(requirement: Requirement, evidence: Evidence) -> Result:
    limits, said = bounds()["phase"], f"{words(requirement, 'm/s')} sideways"
    motion, time = evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    window = slice(motion.at(time - LONGEST), motion.at(time + 2.0) + 1)
    width = max(1, round(0.4 / motion.step))
    moved = beside(motion)[window]
    if len(moved) <= width:
        return unknown(requirement, said, "not judged: the run is too short")
    speeds = np.abs(moved[width:] - moved[:-width]) / (width * motion.step)
    seen = float(np.median(speeds[speeds > 0.5 * speeds.max()]))
    room = limits["lateral"]["value"] + limits["lateral_share"]["value"] * span(requirement)[1]
    return between(requirement, seen, room, said, f"{seen:.1f} m/s", time)


def lasts(requirement: Requirement, evidence: Evidence) -> Result:
    """From when it begins to move aside until it is in the middle of the other lane."""
    limits, said = bounds()["phase"], words(requirement, "s")
    motion, time = evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    first, last = motion.at(time - LONGEST), motion.at(time + LONGEST)
    moved = np.abs(beside(motion)[first : last + 1] - beside(motion)[first])
    begins, ends = (int((moved > far).argmax()) for far in (BEGUN / 2, min(moved.max(), LANE) - BEGUN))
    room = limits["lasts"]["value"] + limits["lasts_share"]["value"] * span(requirement)[1]
    seen = (ends - begins) * motion.step
    return between(requirement, seen, room, said, f"{seen:.1f} s", float(motion.time[first + begins]))


def delayed(requirement: Requirement, evidence: Evidence) -> Result:
    v = requirement.values
    said = f"{words(requirement, 's')} {'later' if v['after'] else 'after the start'}"
    motion, time = evidence.motion(requirement.actor), evidence.times.get(str(v["of"]))
    cause, first = evidence.motion(requirement.other or EGO), evidence.times.get(str(v["after"]))
    if motion is None or time is None or v["after"] and (first is None or cause is None):
        return unknown(requirement, said, "not judged: one of the two events did not occur")
    since = first or 0.0
    if cause is not None and first is not None and v["its"] != "stop":  # else it counts from when that one stands
        since = onset(cause, str(v["its"]), first)
    seen = onset(motion, str(v["action"]), time) - since
    limits = bounds()["order"]
    room = min(limits["delay"]["value"] + 0.2 * span(requirement)[1], limits["delay_most"]["value"])
    return between(requirement, seen, room, said, f"{seen:.1f} s", time)


def got_past(motion: Motion, other: Motion | None) -> list[float]:
    """When it has got past one that is no vehicle, having begun behind it."""
    if other is None or other.kind in VEHICLES:
        return []
    n, apart = min(len(motion.x), len(other.x)), 0.5 * (motion.size[0] + other.size[0])
    ahead = -lead(motion.poses[:n], other.poses[:n])
    return [float(motion.time[int(np.argmax(ahead > apart))])] if ahead[0] < -apart and ahead.max() > apart else []


def let_go_first(motion: Motion, other: Motion | None) -> list[float]:
    """When it begins to slow down for one level with it or behind it in the next lane, that is ahead of it then."""
    if other is None or motion is other:
        return []
    n = min(len(motion.x), len(other.x))
    ahead = lead(motion.poses[:n], other.poses[:n])
    need, half = bounds()["phase"]["change"]["value"], (motion.size[0] + other.size[0]) / 2
    for a, b in stretches(motion.acceleration[:n] < -bounds()["phase"]["change_rate"]["value"] / 2):
        if motion.smooth[a] - motion.smooth[b] > need and ahead[a] < half and (ahead[a:] > half).any():
            return [float(motion.time[a])]
    return _waited(motion, other)


def _waited(motion: Motion, other: Motion) -> list[float]:
    """When it begins to slow down before a junction in which another is then, who comes nearer to where it waits."""
    n, change = min(len(motion.x), len(other.x)), bounds()["phase"]["change"]["value"]
    speed = motion.smooth[:n]
    slow = int(speed.argmin())
    began = slow - int((speed[: slow + 1][::-1] > speed[slow] + change).argmax())
    again = slow + int((speed[slow:] > speed[slow] + change).argmax())
    if speed[: slow + 1].max() - speed[slow] < change or again == slow:
        return []
    front, apart = motion.of_course("along")[slow], np.hypot(other.x - motion.x[slow], other.y - motion.y[slow])
    before = any(m.kind == "line" and abs(m.start - front) < WAITS for m in motion.course.marks)
    within = any(s is not None and s.kind == "junction" for s in map(other.stay, other.time[began:again]))
    return [float(motion.time[began])] if before and within and apart[again] < min(apart[began], NEAR) else []


def kept_from(motion: Motion, time: float, within: float = 1.0) -> list[float]:
    """When what is said before was seen, if it stays in the lane in which it is `within` s of that, or less."""
    at = motion.stay(time + within)
    later = [s for s in motion.course.stays if s.time > time + within]
    return [time] if at is not None and all(s.to_ego == at.to_ego for s in later) else []


def breaks_off(requirement: Requirement, evidence: Evidence) -> Result:
    """It comes some way over the lane line, and is back in the middle of its own without having been in the other."""
    limits, said = bounds()["phase"], "begun, and back in its own lane"
    motion = evidence.motion(requirement.actor)
    if motion is None:
        return unknown(requirement, said, "not judged: it is missing from the run")
    moved = beside(motion)
    back = limits["back"]["value"]
    out = np.flatnonzero(np.abs(moved - moved[0]) > limits["begun"]["value"])
    evidence.times[requirement.id] = float(motion.time[out[0]]) if len(out) else None
    if not len(out):
        return scored(requirement, -1.0, said, f"{np.abs(moved - moved[0]).max():.1f} m to the side at most")
    far = float(np.abs(moved - moved[0]).max())
    again = np.abs(moved[out[0] :] - moved[0]) < back
    seen = f"{far:.1f} m to the side, " + ("and back" if again.any() else "and stays there")
    over = far - (LANE - motion.size[1]) / 2
    margin = min(motion.size[1] - over, (over - limits["over"]["value"]) / 0.5, 1.0) if again.any() else -1.0
    return scored(requirement, margin, said, seen, float(motion.time[out[0]]))


def halts_before(requirement: Requirement, evidence: Evidence) -> Result:
    """It goes towards the road, and comes to a stand before it is on a lane."""
    motion, said = evidence.motion(requirement.actor), "as far as the road's edge"
    if motion is None:
        return unknown(requirement, said, "not judged: it is missing from the run")
    came = float(np.hypot(motion.x - motion.x[0], motion.y - motion.y[0]).max())
    moving = np.flatnonzero(motion.speed >= STANDING)
    evidence.times[requirement.id] = time = float(motion.time[moving[-1]]) if len(moving) else None
    on_it = {"enter_road", "cross_road"} & {e.event for e in motion.facts.events}
    seen = f"{came:.1f} m, {'onto the road' if on_it else 'and stays off the road'}"
    return scored(requirement, -1.0 if on_it else min(1.0, came - 1.0), said, seen, time)


CHECKS = {"halts_before": halts_before, "gap_then": gap_then, "moves_aside": moves_aside, "delayed": delayed,
          "breaks_off": breaks_off, "lasts": lasts}  # fmt: skip

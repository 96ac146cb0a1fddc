"""Every phase that S says is seen: by its actor, towards its partner, to its side, at its place, in S's order."""

from collections.abc import Iterator
from copy import copy

import numpy as np

from c2s_engine.require import moments
from c2s_engine.require.evidence import STANDING, Evidence, Motion, stretches
from c2s_engine.require.geometry import box_distance
from c2s_engine.require.results import between, decided, scored, span, unknown
from c2s_engine.require.scene import Scene, bounds, kmh, shown_by
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result, Value
from c2s_engine.structure.specs import ObjectSpec, Phase
from c2s_engine.structure.triggers import is_watched

SIDED = ("cut_in", "cut_out", "swerve", "drift", "leave_road")
AT_JUNCTION = ("turn_left", "turn_right", "go_straight", "run_red", "run_stop")
BY_SPEED = ("brake", "stop", "accelerate", "start", "wait", "stationary")
"""Seen on the tracks, so that a second braking is seen too; the others by the events of the run."""
SLOWS = ("stop", "brake", "wait")
CREEPS = 0.8
"""m/s over which one has set out: people creep at 2 to 5 km/h."""
SHARE = 0.5
"""Of a small change of speed that S says, what must be seen."""
LASTING = ("keep_lane", "follow", "stationary", "move_along", "oncoming", "wait")
"""States rather than moments: their order says nothing."""


def required(scene: Scene) -> Iterator[Requirement]:
    before: dict[str, tuple[str, Phase]] = {}  # by actor: what is said before, with its phase
    for actor, i, phase in scene.phases():
        path, name = f"phases.{i}", scene.named(actor)
        if phase.action == "overtake" and phase.abandoned:
            continue  # c2s_engine/require/manoeuvres.py
        shows = shown_by(phase.action)
        if phase.action == "cross_road" and _broken_off(scene, actor, i):
            shows = ("enter_road", *shows)
        if phase.action == "lane_change" and phase.side:
            shows = (f"lane_change_{phase.side}",)
        if not shows and phase.action not in BY_SPEED or phase.action == "keep_lane" and _leaves_later(scene, actor, i):
            continue  # nothing shows it, or not the run as a whole
        said = phase.action.replace("_", " ")
        stands = phase.until is not None and phase.action == "stationary"  # not for good
        values: dict[str, Value] = {"action": "wait" if stands else phase.action, "events": shows}
        after, one = before.get(actor, (None, None))
        if after and one:
            values["after"] = after
            values["again"] = (one.action, one.target) == (phase.action, phase.target)
        since = moments.due(phase)
        if since is not None and moments.says_when(scene, component_of(actor), path, phase):
            values["due"] = low(since)
        if (change := _change(scene, actor, i)) is not None:
            values["change"] = change
        if phase.action == "stop" and _after_contact(scene, actor, i):
            values["rolls_out"] = True
        if phase.action in AT_JUNCTION and any(p.action in SLOWS for p in scene.actors[actor].phases[i + 1 :]):
            values["halts"] = True
        if phase.duration is not None and scene.stated(component_of(actor), f"{path}.duration"):
            values["duration"] = low(phase.duration)
        towards = f" ({scene.named(phase.target)})" if phase.target else ""
        check = "breaks_off" if phase.abandoned and phase.action in moments.OVER_LINE else "shown"
        check = "halts_before" if phase.abandoned and phase.action == "cross_road" else check
        said += " started and aborted" if check != "shown" else ""
        seen = scene.make("phase", check, actor, f"{path}.{phase.action}", f"{name}: {said}{towards}.",
                          other=phase.target, **values)  # type: ignore[arg-type]  # fmt: skip
        yield seen
        yield from _details(scene, actor, path, phase, seen.id)
        yield from moments.required(scene, actor, path, phase, seen.id)
        if phase.action not in LASTING:
            was = scene.actors[actor].phases[i - 1].action if i else ""
            gives_way = phase.action == "yield" and was in SLOWS  # slowing down is how it does that
            gives_way |= scene.place.kind == "roundabout" and was == "yield"  # on the way into it
            if after and not gives_way:
                yield scene.make("order", "in_order", actor, f"{path}.order", f"{name}: {said} comes after its "
                                 "previous phase.", first=after, second=seen.id)  # fmt: skip
            before[actor] = seen.id, phase
    yield from _awaited(scene)
    yield from moments.delays(scene)


def _leaves_later(scene: Scene, actor: str, i: int) -> bool:
    """Whether somebody who keeps its lane at first leaves it in a later phase, or so as to get out of the way."""
    evades = actor == EGO and scene.ego.reaction == "evade"
    leaves = (*SIDED, *AT_JUNCTION, "lane_change", "overtake", "u_turn", "collide", "lose_control", "oncoming")
    return evades or any(p.action in leaves for p in scene.actors[actor].phases[i + 1 :])


def _broken_off(scene: Scene, actor: str, i: int) -> bool:
    """Whether somebody who crosses stops on the way over, or turns back."""
    after = scene.actors[actor].phases[i + 1 : i + 2]
    return any(p.action in ("stop", "stationary", "wait", "leave_road", "reverse") for p in after)


def _after_contact(scene: Scene, actor: str, index: int) -> bool:
    """Whether it is after a contact that somebody does what a phase says: its own, or one that it waits for."""
    phases = scene.actors[actor].phases[: index + 1]
    return any(p.action == "collide" or p.trigger is not None and p.trigger.kind == "contact" for p in phases)


def _change(scene: Scene, actor: str, i: int) -> float | None:
    """By how much (m/s) S says that a phase changes the speed; None: it does not say it."""
    phases = scene.actors[actor].phases
    one, two = (scene.speed(actor, p, f"phases.{k}.speed") for k, p in ((i - 1, phases[i - 1]), (i, phases[i])))
    if i == 0 or phases[i].action not in ("brake", "accelerate") or one is None or two is None:
        return None
    return max(abs(sum(two) - sum(one)) / 2, 0.1)


def _details(scene: Scene, actor: str, path: str, phase: Phase, of: str) -> Iterator[Requirement]:
    name, said = scene.named(actor), phase.action.replace("_", " ")
    if phase.side and phase.action in SIDED:
        yield scene.make("phase", "to_side", actor, f"{path}.side", f"{name}: {said} to the {phase.side}.",
                         of=of, side=phase.side)  # fmt: skip
    if phase.action in AT_JUNCTION and scene.place.kind == "intersection":
        yield scene.make("place", "in_junction", actor, f"{path}.place", f"{name}: {said} in the junction on ego's "
                         "way.", of=of)  # fmt: skip
    rate = phase.rate if phase.action in ("brake", "stop") else None
    if rate is not None and scene.stated(component_of(actor), f"{path}.rate"):
        yield scene.make("phase", "rate", actor, f"{path}.rate", f"{name}: {said} with {low(rate):g} m/s2.",
                         of=of, least=low(rate), most=high(rate))  # fmt: skip
    if (goal := scene.speed(actor, phase, f"{path}.speed")) is not None and goal[1] > 0:
        least, most = goal
        yield scene.make("speed", "reaches", actor, f"{path}.speed", f"{name}: {said} at {kmh(least, most)}.", of=of,
                         least=least, most=most)  # fmt: skip
    trigger = phase.trigger if phase.trigger and not is_watched(phase.trigger, actor) else None
    if trigger and trigger.kind == "place" and trigger.place and scene.stated(component_of(actor), f"{path}.trigger"):
        value = high(trigger.value) if trigger.value is not None else 0.0
        where = "end of the acceleration lane" if trigger.place == "merge_end" else trigger.place
        text = f"{name}: {said} at the {where}."
        yield scene.make("place", "near_place", actor, f"{path}.trigger", text, of=of, place=trigger.place,
                         within=value, action=phase.action)  # fmt: skip
    whom = (trigger.of or (None if actor == EGO else EGO)) if trigger else None
    if trigger and trigger.kind == "distance" and trigger.value is not None and whom is not None and not trigger.delay \
            and scene.stated(component_of(actor), f"{path}.trigger.value"):  # fmt: skip
        text = f"{name}: {said} when {scene.named(whom)} is {high(trigger.value):g} m away."
        centres = not scene.recognised(actor)  # `distance from` of a program is from centre to centre
        one = scene.objects.get(actor)
        hidden = whom == EGO and isinstance(one, ObjectSpec) and one.placement.hidden_by is not None
        yield scene.make("place", "at_distance", actor, f"{path}.trigger", text, other=whom, of=of,
                         least=low(trigger.value), most=high(trigger.value), centres=centres, hidden=hidden,
                         action=phase.action)  # fmt: skip


def _awaited(scene: Scene) -> Iterator[Requirement]:
    """Who waits for another's action acts after it."""
    ids: dict[tuple[str, str], str] = {}
    for actor, i, phase in scene.phases():
        ids.setdefault((actor, phase.action), f"{component_of(actor)}.phases.{i}.{phase.action}")
    for actor, i, phase in scene.phases():
        trigger = phase.trigger
        if trigger is None or trigger.kind != "action" or trigger.of is None or trigger.action is None:
            continue
        if trigger.action == "overtake" and scene.overtakes(trigger.of, actor):
            continue  # c2s_engine/require/manoeuvres.py
        if (first := ids.get((trigger.of, trigger.action))) is None:
            continue
        text = f"{scene.named(actor)}: {phase.action.replace('_', ' ')} comes after {scene.named(trigger.of)}: " \
            f"{trigger.action.replace('_', ' ')}."  # fmt: skip
        yield scene.make("order", "awaited", actor, f"phases.{i}.awaits", text, other=phase.target, first=first,
                         second=f"{component_of(actor)}.phases.{i}.{phase.action}", action=phase.action,
                         events=shown_by(phase.action), cause=trigger.of, its=trigger.action)  # fmt: skip


def shown(requirement: Requirement, evidence: Evidence) -> Result:
    action = str(requirement.values["action"])
    said = action.replace("_", " ")
    motions = evidence.motions(requirement.actor)
    if not motions:
        return unknown(requirement, said, "not judged: the actor is not there")
    earliest = evidence.times.get(str(requirement.values.get("after"))) or 0.0
    found = [_moment(requirement, evidence, m, action, earliest) for m in motions]
    missing = [m for m, t in zip(motions, found, strict=True) if t is None]
    if missing:
        evidence.times[requirement.id] = None
        return _missed(requirement, evidence, missing[0], action, said)
    time = min(t for t in found if t is not None)
    evidence.times[requirement.id] = time
    return scored(requirement, 1.0, said, f"{said} at {time:.1f} s", time)


def _moment(requirement: Requirement, evidence: Evidence, motion: Motion, action: str, earliest: float) -> float | None:
    """When an actor shows an action: the first time after what is said before, else the first at all."""
    if action in BY_SPEED:
        v = requirement.values
        motion = motion.beyond_contact if "rolls_out" in v else motion
        times = by_speed(motion, action, float(v.get("duration", 1.0)), float(v.get("change", np.inf)))  # type: ignore[arg-type]
    else:
        partners = {o.name for o in evidence.members(requirement.other)} if requirement.other else None
        events = requirement.values["events"]
        assert isinstance(events, tuple)
        times = [
            e.time for e in motion.facts.events
            if e.event in events and (partners is None or e.other is None or e.other in partners)
        ]  # fmt: skip
        if action == "enter_road" and not times and motion.contact is not None and motion.speed[0] < STANDING:
            times = [float(motion.time[k]) for k in np.flatnonzero(motion.speed > 1.0)[:1]]  # struck on its way onto it
        if action == "swerve":
            times = [_begun(motion, t) for t in times] or moments.cut_off(motion)
        if action in AT_JUNCTION and not times:
            times = _cut_short(motion, action, halts="halts" in requirement.values)
        if action == "overtake" and not times:
            whom = requirement.other or EGO
            hits = (c.time for c in evidence.contacts(requirement.actor, whom))
            begun = [t for hit in hits if (t := moments.onset(motion, action, hit)) < hit]
            times = moments.got_past(motion, evidence.motion(whom)) or begun
        if action == "yield" and not times:
            times = moments.let_go_first(motion, evidence.motion(requirement.other or EGO))
        if action == "keep_lane" and earliest and not times:
            passing = str(requirement.values["after"]).endswith(".overtake")  # coming back is part of that
            times = moments.kept_from(motion, earliest, *((moments.LONGEST,) if passing else ()))
    room = 0.0 if action == "start" else bounds()["order"]["room"]["value"]  # a stand ends after it has begun
    since = float(requirement.values.get("due", 0.0)) - bounds()["order"]["delay_most"]["value"]  # type: ignore[arg-type]
    if any(t >= since for t in times):  # what comes before is something else
        earliest = max(earliest, since)
    if requirement.values.get("again"):
        times = [t for t in (moments.swerves(motion) if action == "swerve" else times) if t > earliest + room]
    later = [t for t in times if t >= earliest - room]
    if action == "yield" and times and not later:  # it stood before, and lets that one pass as it may go
        return earliest
    return min(later) if later else min(times, default=None)


def _begun(motion: Motion, time: float) -> float:
    """When it left its lane's middle by what it does at a time, where it is back."""
    aside = np.abs(motion.of_course("aside"))[: motion.at(time) + 1]
    near = np.flatnonzero(aside[: int(aside.argmax()) + 1] < bounds()["reaction"]["aside"]["value"])
    return float(motion.time[near[-1]]) if len(near) else time


def _cut_short(motion: Motion, action: str, halts: bool) -> list[float]:
    """When it came into the junction in which a contact ended its way, or, where S says that it `halts`, its coming to
    a stand, if it was going that way by then."""
    inside = [s for s in motion.course.stays if s.kind == "junction"]
    if motion.contact is not None and action in ("turn_left", "turn_right"):  # or as it begins to turn
        inside = inside or list(motion.course.stays[-1:])
    ended = motion.contact is not None or halts and motion.speed[-1] < STANDING
    if not ended or not inside or action in ("run_red", "run_stop"):
        return []
    turned = float(motion.heading[-1] - motion.heading[motion.at(inside[-1].time)])
    begun = bounds()["phase"]["turn_begun"]["value"]
    going = {"turn_left": turned > begun, "turn_right": turned < -begun, "go_straight": abs(turned) < 3 * begun}
    return [inside[-1].time] if going[action] else []


def by_speed(motion: Motion, action: str, duration: float, change: float = np.inf) -> list[float]:
    """When it brakes, gains speed, comes to a stand, sets out, or stands for a while (s); `change`: m/s that S says."""
    speed, limits = motion.smooth, bounds()["phase"]
    if action in ("brake", "accelerate"):
        sign = -1 if action == "brake" else 1
        changes = stretches(sign * motion.acceleration > limits["change_rate"]["value"] / 2)
        need = min(limits["change"]["value"], SHARE * change)
        return [motion.time[a] for a, b in changes if sign * (speed[b] - speed[a]) > need]
    standing = stretches(motion.speed < STANDING)
    if action == "stop":
        return [motion.time[a] for a, b in standing if a > 0]
    if action == "start":
        return [motion.time[b] for a, b in standing if b + 1 < len(speed) and motion.speed[b:].max() > CREEPS]
    if action == "stationary":
        return [0.0] if not motion.moves else []
    return [motion.time[a] for a, b in standing if (b - a) * motion.step >= 0.8 * duration]


def _missed(requirement: Requirement, evidence: Evidence, motion: Motion, action: str, said: str) -> Result:
    """What was seen instead, and how far it is from what is said."""
    instead = list(dict.fromkeys(e.event.replace("_", " ") for e in motion.facts.events))
    seen = f"did not occur; instead: {', '.join(instead[:4])}" if instead else "no notable event"
    seen += f"; its behavior ended at line {motion.facts.line} of the program" if motion.facts.line else ""
    margin = -1.0
    if action == "brake":
        drop = float((np.maximum.accumulate(motion.smooth) - motion.smooth).max())
        margin = min(-0.05, (drop - bounds()["phase"]["change"]["value"]) / 2)
    elif action == "stop":
        motion = motion.beyond_contact if "rolls_out" in requirement.values else motion
        margin = min(-0.05, -float(motion.speed.min()) / 5)
    elif action == "collide" and (other := evidence.motion(requirement.other or EGO)):
        n = min(len(motion.x), len(other.x))
        gap = float(box_distance(motion.poses[:n], other.poses[:n], motion.size, other.size).min())
        margin, seen = min(-0.05, -gap / 5), f"no nearer than {gap:.1f} m"
    cuts_in = action == "cut_in" and requirement.other is not None
    due = moments.too_late(motion, evidence.motion(requirement.other or EGO)) if cuts_in else None
    return scored(requirement, margin, said, seen, due=due)


def in_order(requirement: Requirement, evidence: Evidence) -> Result:
    first = evidence.times.get(str(requirement.values["first"]))
    second = evidence.times.get(str(requirement.values["second"]))
    if first is None or second is None:
        return unknown(requirement, "in this order", "not judged: one of the two events did not occur")
    room = bounds()["order"]["room"]["value"]
    seen = f"{first:.1f} s, then {second:.1f} s"
    if first - room <= second < first:
        seen = f"at about the same time, {first:.1f} s and {second:.1f} s"
    return scored(requirement, (second - first + room) / 1.0, "in this order", seen, second)


def awaited(requirement: Requirement, evidence: Evidence) -> Result:
    """What waits for another's action comes after that has begun; that it did the same before, as for a bend, does not
    matter."""
    v = requirement.values
    cause, one = evidence.motion(str(v["cause"])), evidence.motion(requirement.actor)
    for motion, key, action in ((cause, str(v["first"]), str(v["its"])), (one, str(v["second"]), str(v["action"]))):
        time = evidence.times.get(key)
        if motion is not None and time is not None and action in moments.SETS_OUT:  # it can be seen from then on
            evidence.times[key] = moments.onset(motion, action, time)
    first = evidence.times.get(str(v["first"]))
    begins = (*moments.SIDEWAYS, "oncoming", "u_turn", "overtake")
    if cause is not None and first is not None and str(v["its"]) in begins:  # seen as it begins
        evidence, times = copy(evidence), evidence.times
        evidence.times = {**times, str(v["first"]): moments.onset(cause, str(v["its"]), first)}
    result = in_order(requirement, evidence)
    if result.holds is not False or first is None or str(v["action"]) in moments.SETS_OUT:
        return result
    again = [_moment(requirement, evidence, m, str(requirement.values["action"]), first)
             for m in evidence.motions(requirement.actor)]  # fmt: skip
    if again and all(t is not None and t >= first - bounds()["order"]["room"]["value"] for t in again):
        evidence.times[str(requirement.values["second"])] = min(t for t in again if t is not None)
        return in_order(requirement, evidence)
    return result


def _when(requirement: Requirement, evidence: Evidence) -> tuple[Motion | None, float | None]:
    return evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))


def to_side(requirement: Requirement, evidence: Evidence) -> Result:
    motion, time = _when(requirement, evidence)
    said = str(requirement.values["side"])
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    begins = str(requirement.values["of"]).endswith(".swerve")  # the others are seen once they are over
    aside, first = motion.of_course("aside"), motion.at(time - (0.5 if begins else 4.0))
    moved = aside[first : motion.at(time + 3.0) + 1] - aside[first]
    most = float(moved[np.abs(moved).argmax()]) if len(moved) else float("nan")
    if any(s.against for s in motion.course.stays[:1]):  # its own left
        most = -most
    margin = most if said == "left" else -most
    return scored(requirement, margin / 1.0, f"to the {said}", f"{abs(most):.1f} m to the "
                  f"{'left' if most > 0 else 'right'}", time)  # fmt: skip


def in_junction(requirement: Requirement, evidence: Evidence) -> Result:
    motion, time = _when(requirement, evidence)
    if motion is None or time is None:
        return unknown(requirement, "in the junction", "not judged: the action did not occur")
    inside = [s for s in motion.course.stays if s.kind == "junction"]
    if not inside:
        return decided(requirement, False, "in the junction", "in no junction", time)
    seen = {s.to_ego for s in inside if abs(s.time - time) < 5.0 or s.time <= time}
    holds = requirement.actor == EGO or bool(seen & {"own", "crossing", "oncoming", "left", "right"})
    return decided(requirement, holds, "in ego's junction", "in it" if holds else "in another junction", time)


def near_place(requirement: Requirement, evidence: Evidence) -> Result:
    motion, time = _when(requirement, evidence)
    place, within = str(requirement.values["place"]), float(requirement.values["within"])  # type: ignore[arg-type]
    said = f"within {within:g} m of the {place}" if within else f"at the {place}"
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    kind = {"intersection": "junction", "merge_end": "merge"}.get(place, "crosswalk")
    if str(requirement.values.get("action")) in moments.SIDEWAYS:
        time = moments.onset(motion, str(requirement.values["action"]), time)
    at = motion.at(time)
    if kind in ("merge", "crosswalk") and requirement.values.get("action") == "brake":  # where that is over
        slower = motion.acceleration[at:] > -bounds()["phase"]["change_rate"]["value"] / 2
        at += int(slower[5:].argmax()) + 5 if slower[5:].any() else len(slower) - 1
    front = float(motion.of_course("along")[at]) + motion.size[0] / 2
    marks = [m for m in motion.course.marks if m.kind == kind]
    if kind == "merge":
        away = [max(m.end - front, 0.0) for m in marks if m.start < front]
    else:
        away = [max(m.start - front, front - motion.size[0] - m.end, 0.0) for m in marks]
    if not away:
        return decided(requirement, False, said, f"no {place} on its way", time)
    room = bounds()["place"]["room"]["value"]
    return scored(requirement, 1.0 - max(0.0, min(away) - within) / room, said, f"{min(away):.0f} m before it", time)


def at_distance(requirement: Requirement, evidence: Evidence) -> Result:
    motion, time = _when(requirement, evidence)
    v, other = requirement.values, evidence.motion(requirement.other or EGO)
    least, most = span(requirement)
    if motion is None or other is None or time is None:
        return unknown(requirement, f"{most:g} m away", "not judged: the action did not occur")
    time = moments.onset(motion, str(v["action"]), time)
    if v.get("hidden"):  # it is as it comes out that ego is so far away
        time = motion.visible_from(time) or time
    at, there = motion.at(time), other.at(time)
    if v["centres"]:
        gap = float(np.hypot(motion.x[at] - other.x[there], motion.y[at] - other.y[there]))
    else:
        here, others = motion.poses[at : at + 1], other.poses[there : there + 1]
        gap = float(box_distance(here, others, motion.size, other.size)[0])
    room = max(bounds()["place"]["distance"]["value"], bounds()["place"]["distance_share"]["value"] * most)
    how = "centre to centre" if v["centres"] else "bumper to bumper"
    return between(requirement, gap, room, f"{most:g} m away", f"{gap:.1f} m, {how}", time)


def rate(requirement: Requirement, evidence: Evidence) -> Result:
    motion, time = _when(requirement, evidence)
    least, most = span(requirement)
    if motion is None or time is None:
        return unknown(requirement, f"{least:g} m/s2", "not judged: the action did not occur")
    window = -motion.acceleration[motion.at(time - 4.0) : motion.at(time + 6.0) + 1]
    braking = window[window > 0.5 * float(window.max())]
    seen = float(np.median(braking)) if len(braking) else 0.0
    room = bounds()["phase"]["rate"]["value"] * most + 0.5
    return between(requirement, seen, room, f"{least:g} m/s2", f"{seen:.1f} m/s2", time)


def reaches(requirement: Requirement, evidence: Evidence) -> Result:
    """At some moment from when the phase is seen on, its speed is the stated one."""
    motion, time = _when(requirement, evidence)
    least, most = span(requirement)
    if motion is None or time is None:
        return unknown(requirement, kmh(least, most), "not judged: the action did not occur")
    speed = motion.speed[motion.at(time) :]
    off = np.maximum(0.0, np.maximum(least - speed, speed - most))
    room = max(bounds()["speed"]["share"]["value"] * most, bounds()["speed"]["least"]["value"])
    best = int(off.argmin())
    return scored(requirement, 1.0 - float(off[best]) / room, kmh(least, most), f"{speed[best] * 3.6:.0f} km/h", time)


CHECKS = {
    "shown": shown, "in_order": in_order, "awaited": awaited, "to_side": to_side, "in_junction": in_junction,
    "rate": rate, "reaches": reaches, "near_place": near_place, "at_distance": at_distance, **moments.CHECKS,
}  # fmt: skip

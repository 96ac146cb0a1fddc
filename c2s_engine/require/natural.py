"""Everybody moves as its class of road user does, at the speeds that S states, and not so as to make things happen."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import SMOOTH, STANDING, Evidence, Motion, stretches
from c2s_engine.require.geometry import lead
from c2s_engine.require.outcome import SIDEWARD, struck
from c2s_engine.require.results import scored, span, unknown
from c2s_engine.require.scene import Scene, bounds, kmh
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec
from c2s_engine.structure.vocabulary import ON_FOOT, VEHICLES

MOVING = (*ON_FOOT, *VEHICLES)
CHANGES = ("accelerate", "brake", "stop", "wait", "start", "yield", "follow", "overtake", "stationary", "enter_road",
           "cut_in", "merge", "u_turn", "reverse", "cut_out", "leave_road", "lose_control", "cross_road")  # fmt: skip
"""Actions that are, or bring with them, a change of speed."""
GAINS = ("accelerate", "start", "overtake", "enter_road", "cut_in", "cut_out", "wait", "stop", "yield", "u_turn")
"""Actions after or in which speed is gained."""


def required(scene: Scene) -> Iterator[Requirement]:
    hits = struck(scene)
    for actor, spec in scene.actors.items():
        if spec.type not in MOVING or not scene.of_text(actor):
            continue
        name, actions = scene.named(actor), {p.action for p in spec.phases}
        yield scene.make("natural", "dynamics", actor, "dynamics", f"{name} moves within the physical limits of "
                         "its class.", sideways="lose_control" not in actions)  # fmt: skip
        if not scene.recognised(actor):
            continue
        yield from _speeds(scene, actor, spec)
        cid = component_of(actor)
        changes = tuple(f"{cid}.phases.{i}.{p.action}" for i, p in enumerate(spec.phases) if p.action in CHANGES)
        if spec.speed != 0 and not (actor == EGO and scene.ego.reaction != "none"):
            until = " before the first phase that changes it" if changes else ""
            text = f"{name} does not change speed without a reason{until}."
            yield scene.make("natural", "steady", actor, "steady", text, until=changes)
        if actor == EGO and scene.ego.reaction != "none" and scene.recognised(actor):
            slows = sum(p.action in CHANGES for p in spec.phases)
            text = "Ego does not repeatedly speed up and slow down."
            yield scene.make("natural", "smooth", actor, "smooth", text, said=slows)
        if (target := next((t for a, t in hits if a == actor), None)) is not None:
            gains = bool(actions & set(GAINS)) or spec.speed == 0 or spec.type in ON_FOOT  # these set out
            yield scene.make("natural", "no_aiming", actor, "no_aiming", f"{name} neither speeds up into nor steers "
                             f"at {scene.named(target)}.", other=target, gains=gains,
                             steers=bool(actions & {*SIDEWARD, "turn_left", "turn_right", "oncoming"})
                             or (actor == EGO and scene.place.manoeuvre not in (None, "straight")))  # fmt: skip


def _speeds(scene: Scene, actor: str, spec: EgoSpec | ObjectSpec) -> Iterator[Requirement]:
    cid, name = component_of(actor), scene.named(actor)
    stated = spec.speed is not None and scene.stated(cid, "speed")
    held = scene.speed(actor, spec, "speed")
    if held is not None and held[1] > 0:
        least, most = held
        yield scene.make("speed", "speed_kept", actor, "speed", f"{name} goes at {kmh(least, most)}.", least=least,
                         most=most)  # fmt: skip
    elif stated and spec.speed == 0:
        yield scene.make("speed", "stands_first", actor, "speed", f"{name} stands at first.")
    elif spec.type in (*ON_FOOT, "bicycle") and _goes(spec) and not any(p.speed or p.pace for p in spec.phases):
        yield scene.make("speed", "usual_speed", actor, "usual_speed", f"{name} goes at a usual speed for its kind.")


def _goes(spec: EgoSpec | ObjectSpec) -> bool:
    """Whether S says more of somebody than that it stands: who stands throughout has no pace to judge."""
    return any(p.action not in ("stationary", "wait") for p in spec.phases)


def dynamics(requirement: Requirement, evidence: Evidence) -> Result:
    worst: tuple[float, str, str, float | None] | None = None
    for motion in evidence.motions(requirement.actor):
        limits = bounds()["natural"].get(motion.kind)
        if limits is None or not motion.moves:
            continue
        for margin, said, seen, time in _judged(motion, limits, bool(requirement.values["sideways"])):
            if worst is None or margin < worst[0]:
                worst = (margin, said, seen, time)
    if worst is None:
        if evidence.motions(requirement.actor):
            return scored(requirement, 1.0, "within the limits of its class", "it stands")
        return unknown(requirement, "within the limits of its class", "not judged: it is missing from the run")
    return scored(requirement, *worst)


def _judged(motion: Motion, limits: dict, sideways: bool) -> Iterator[tuple[float, str, str, float]]:  # type: ignore[type-arg]
    """(margin, said, seen, time) of each bound of its class."""
    settled = motion.time >= bounds()["natural"]["settles"]["value"]
    gain, lateral = motion.acceleration, motion.lateral
    jerk = np.abs(np.gradient(gain, motion.step)) if len(gain) > 2 else np.zeros(len(gain))
    values = {"acceleration": (gain, "m/s2"), "deceleration": (-gain, "m/s2"), "jerk": (jerk, "m/s3"),
              "speed": (motion.speed, "m/s")}  # fmt: skip
    if sideways:
        values["lateral"] = (lateral, "m/s2")
    for name, (series, unit) in values.items():
        if name not in limits or not settled.any():
            continue
        kept = np.where(settled, series, -np.inf)
        at = int(kept.argmax())
        bound = float(limits[name]["value"])
        margin = (bound - kept[at]) / (0.25 * bound)
        if round(float(kept[at]), 1) <= bound:  # as it is shown
            margin = max(margin, 0.0)
        yield margin, f"{name} up to {bound:g} {unit}", f"{kept[at]:.1f} {unit}", \
            float(motion.time[at])  # fmt: skip


def speed_kept(requirement: Requirement, evidence: Evidence) -> Result:
    least, most = span(requirement)
    said = kmh(least, most)
    limits, seen = bounds()["speed"], []
    for motion in evidence.motions(requirement.actor):
        moving = motion.speed[motion.speed > STANDING]
        if not len(moving):
            return scored(requirement, -1.0, said, "it stands")
        room = max(limits["share"]["value"] * most, limits["least"]["value"])
        off = np.maximum(0.0, np.maximum(least - moving, moving - most))
        width = min(len(off), max(1, round(limits["held"]["value"] / motion.step)))
        windows = np.lib.stride_tricks.sliding_window_view(off, width).max(axis=1)
        best = int(windows.argmin())
        held = moving[best : best + width]
        seen.append((1.0 - float(windows[best]) / room, float(np.median(held)), float(held.min()), float(held.max())))
    if not seen:
        return unknown(requirement, said, "not judged: it is missing from the run")
    margin, typical, slowest, fastest = min(seen)
    steadily = f"at best from {slowest * 3.6:.0f} to {fastest * 3.6:.0f} km/h for {limits['held']['value']:g} s"
    return scored(requirement, margin, said, kmh(typical, typical) if margin >= 0 else steadily)


def stands_first(requirement: Requirement, evidence: Evidence) -> Result:
    found = [float(m.speed[0]) for m in evidence.motions(requirement.actor)]
    if not found:
        return unknown(requirement, "stands", "not judged: it is missing from the run")
    return scored(requirement, (STANDING - max(found)) / STANDING, "stands", f"{max(found) * 3.6:.0f} km/h", 0.0)


def usual_speed(requirement: Requirement, evidence: Evidence) -> Result:
    for motion in evidence.motions(requirement.actor):
        limits = bounds()["speed"]["usual"].get(motion.kind)
        moving = motion.speed[motion.speed > STANDING]
        if limits is None or not len(moving):
            continue
        least, most = limits["value"]
        seen = float(np.median(moving))
        if seen < least and motion.speed[0] <= STANDING:  # it has to set out first
            seen = float(np.percentile(moving, 90))
        return scored(requirement, min(seen - least, most - seen) / (0.25 * (most - least)),
                      f"{least:g} to {most:g} m/s", f"{seen:.1f} m/s")  # fmt: skip
    return unknown(requirement, "a usual speed", "not judged: it does not move")


def steady(requirement: Requirement, evidence: Evidence) -> Result:
    """No change of speed beyond the bound that neither a turn, a light, a sign nor somebody ahead explains.

    Where S says changes of speed, up to the first of them that is seen.
    """
    limit = bounds()["speed"]["unsaid"]["value"]
    said = f"changes of speed under {limit:g} m/s without a reason"
    worst, when = 0.0, None
    motions = evidence.motions(requirement.actor)
    if not motions:
        return unknown(requirement, said, "not judged: it is missing from the run")
    ids = requirement.values["until"]
    assert isinstance(ids, tuple)
    until = min((t for key in ids if (t := evidence.times.get(str(key))) is not None), default=np.inf) - SMOOTH
    for motion in motions:
        if not motion.moves:
            continue
        settled, gain = motion.time >= bounds()["natural"]["settles"]["value"], motion.acceleration
        gone = passed_ego_since(motion, evidence)
        for first, last in [*stretches((gain > 0.3) & settled), *stretches((gain < -0.3) & settled)]:
            if motion.kind in ("pedestrian", "animal") and motion.smooth[max(first - 1, 0)] < STANDING:
                continue  # on foot one sets out at once
            change = abs(float(motion.smooth[last] - motion.smooth[first]))
            told = motion.time[last] < until and motion.time[first] < gone
            if told and change > worst and not explained(motion, evidence, first, last):
                worst, when = change, float(motion.time[first])
    return scored(requirement, (limit - worst) / limit, said, f"{worst:.1f} m/s", when)


def passed_ego_since(motion: Motion, evidence: Evidence) -> float:
    """From when one that came towards ego has left it behind for good, s: what becomes of it then is of no account."""
    ego = evidence.motion(EGO)
    if ego is None or ego is motion:
        return np.inf
    n = min(len(motion.x), len(ego.x))
    facing = np.cos(motion.heading[:n] - ego.heading[:n]) < 0
    behind = facing & (lead(ego.poses[:n], motion.poses[:n]) < -bounds()["reason"]["gone"]["value"])
    if not n or not behind[-1]:
        return np.inf
    here = np.flatnonzero(~behind)
    return float(motion.time[here[-1] + 1 if len(here) else 0])


def smooth(requirement: Requirement, evidence: Evidence) -> Result:
    """How often it slows down again after it had done so and gained speed, with nobody in its way new or slower, more
    often than S says changes of speed."""
    said, motion = "no surging", evidence.motion(requirement.actor)
    if motion is None:
        return unknown(requirement, said, "not judged: it is missing from the run")
    limit = bounds()["speed"]["surge"]["value"]
    turns = _extremes(motion.smooth, motion.at(bounds()["natural"]["settles"]["value"]), limit)
    speed = motion.smooth
    again = [(a, b) for a, b in zip(turns[2:], turns[3:], strict=False) if speed[b] < speed[a]]
    without = [a for a, b in again if not _newly_slowed(motion, evidence, a, b)]
    most = max(1, int(requirement.values["said"]))  # type: ignore[arg-type]
    seen = f"slows down again {len(without)} times" if without else "none"
    return scored(requirement, (most + 0.5 - len(without)) / most, said, seen,
                  float(motion.time[without[-1]]) if without else None)  # fmt: skip


def _extremes(speed: np.ndarray, first: int, least: float) -> list[int]:
    """The steps, from one on, between which the speed rises or falls by so much (m/s) or more, in turn."""
    found, last, trend = [first], first, 0.0
    for k in range(first, len(speed)):
        change = float(speed[k] - speed[last])
        if trend * change > 0 or not trend and abs(change) >= least:
            trend, last = float(np.sign(change)), k
        elif trend and abs(change) >= least:
            found, trend, last = [*found, last], -trend, k
    return [*found, last]


def _newly_slowed(motion: Motion, evidence: Evidence, first: int, last: int) -> bool:
    """Whether something makes it slow down then: a turn, a control ahead, somebody who comes into its way or slows."""
    before = max(first - round(2 / motion.step), 0)
    for other in evidence.everybody:
        at, then = (min(k, len(other.x) - 1) for k in (before, last))
        slower = float(other.smooth[at : then + 1].max() - other.smooth[then]) > bounds()["speed"]["surge"]["value"]
        there = [in_its_way(motion, other, k, bounds()["reason"]["headway"]["value"]) for k in (before, last)]
        if there[1] and (slower or not there[0]):
            return True
    return explained(motion, evidence, first, last, others=False)


def explained(motion: Motion, evidence: Evidence, first: int, last: int, others: bool = True) -> bool:
    """Whether something on the road is a reason to change speed then: a turn, a control ahead, somebody in its way."""
    limits = bounds()["reason"]
    around = slice(max(0, first - round(4 / motion.step)), last + round(6 / motion.step))
    turned = motion.heading[around]
    if len(turned) and float(turned.max() - turned.min()) > limits["turn"]["value"]:
        return True
    front = float(motion.of_course("along")[first])
    for mark in motion.course.marks:
        if mark.kind != "junction" and (mark.control or mark.kind == "crosswalk") \
                and -10.0 < mark.start - front < limits["ahead"]["value"]:  # fmt: skip
            return True
    there = evidence.everybody if others else []
    near = max(limits["headway"]["value"], float(motion.speed[first]) ** 2 / (2 * limits["braking"]["value"]))
    return any(in_its_way(motion, other, first, near) for other in there)


def in_its_way(motion: Motion, other: Motion, step: int, within: float) -> bool:
    """Whether another is in front of it, near to its line, at a step."""
    if other is motion:
        return False
    at = min(step, len(other.x) - 1)
    dx, dy = other.x[at] - motion.x[step], other.y[at] - motion.y[step]
    sin, cos = np.sin(motion.heading[step]), np.cos(motion.heading[step])
    ahead, aside = -sin * dx + cos * dy, cos * dx + sin * dy
    return bool(0 < ahead < within and abs(aside) < 1.0 + 0.5 * (motion.size[1] + other.size[1]))


def no_aiming(requirement: Requirement, evidence: Evidence) -> Result:
    """In the last seconds before the contact it gains no speed and does not leave its line, where S has no reason."""
    limits = bounds()["aiming"]
    said = f"gains under {limits['gain']['value']:g} m/s, steers under {limits['aside']['value']:g} m aside"
    found = evidence.contacts(requirement.actor, requirement.other or EGO)
    motion = evidence.motion(requirement.actor)
    if not found or motion is None:
        return unknown(requirement, said, "not judged: the two did not collide")
    window = slice(motion.at(found[0].time - limits["before"]["value"]), None)
    speed, aside = motion.smooth[window], motion.of_course("aside")[window]
    gained = float((speed - np.minimum.accumulate(speed)).max()) if not requirement.values["gains"] else 0.0
    steered = 0.0
    if not requirement.values["steers"] and np.isfinite(aside).all() and motion.kind not in ("pedestrian", "animal"):
        steered = float(aside.max() - aside.min())
    margin = min((limits["gain"]["value"] - gained) / limits["gain"]["value"],
                 (limits["aside"]["value"] - steered) / limits["aside"]["value"])  # fmt: skip
    return scored(requirement, margin, said, f"gains {gained:.1f} m/s, {steered:.1f} m aside", found[0].time)


CHECKS = {"dynamics": dynamics, "speed_kept": speed_kept, "stands_first": stands_first, "usual_speed": usual_speed,
          "steady": steady, "smooth": smooth, "no_aiming": no_aiming}  # fmt: skip

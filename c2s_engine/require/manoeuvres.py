"""How what leads out of the lane ends: back in it with the stated gap, broken off, in a slide; emergency braking."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence
from c2s_engine.require.geometry import box_distance, lead
from c2s_engine.require.results import between, scored, span, unknown, words
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import Phase

COMES_BACK = ("overtake", "swerve")
ELSEWHERE = ("collide", "lane_change", "cut_in", "cut_out", "leave_road", "turn_left", "turn_right", "u_turn", "drift",
             "swerve", "oncoming", "overtake", "lose_control", "abandoned")  # fmt: skip
"""After these, or into these, one is not back in its lane at the end."""


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, i, phase in scene.phases():
        path, name = f"phases.{i}", scene.named(actor)
        cid = component_of(actor)
        of = f"{cid}.{path}.{phase.action}"
        left = _left(scene, actor, i)
        later = {p.action for p in scene.actors[actor].phases[i + 1 :]}
        if phase.action == "overtake" and phase.abandoned:
            yield scene.make("phase", "overtaking_broken_off", actor, f"{path}.abandoned",
                             f"{name}: pulls out to overtake and "
                             "drops back behind.", other=_overtaken_actor(scene, actor, phase))  # fmt: skip
        elif phase.action in COMES_BACK and not (later | left) & set(ELSEWHERE) and _in_lane(scene, actor, phase):
            yield scene.make("phase", "comes_back", actor, f"{path}.back", f"{name}: {phase.action} ends in its own "
                             "lane.", of=of)  # fmt: skip
        if phase.action == "overtake" and phase.gap is not None and not phase.abandoned:
            yield scene.make("phase", "comes_back_at", actor, f"{path}.gap", f"{name}: comes back with "
                             f"{low(phase.gap):g} m to {scene.named(_overtaken_actor(scene, actor, phase))}.",
                             other=_overtaken_actor(scene, actor, phase), of=of, least=low(phase.gap),
                             most=high(phase.gap))  # fmt: skip
        trigger = phase.trigger
        passes = trigger is not None and trigger.kind == "action" and trigger.action == "overtake" and trigger.of
        if trigger is not None and passes and scene.overtakes(trigger.of, actor):
            yield scene.make("order", "alongside", actor, f"{path}.awaits", f"{name}: {phase.action.replace('_', ' ')} "
                             f"while {scene.named(trigger.of)} overtakes it.", other=trigger.of, of=of)  # fmt: skip
        if phase.action == "lose_control" and later & {"stop", "stationary", "wait"}:
            yield scene.make("phase", "slides_to_a_stand", actor, f"{path}.ends", f"{name}: slides to a stand, at an "
                             "angle to its lane.", of=of)  # fmt: skip
    if scene.ego.reaction == "brake" and scene.ego.hard:
        yield scene.make("reaction", "emergency", EGO, "hard", "Ego performs emergency braking.")


def _left(scene: Scene, actor: str, i: int) -> set[str]:
    """What it did before its i-th phase, but for a change of lane by which it pulls out."""
    before: set[str] = {p.action for p in scene.actors[actor].phases[:i]}
    return before - {"overtake", "swerve"}


def _overtaken_actor(scene: Scene, actor: str, phase: Phase) -> str:
    return phase.target or (EGO if actor != EGO else next(iter(scene.objects), EGO))


def _in_lane(scene: Scene, actor: str, phase: Phase) -> bool:
    """Whether somebody leaves its own lane for it: who passes in the next one stays there."""
    if phase.action == "swerve" or scene.place.kind in ("intersection", "roundabout", "on_ramp", "off_ramp"):
        return phase.action == "swerve"
    whom = scene.objects.get(_overtaken_actor(scene, actor, phase))
    own = scene.objects.get(actor)
    both = [o for o in (own, whom) if o is not None]
    if not both:
        return False
    clears = whom is not None and any(p.action in ELSEWHERE[1:] for p in whom.phases)
    last = both[0] if len(both) == 1 else max(both, key=lambda o: list(scene.objects.values()).index(o))
    return last.placement.position in ("ahead", "behind") and last.placement.facing != "against" and not clears


def comes_back(requirement: Requirement, evidence: Evidence) -> Result:
    """After the moment of the phase its middle is near that of the lane in which it started."""
    said = "back in its lane"
    motion, time = evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))
    evidence.times[requirement.id] = None
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    aside = np.abs(motion.of_course("aside"))
    room = bounds()["phase"]["back"]["value"]
    first = motion.at(time)
    first += int(np.nan_to_num(aside[first:]).argmax())  # from where it is furthest out
    least = int(aside[first:].argmin()) + first
    near = np.flatnonzero(aside[first:] <= room)
    if not len(near) and motion.contact is not None:
        return unknown(requirement, said, "not judged: a contact ended its way")
    if len(near):
        evidence.times[requirement.id] = float(motion.time[first + near[0]])
    return scored(requirement, (room - float(aside[least])) / room, said, f"{aside[least]:.1f} m beside its middle",
                  evidence.times[requirement.id])  # fmt: skip


def comes_back_at(requirement: Requirement, evidence: Evidence) -> Result:
    """The gap at the moment at which it comes over the line into its lane."""
    said = words(requirement, "m")
    motion, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    time = evidence.times.get(str(requirement.values["of"]))
    if motion is None or other is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    aside, n = np.abs(motion.of_course("aside")), min(len(motion.x), len(other.x))
    first = motion.at(time)
    over = np.flatnonzero(aside[first:n] < bounds()["start"]["half_lane"]["value"])
    if not len(over) or aside[first:n].max(initial=0.0) < 0.5:
        return unknown(requirement, said, "not judged: it does not come back")
    at = first + int(over[0])
    gap = float(box_distance(motion.poses[at : at + 1], other.poses[at : at + 1], motion.size, other.size)[0])
    room = max(bounds()["start"]["gap"]["value"], bounds()["start"]["gap_share"]["value"] * span(requirement)[1])
    return between(requirement, gap, room, said, f"{gap:.1f} m", float(motion.time[at]))


def overtaking_broken_off(requirement: Requirement, evidence: Evidence) -> Result:
    """Out of its lane's middle behind or beside the other, never ahead of it, and back."""
    said = "out, and back behind"
    motion, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    evidence.times[requirement.id] = None
    if motion is None or other is None:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    aside, n = np.abs(motion.of_course("aside")), min(len(motion.x), len(other.x))
    limits = bounds()["phase"]
    ahead = -lead(motion.poses[:n], other.poses[:n])
    out, peak = limits["out"]["value"], int(aside.argmax())
    back = np.flatnonzero(aside[peak:] < limits["back"]["value"])
    if len(back) and aside[peak] > out:
        evidence.times[requirement.id] = float(motion.time[int((aside > out).argmax())])
    margin = min((float(aside[peak]) - out) / out, -float(ahead.max()) / 5.0, 1.0 if len(back) else -1.0)
    seen = f"{aside[peak]:.1f} m out, {'ahead of it' if ahead.max() > 0 else 'behind it'}, " \
        f"{'back' if len(back) else 'not back'}"  # fmt: skip
    return scored(requirement, margin, said, seen, evidence.times[requirement.id])


def alongside(requirement: Requirement, evidence: Evidence) -> Result:
    """The two are side by side, or the one is about to be, when the other acts."""
    motion, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    time = evidence.times.get(str(requirement.values["of"]))
    if motion is None or other is None or time is None:
        return unknown(requirement, "side by side", "not judged: the action did not occur")
    at = min(motion.at(time), len(other.x) - 1)
    ahead = float(lead(motion.poses[at], other.poses[at]))
    room = (motion.size[0] + other.size[0]) / 2 + bounds()["start"]["abreast"]["value"]
    return scored(requirement, (room - abs(ahead)) / room, f"within {room:.0f} m lengthwise", f"{abs(ahead):.1f} m",
                  time, measured=(ahead, -room, room))  # fmt: skip


def slides_to_a_stand(requirement: Requirement, evidence: Evidence) -> Result:
    said = "stands at an angle"
    motion, time = evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))
    if motion is None or time is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    turned = float(abs(motion.heading[-1] - motion.heading[motion.at(max(time - 1.0, 0.0))]))
    least = bounds()["phase"]["turn_begun"]["value"]
    margin = min((turned - least) / least, 1.0 if motion.speed[-1] < STANDING or motion.contact is not None else -1.0)
    return scored(requirement, margin, said, f"{motion.speed[-1] * 3.6:.0f} km/h, turned by {np.degrees(turned):.0f}°")


def emergency(requirement: Requirement, evidence: Evidence) -> Result:
    """The hardest braking of ego; the one that the grip of a wet or snowy road leaves counts."""
    limits = bounds()["reaction"]["emergency"]["value"]
    said = f"at least {limits:g} m/s2"
    motion = evidence.motion(EGO)
    if motion is None:
        return unknown(requirement, said, "not judged: ego is not there")
    hardest = float((-motion.acceleration).max())
    return scored(requirement, (hardest - limits) / limits, said, f"{hardest:.1f} m/s2",
                  float(motion.time[int(motion.acceleration.argmin())]), measured=(hardest, limits, 9.8))  # fmt: skip


CHECKS = {"comes_back": comes_back, "comes_back_at": comes_back_at, "alongside": alongside,
          "overtaking_broken_off": overtaking_broken_off,
          "slides_to_a_stand": slides_to_a_stand, "emergency": emergency}  # fmt: skip

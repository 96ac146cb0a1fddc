"""Others than ego brake, or stop, for whom S names, as that one is, or comes, in their way: not before or after."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require import moments
from c2s_engine.require.conflict import APPROACHES
from c2s_engine.require.due import arrival
from c2s_engine.require.evidence import STANDING, Evidence, Motion
from c2s_engine.require.geometry import box_distance
from c2s_engine.require.results import scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.objects import slows_for
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec

BEND, STEP = 10.0, 0.5
"""m at the end of a way that tell how it bends, and from one point of what lies beyond to the next."""
FELT = 0.4
"""s over which the other's change of speed is seen."""


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, i, phase in scene.phases():
        spec, other = scene.actors[actor], scene.actors.get(phase.target or "")
        own = phase.trigger is not None and scene.stated(component_of(actor), f"phases.{i}.trigger")
        if not isinstance(spec, ObjectSpec) or own or not slows_for(actor, spec, phase, other):
            continue
        if spec.placement.position in APPROACHES:  # it may stop at its line
            continue
        said = f"{scene.named(actor)}: {phase.action} for {scene.named(phase.target)}, which is, or comes, in its way."
        yield scene.make("order", "has_cause", actor, f"phases.{i}.cause", said, other=phase.target,
                         of=f"{component_of(actor)}.phases.{i}.{phase.action}", action=phase.action)  # fmt: skip


def has_cause(requirement: Requirement, evidence: Evidence) -> Result:
    said, limits = "the other is in its way, if both go on as they do", bounds()["cause"]
    one, seen = evidence.motion(requirement.actor), evidence.times.get(str(requirement.values["of"]))
    others = evidence.motions(requirement.other or EGO)
    if one is None or seen is None or not others:
        return unknown(requirement, said, "not judged: the action did not occur")
    begun = moments.onset(one, str(requirement.values["action"]), seen)
    nearest, other = min(((_comes_near(one, other, begun), other) for other in others), key=lambda found: found[0])
    room, after = limits["near" if _speed(other, begun) > STANDING else "beside"]["value"], arrival(one, other)
    words = f"{nearest:.1f} m apart then, begun at {begun:.1f} s"
    return scored(requirement, (room - nearest) / room, said, words, begun, due=None if after is None else -after)


def _speed(motion: Motion, time: float) -> float:
    """How fast one is at a time, m/s; who sets out then, as fast as it is at once."""
    speed = float(motion.speed[motion.at(time)])
    return speed if speed > STANDING else float(motion.speed[motion.at(time + FELT)])


def _comes_near(one: Motion, other: Motion, time: float) -> float:
    """m between the two at the least, within the horizon, if one keeps its speed from a time (s) on and the other
    changes its own as it does then; both on the ways that they take."""
    ahead = np.arange(0.0, bounds()["cause"]["horizon"]["value"], 0.1)
    k, j, before = one.at(time), other.at(time), other.at(time - FELT)
    rate = (other.speed[j] - other.speed[before]) / max(other.time[j] - other.time[before], other.step)
    held = np.cumsum(np.maximum(_speed(other, time) + min(rate, 0.0) * ahead, 0.0)) * 0.1
    own, apart = _along(one, k, one.speed[k] * ahead), bounds()["cause"]["headway"]["value"] * float(one.speed[k])
    own[:, 0] -= np.sin(own[:, 2]) * apart / 2  # with the room that one keeps ahead
    own[:, 1] += np.cos(own[:, 2]) * apart / 2
    return float(box_distance(own, _along(other, j, held), (one.size[0] + apart, one.size[1]), other.size).min())


def _along(motion: Motion, first: int, gone: np.ndarray) -> np.ndarray:
    """Poses so many metres on from a step along the way that is taken, on in the same bend beyond its end."""
    way = motion.beyond_contact.poses[first:]
    metres = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(way[:, :2], axis=0).T))])
    bend = way[metres >= metres[-1] - BEND, 2]
    bent = (bend[-1] - bend[0]) / BEND
    more = np.arange(STEP, max(gone.max() - metres[-1], 0.0) + STEP, STEP)
    heading = way[-1, 2] + bent * more
    x, y = way[-1, 0] - np.cumsum(np.sin(heading)) * STEP, way[-1, 1] + np.cumsum(np.cos(heading)) * STEP
    whole, along = np.concatenate([way, np.column_stack([x, y, heading])]), np.concatenate([metres, metres[-1] + more])
    return np.column_stack([np.interp(gone, along, whole[:, c]) for c in range(3)])


CHECKS = {"has_cause": has_cause}

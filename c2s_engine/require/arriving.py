"""Who comes when: to where its way meets ego's, into ego's way, or beside another, as S says of them (`arrives`)."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.due import arrival
from c2s_engine.require.evidence import Evidence, Motion
from c2s_engine.require.geometry import HORIZON, lead
from c2s_engine.require.outcome import struck as struck_pairs
from c2s_engine.require.results import between, scored, span, unknown, words
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.require.starts import OFF_LANES
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import high, low
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec
from c2s_engine.structure.vocabulary import FOUR_WHEELED

BESIDE = (*OFF_LANES, "intersection_exit")
"""Who comes from there comes into ego's way, and by no way that meets it."""
IN_MIDDLE = 0.15
"""m from the middle of ego's way within which one is there."""


def required(scene: Scene) -> Iterator[Requirement]:
    """Of whom S says when: not of two that are said to touch, for then they do come together."""
    struck = {frozenset(pair) for pair in struck_pairs(scene)}
    for actor, spec in scene.objects.items():
        said = spec.placement.arrives is not None and scene.stated(actor, "placement.arrives")
        if said and scene.recognised(EGO) and frozenset((actor, EGO)) not in struck:
            yield from _arriving(scene, actor, spec)


def _arriving(scene: Scene, actor: str, spec: ObjectSpec) -> Iterator[Requirement]:
    place, name = spec.placement, scene.named(actor)
    assert place.arrives is not None
    least, most = low(place.arrives), high(place.arrives)
    after = f"{abs(least):g} s {'after' if least >= 0 else 'before'} ego"
    when = after if least or most else "together with ego"
    values = {"other": EGO, "least": least, "most": most}
    if place.position == "on_ramp" and any(p.trigger and p.trigger.of == EGO for p in spec.phases):
        return  # it comes onto ego's way only as ego makes room
    if place.position in BESIDE:
        if any(p.action == "cross_road" and p.abandoned for p in spec.phases):
            return  # it stays beside ego's way
        where = "ego's way" if spec.type in FOUR_WHEELED else "the middle of ego's way"
        check, text = "arrives", f"{name} is in {where} {after}'s front, if neither reacts."
        del values["other"]
    elif beside := _level_with(scene, spec):
        check, text = "arrives_beside", f"{name} is level with {scene.named(beside)} {when}, if neither reacts."
        values["other"] = beside
    else:
        check, text = "arrives_where_ways_meet", f"{name} is at their conflict point {when}, if neither reacts."
    yield scene.make("conflict", check, actor, "placement.arrives", text, **values)  # type: ignore[arg-type]


def _level_with(scene: Scene, spec: ObjectSpec) -> str | None:
    """By whom one who comes towards ego is to be as ego is, where their own ways do not meet: by whom it is placed, or
    to whom ego reacts."""
    if spec.placement.position != "oncoming_lane":
        return None
    if spec.placement.of != EGO:
        return spec.placement.of
    threat = scene.objects.get(scene.ego.react_to or "")
    apart = scene.place.kind in ("road", "straight", "curve", "crosswalk") and threat is not spec
    return scene.ego.react_to if apart and threat is not None and not spec.phases[1:] else None


def arrives(requirement: Requirement, evidence: Evidence) -> Result:
    """Measured where ego does not react, on the ways and speeds up to their first contact."""
    room, said = bounds()["conflict"]["arrives"]["value"], f"{words(requirement, 's')} after ego"
    run = evidence.without or evidence
    one, ego = run.motion(requirement.actor), run.motion(EGO)
    if one is None or ego is None or not one.course.ego_aside:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    aside, along = one.of_course("ego_aside"), one.of_course("ego_along")
    within, reaches = IN_MIDDLE, 0.0
    if one.kind in FOUR_WHEELED:  # as soon as its body is in ego's way
        turn = one.heading[:1] - ego.heading[0]
        within = float(ego.size[1] + np.abs(np.sin(turn[0])) * one.size[0] + np.abs(np.cos(turn[0])) * one.size[1]) / 2
        reaches = 0.5 * float(np.abs(np.cos(turn[0])) * one.size[0])
    time = _moment(one.time, np.sign(aside[0]) * np.abs(aside) - np.sign(aside[0]) * within)
    if time is None:
        return scored(requirement, -1.0, said, "it does not reach the middle of ego's path")
    front = ego.of_course("along") + ego.size[0] / 2 - float(np.interp(time, one.time, along)) - reaches
    there = _moment(ego.time, front)
    if there is None:
        return scored(requirement, -1.0, said, "ego does not come there")
    return _within(requirement, time - there, room, said, time)


def _moment(time: np.ndarray, values: np.ndarray) -> float | None:
    """When values pass 0; had they gone on as they did at last, where a contact ended them. None: never."""
    reached = np.flatnonzero(np.sign(values) != np.sign(values[0]))
    if len(reached):
        k = int(reached[0])
        step = values[k] - values[k - 1] if k else 0.0
        return float(time[k] - (values[k] / step * (time[k] - time[k - 1]) if abs(step) > 1e-6 else 0.0))
    rate = (values[-1] - values[-3]) / (time[-1] - time[-3]) if len(values) > 2 else 0.0
    ahead = -values[-1] / rate if abs(rate) > 0.1 else -1.0
    return float(time[-1] + ahead) if 0 <= ahead < HORIZON else None


def arrives_beside(requirement: Requirement, evidence: Evidence) -> Result:
    """Measured where ego does not react: by how much later than ego's front one's front is at another."""
    said, run = f"{words(requirement, 's')} after ego", evidence.without or evidence
    one, other, ego = (run.motion(who) for who in (requirement.actor, requirement.other or EGO, EGO))
    if one is None or other is None or ego is None:
        return unknown(requirement, said, "not judged: one of them is not there")
    there, its = _reaches(ego, other), _reaches(one, other)
    if there is None or its is None:
        return scored(requirement, -1.0, said, f"{'ego' if there is None else 'it'} does not come there")
    return _within(requirement, its - there, bounds()["conflict"]["together"]["value"], said, its)


def _reaches(one: Motion, other: Motion) -> float | None:
    """When one's front is at another's nearer end, s; as it drove at last, where a contact ended that."""
    n = min(len(one.x), len(other.x))
    return _moment(one.time[:n], lead(one.poses[:n], other.poses[:n]) - (one.size[0] + other.size[0]) / 2)


def _within(requirement: Requirement, seen: float, room: float, said: str, time: float | None = None) -> Result:
    """Whether one comes as much later (s) as S says, and by how much it would have to be later still."""
    least, most = span(requirement)
    due = round(least - seen if seen < least else most - seen, 2)
    return between(requirement, seen, room, said, f"{seen:.1f} s", time, due=due)


def arrives_where_ways_meet(requirement: Requirement, evidence: Evidence) -> Result:
    """Measured where ego does not react, by when each first is where the other's body will be or has been."""
    said, run = f"{words(requirement, 's')} after ego", evidence.without or evidence
    one, ego = run.motion(requirement.actor), run.motion(EGO)
    seen = arrival(one, ego) if one and ego else None
    if seen is None:
        return scored(requirement, -1.0, said, "their paths do not cross")
    return _within(requirement, seen, bounds()["conflict"]["together"]["value"], said)


CHECKS = {"arrives": arrives, "arrives_beside": arrives_beside, "arrives_where_ways_meet": arrives_where_ways_meet}

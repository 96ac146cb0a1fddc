"""Who crosses ego's road walks on the crosswalk where there is one, and ego stands close before their way."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence, Motion, stretches
from c2s_engine.require.natural import in_its_way
from c2s_engine.require.outcome import struck
from c2s_engine.require.results import decided, scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec

ON_FOOT = ("pedestrian", "child", "animal")
ANSWERS = ("stop", "yield", "wait")


def crosses(spec: ObjectSpec) -> bool:
    """Whether somebody on foot or riding comes over the road from beside it."""
    beside = spec.placement.position in ("roadside", "sidewalk", "parked")
    over = any(p.action == "cross_road" and not p.abandoned for p in spec.phases)
    return beside and over and spec.type in (*ON_FOOT, "bicycle")


def required(scene: Scene) -> Iterator[Requirement]:
    across = [a for a, spec in scene.objects.items() if crosses(spec) and scene.recognised(a)]
    hits = {a for pair in struck(scene) for a in pair}
    met = tuple(a for a in across if a not in hits and _answered(scene, a))
    if met and scene.recognised(EGO):
        names = " and ".join(scene.named(a) for a in met)
        yield scene.make("place", "stands_before", EGO, "stands_before", f"Where ego stops for {names}, "
                         "it stops just before the crosswalk or their path.", others=met)  # fmt: skip
    for actor in across:
        if (before := _after(scene, actor)) is not None:
            text = f"{scene.named(actor)} comes into ego's lane after {scene.named(before)}."
            yield scene.make("order", "comes_after", actor, "comes_after", text, other=before)
    for actor in across if scene.place.crosswalk or scene.place.kind == "crosswalk" else ():
        placement, name = scene.objects[actor].placement, scene.named(actor)
        if placement.gap is None and scene.objects[actor].type in ("pedestrian", "child"):
            yield scene.make("place", "on_crosswalk", actor, "on_crosswalk", f"{name} crosses on the crosswalk.")


def _after(scene: Scene, actor: str) -> str | None:
    """The one that somebody crosses after, as is said; None: nobody is."""
    first = next((p.trigger for p in scene.objects[actor].phases if p.action == "cross_road"), None)
    of = first.of if first is not None and first.kind == "action" and first.action == "cross_road" else None
    spec = scene.objects.get(of or "")
    return of if spec is not None and crosses(spec) and of != actor else None


def _answered(scene: Scene, actor: str) -> bool:
    """Whether ego is said to stop for somebody, or to brake for or yield to them, nobody says how near."""
    phases = [p for p in scene.ego.phases if p.action in ANSWERS]
    named = [p for p in phases if actor in (p.target, p.trigger and p.trigger.of)]
    reacts = scene.ego.reaction in ("brake", "yield") and scene.ego.react_to in (None, actor)
    return (bool(named) or reacts) and all(p.clearance is None for p in phases)


def way_across(motion: Motion) -> tuple[float, float]:
    """Where along ego's way (m) somebody crosses it, or is nearest to it, and when (s)."""
    at = int(np.abs(motion.of_course("ego_aside")).argmin())
    return float(motion.of_course("ego_along")[at]), float(motion.time[at])


def stands_before(requirement: Requirement, evidence: Evidence) -> Result:
    limits, ego = bounds()["crossing"], evidence.motion(EGO)
    least, most = limits["least"]["value"], limits["most"]["value"]
    said = f"{least:g} to {most:g} m before it"
    others = requirement.values["others"]
    assert isinstance(others, tuple)
    walking = [m for o in others for m in evidence.motions(str(o)) if m.course.ego_along and m.moves]
    if ego is None or not walking:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    front = ego.of_course("along") + ego.size[0] / 2
    for first, last in stretches((ego.speed < STANDING) & (ego.time > 0.5)):
        if (last - first) * ego.step < limits["stands"]["value"] or _queues(ego, evidence, first, walking):
            continue
        time = float(ego.time[first])
        due = [m for m in walking if _due(m, time, limits)]
        due = [m for m in due if way_across(m)[1] > time] or sorted(due, key=lambda m: way_across(m)[1])[-1:]
        away = [a for m in due if (a := _away(ego, m, float(front[first]))) > -ego.size[0]]
        if away:
            seen = min(away)
            margin = min((most - seen) / (most - least) * 2, (seen - least) / 0.5)
            return scored(requirement, margin, said, f"{seen:.1f} m before it", time,
                          measured=(seen, least, most))  # fmt: skip
    return scored(requirement, 1.0, said, "ego does not stop for them")


def _due(motion: Motion, time: float, limits: dict) -> bool:  # type: ignore[type-arg]
    """Whether somebody is on their way over ego's lane as ego comes to a stand, or about to be."""
    out = motion.time[np.flatnonzero(motion.speed > STANDING)]
    within = limits["about"]["value"]
    return bool(len(out)) and out[0] - within <= time <= way_across(motion)[1] + within


def _away(ego: Motion, motion: Motion, front: float) -> float:
    """m from ego's front to the way of somebody who crosses, or to the crosswalk or stop line on which, or before
    which, that is."""
    there = way_across(motion)[0]
    room = bounds()["crossing"]["beside"]["value"]
    walks = [m for m in ego.course.marks if m.kind == "crosswalk" and m.start - room <= there <= m.end + room]
    lines = [m.start for m in ego.course.marks if m.kind == "line" and m.control and front - 2.0 < m.start < there]
    return min([there - motion.size[1] / 2, *(m.start for m in walks), *lines]) - front


def _queues(ego: Motion, evidence: Evidence, step: int, walking: list[Motion]) -> bool:
    others = [m for m in evidence.everybody if m not in walking and m.kind not in ("pedestrian", "animal", "obstacle")]
    return any(in_its_way(ego, m, step, bounds()["rules"]["queue"]["value"]) for m in others)


def on_crosswalk(requirement: Requirement, evidence: Evidence) -> Result:
    ego, walking = evidence.motion(EGO), evidence.motions(requirement.actor)
    said, room = "on the crosswalk", bounds()["crossing"]["beside"]["value"]
    if ego is None or not walking or any(not m.course.ego_along for m in walking):
        return unknown(requirement, said, "not judged: it is missing from the run")
    walks = [m for m in ego.course.marks if m.kind == "crosswalk"]
    if not walks:
        return decided(requirement, False, said, "there is none on ego's way")
    off = [min(max(w.start - there, there - w.end, 0.0) for w in walks) for there, _ in map(way_across, walking)]
    return scored(requirement, 1.0 - max(off) / room, said, f"{max(off):.1f} m beside it" if max(off) else said)


def comes_after(requirement: Requirement, evidence: Evidence) -> Result:
    """Of two who cross one after the other: the later one is in ego's lane later, too."""
    said, half = "later", bounds()["start"]["half_lane"]["value"]
    pair = evidence.motions(requirement.actor), evidence.motions(requirement.other or "")
    found = [[t for m in each if len(t := m.time[np.abs(m.of_course("ego_aside")) < half])] for each in pair]
    if not all(found):
        return unknown(requirement, said, "not judged: one of the two never enters ego's lane")
    late, early = (min(float(t[0]) for t in each) for each in found)
    room = bounds()["order"]["room"]["value"]
    return scored(requirement, (late - early) / room, said, f"at {late:.1f} s, the other at {early:.1f} s", late,
                  due=max(early + room - late, 0.0))  # fmt: skip


CHECKS = {"comes_after": comes_after, "stands_before": stands_before, "on_crosswalk": on_crosswalk}

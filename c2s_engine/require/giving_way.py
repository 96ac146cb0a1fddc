"""Who gives way at a junction waits for one that it would meet: not long before that one comes, nor after it has gone.

Whoever stands at a line with a gap longer than drivers take would go: so near the other must be as one could set out.
"""

from collections.abc import Iterator

from c2s_engine.require.due import meeting_steps
from c2s_engine.require.evidence import STANDING, Evidence, Motion, stretches
from c2s_engine.require.phases import CREEPS
from c2s_engine.require.results import decided, scored, unknown
from c2s_engine.require.scene import STOPS, Scene, bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.quantity import middle
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import ObjectSpec

COMES_BY = ("crossing_left", "crossing_right", "opposite_approach", "circulating")
"""Positions of those whose ways meet ego's at a junction."""
AIM = 3.0
"""s within which another comes that plainly is waited for."""


def required(scene: Scene) -> Iterator[Requirement]:
    if scene.place.kind not in ("intersection", "roundabout"):
        return
    for actor, other in dict.fromkeys(_pairs(scene)):
        one, spec = scene.actors[actor], scene.objects[other if actor == EGO else actor]
        leaves = scene.place.kind == "roundabout" and any(p.action == "turn_right" for p in spec.phases)
        known = scene.recognised(actor) and scene.recognised(other)
        if spec.placement.position not in COMES_BY or leaves or not known:
            continue
        stands = sum(middle(p.duration) for p in one.phases if p.action in STOPS and p.duration is not None)
        text = f"{scene.named(actor)} gives way to {scene.named(other)}, which is close when it could have gone."
        yield scene.make("conflict", "waits_for_it", actor, f"gives_way.{other}", text, other=other, stands=stands)


def _pairs(scene: Scene) -> Iterator[tuple[str, str]]:
    """(who gives way, to whom) at the junction, as S says."""
    for actor, _, phase in scene.phases():
        target = phase.target or (EGO if actor != EGO else scene.ego.react_to)
        if phase.action == "yield" and target in scene.actors and EGO in (actor, target):
            yield actor, target
        if phase.action in STOPS and phase.until is not None and phase.until.kind == "passed" and actor == EGO \
                and phase.until.subject in scene.objects:  # fmt: skip
            yield actor, phase.until.subject
    by_road = [a for a, o in scene.objects.items() if isinstance(o, ObjectSpec) and o.placement.position in COMES_BY]
    whom = scene.ego.react_to or (by_road[0] if len(by_road) == 1 else None)
    if scene.ego.reaction == "yield" and whom in scene.objects:
        yield EGO, whom


def waits_for_it(requirement: Requirement, evidence: Evidence) -> Result:
    most = bounds()["giving_way"]["gap"]["value"]
    said = f"the other arrives within {most:g} s"
    one, other = evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    if one is None or other is None:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    own, its = meeting_steps(one, other)
    if not len(own):
        return scored(requirement, 1.0, said, "their paths do not cross where it waits") if one.speed[-1] < STANDING \
            else decided(requirement, False, said, "their paths do not cross")  # fmt: skip
    goes, comes, gone = own.min(), its.min() * one.step, its.max() * one.step
    still = [a for a, b in stretches(one.speed[: goes + 1] < CREEPS) if (one.speed[a : b + 1] < STANDING).any()]
    if not still:
        return scored(requirement, 1.0, said, "it does not stand")
    free = _free(still[-1] * one.step + float(requirement.values["stands"]), comes, one, requirement, evidence)  # type: ignore[arg-type]
    if gone < free:
        seen = f"the other has passed {free - gone:.1f} s before"
        return decided(requirement, False, said, seen, free, due=gone - free - 1.0)
    lag = max(comes - free, 0.0)
    seen = f"the other arrives {lag:.1f} s after it could go"
    return scored(requirement, 1.0 - lag / most, said, seen, free, due=round(lag - AIM, 2))


def _free(since: float, until: float, one: Motion, requirement: Requirement, evidence: Evidence) -> float:
    """When nothing else keeps one any more that stands since then: no others that cross its way before that one, and no
    light."""
    free = since
    for motion in evidence.everybody:
        if motion.name == one.name or motion in evidence.motions(requirement.other or EGO) or not motion.moves:
            continue
        its = meeting_steps(one, motion)[1]
        if len(its) and since < its.max() * one.step < until:
            free = max(free, float(its.max()) * one.step)
    lines = {m.name for m in one.course.marks if m.kind == "line" and m.control == "signal"}
    turns = [t for t, name, shown in evidence.trajectories.lights if name in lines and shown == "green" and t < until]
    return max([free, *(t for t in turns if t > since)])


CHECKS = {"waits_for_it": waits_for_it}

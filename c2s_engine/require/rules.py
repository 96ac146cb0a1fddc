"""Lights, signs and lanes are kept unless S says otherwise; who waits stands where one waits, and for a reason."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence, Motion, stretches
from c2s_engine.require.natural import in_its_way, passed_ego_since
from c2s_engine.require.results import decided, scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.vocabulary import VEHICLES

STANDS = ("stationary", "stop", "wait", "yield", "start", "reverse", "enter_road", "brake", "leave_road")
ACROSS = ("cross_road",)
"""Who goes across the road is on no side of it."""
WRONG_WAY = ("oncoming", "overtake", "reverse", "u_turn", "lose_control", "drift", "swerve", "leave_road", "collide")


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, spec in scene.actors.items():
        if spec.type not in VEHICLES or not scene.recognised(actor):
            continue
        name, actions = scene.named(actor), {p.action for p in spec.phases}
        if not _may_pass_red(scene, actor):
            yield scene.make("rules", "unseen", actor, "obeys_light", f"{name} does not enter on red.", event="run_red")
        if "run_stop" not in actions:
            yield scene.make(
                "rules", "unseen", actor, "obeys_sign", f"{name} stops at its stop sign.", event="run_stop"
            )
        placed = getattr(spec, "placement", None)
        across = bool(placed and placed.side == "left" and "enter_road" in actions)  # over the other side onto its own
        evades = actor == EGO and scene.ego.reaction == "evade"  # by the other side, where its own is blocked
        against = across or evades or bool(placed and placed.facing == "against")
        if not actions & {*WRONG_WAY, *ACROSS} and not against:
            yield scene.make("rules", "own_side", actor, "own_side", f"{name} keeps to its own side of the road.")
        stands = actor != EGO and actions <= {"stationary"} and (actions or spec.speed == 0)  # it waits for nothing
        if spec.type != "bicycle" and not stands:
            yield scene.make("rules", "at_line", actor, "at_line", f"{name}: if it waits at a light or sign, it stands "
                             "at its line.")  # fmt: skip
        reacting = actor == EGO and scene.ego.reaction != "none"
        if not actions & set(STANDS) and spec.speed != 0 and not reacting:
            yield scene.make("rules", "stands_for", actor, "stands_for", f"{name} does not stop in a lane without a "
                             "reason.")  # fmt: skip


def _may_pass_red(scene: Scene, actor: str) -> bool:
    """Whether S lets somebody pass a red light: itself, behind one that does, or ego as it turns right after a stop."""
    phases = scene.actors[actor].phases
    who = {actor, *(p.target for p in phases if p.action == "follow")}
    if any(p.action == "run_red" for one in who if one in scene.actors for p in scene.actors[one].phases):
        return True
    turn = next((i for i, p in enumerate(phases) if p.action == "turn_right"), 0)
    return actor == EGO and any(p.action in ("stop", "yield") for p in phases[:turn])


def unseen(requirement: Requirement, evidence: Evidence) -> Result:
    event = str(requirement.values["event"])
    said = {"run_red": "no entering on red", "run_stop": "a full stop at the stop sign"}[event]
    for o in evidence.members(requirement.actor):
        time = next((e.time for e in o.events if e.event == event), None)
        if time is not None:
            return decided(requirement, False, said, event.replace("_", " "), time)
    return decided(requirement, True, said, "kept")


def own_side(requirement: Requirement, evidence: Evidence) -> Result:
    """Never against its lane for longer than the bound, before any contact."""
    limit = bounds()["rules"]["against"]["value"]
    for motion in evidence.motions(requirement.actor):
        stays = motion.course.stays
        ends = [*(s.time for s in stays[1:]), float(motion.time[-1])]
        wrong = [(s, e - s.time) for s, e in zip(stays, ends, strict=False) if s.against and s.kind == "lane"]
        for stay, lasts in wrong:
            inside = motion.speed[motion.at(stay.time) : motion.at(stay.time + lasts) + 1]
            if lasts > limit and float(inside.max()) > 1.0:
                return decided(requirement, False, "its own side", f"{lasts:.1f} s on the other side", stay.time)
    return decided(requirement, True, "its own side", "kept")


def _stands(motion: Motion) -> list[tuple[int, int]]:
    """Its stands of some length, (first step, last step)."""
    least = bounds()["rules"]["stands"]["value"]
    return [(a, b) for a, b in stretches(motion.speed < STANDING) if (b - a) * motion.step >= least]


def at_line(requirement: Requirement, evidence: Evidence) -> Result:
    """Of who comes to a stand before a controlled junction, with nobody else in its way."""
    limits = bounds()["rules"]
    near, beyond, reach = (limits[k]["value"] for k in ("line", "beyond", "approach"))
    said = f"within {near:g} m of its line"
    worst: tuple[float, str, float] | None = None
    for motion in evidence.motions(requirement.actor):
        front = motion.of_course("along") + motion.size[0] / 2
        lines = [m for m in motion.course.marks if m.kind == "line" and m.control in ("signal", "stop")]
        for first, _ in _stands(motion):
            away = min((m.start - float(front[first]) for m in lines if m.start > front[first] - 3.0), default=np.inf)
            if away > reach or any(in_its_way(motion, o, first, limits["queue"]["value"]) for o in evidence.everybody):
                continue
            margin = min((near - away) / near, (away + beyond) / beyond)
            if worst is None or margin < worst[0]:
                worst = (margin, f"{away:.1f} m before it", float(motion.time[first]))
    if worst is None:
        return scored(requirement, 1.0, said, "it waits at none")
    return scored(requirement, worst[0], said, worst[1], worst[2])


def stands_for(requirement: Requirement, evidence: Evidence) -> Result:
    """No stand in a driving lane but before a control, behind or before somebody."""
    limits = bounds()["rules"]
    motions = evidence.motions(requirement.actor)
    if not motions:
        return unknown(requirement, "no stand without a reason", "not judged: it is missing from the run")
    for motion in motions:
        front, gone = motion.of_course("along") + motion.size[0] / 2, passed_ego_since(motion, evidence)
        for first, last in _stands(motion):
            if motion.time[first] >= gone:
                continue
            stay = motion.stay(float(motion.time[first]))
            if stay is None or stay.kind not in ("lane", "junction"):
                continue
            marks = [m.start - float(front[first]) for m in motion.course.marks if m.control or m.kind == "crosswalk"]
            held = any(-3.0 < away < limits["line"]["value"] + 5.0 for away in marks)
            if not held and not any(in_its_way(motion, o, first, limits["queue"]["value"]) for o in evidence.everybody):
                seen = f"stands for {(last - first) * motion.step:.0f} s"
                return decided(requirement, False, "no stand without a reason", seen, float(motion.time[first]))
    return decided(requirement, True, "no stand without a reason", "none")


CHECKS = {"unseen": unseen, "own_side": own_side, "at_line": at_line, "stands_for": stands_for}

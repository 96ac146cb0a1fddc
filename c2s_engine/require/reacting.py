"""Ego reacts to a threat when it can see it, in time, and to that one.

The moment of the reaction is where the run parts from the one with ego's reaction switched off.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from c2s_engine.require.due import conflict_begins
from c2s_engine.require.evidence import Evidence, Motion
from c2s_engine.require.geometry import box_distance
from c2s_engine.require.results import scored, unknown
from c2s_engine.require.scene import bounds
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result

TURNS = ("turn_left", "turn_right", "u_turn")
SETS_OUT = ("cross_road", "enter_road", "reverse", "u_turn")


def another_scene(actor: str, one: Evidence, other: Evidence) -> str | None:
    """Why two runs are not of the same scene, where they are not."""
    limit = bounds()["conflict"]["same"]["value"]
    for who in (EGO, actor):
        a, b = one.motion(who), other.motion(who)
        if a is None or b is None or np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) > limit:
            return f"not judged: without ego's reaction the scene differs ({who} starts elsewhere)"
    return None


def reaction_time(evidence: Evidence) -> float | None:
    """When ego's run parts from its run without the reaction, s; None where it never does."""
    one = evidence.motion(EGO)
    other = evidence.without.motion(EGO) if evidence.without else None
    if one is None or other is None:
        return None
    n = min(len(one.x), len(other.x))
    limits = bounds()["reaction"]
    parted = (np.abs(one.speed[:n] - other.speed[:n]) > limits["speed"]["value"]) | (
        np.abs(one.of_course("aside")[:n] - other.of_course("aside")[:n]) > limits["aside"]["value"]
    )
    return float(one.time[int(np.argmax(parted))]) if parted.any() else None


def reacts(requirement: Requirement, evidence: Evidence) -> Result:
    limits = bounds()["reaction"]
    least, most = limits["least"]["value"], limits["most"]["value"]
    said = f"{least:g} to {most:g} s after the cause can be seen"
    if evidence.without is None:
        return unknown(requirement, said, "not judged: there was no run with ego's reaction switched off")
    if (why := another_scene(requirement.other or "", evidence, evidence.without)) is not None:
        return unknown(requirement, said, why)
    members = [m for m in evidence.motions(requirement.other or "") if m.course.sight]
    if not members:
        return unknown(requirement, said, "not judged: what ego can see was not recorded")
    time = reaction_time(evidence)
    if time is None:
        return scored(requirement, -1.0, said, "ego does not react")
    causes = [cause for m in members if (cause := _cause(m, str(requirement.values["action"]))) is not None]
    if causes and "cue" in requirement.values:
        cues = (_cause(m, str(requirement.values["its"])) for m in evidence.motions(str(requirement.values["cue"])))
        causes += [cue for cue in cues if cue is not None]
    time = _next_reaction(requirement, evidence, time, min(causes, default=0.0))
    if not causes:
        return scored(requirement, -1.0, said, f"ego reacts at {time:.1f} s to something it could never see", time)
    cause = min(causes)
    if (far := _far_from(members, requirement, evidence)) is not None:
        return scored(requirement, -1.0, said, f"ego reacts to another: it comes no nearer than {far:.0f} m", time)
    needed = _needed(requirement.other or "", evidence, bool(requirement.values["hard"]))
    late, early = time - max(cause, needed), round(time - cause, 3)
    # a threat from the start has no moment before which a reaction would be too early
    margins = [(most - late) / most, *([(early - least) / least] if cause > 0.0 else [])]
    words = f"at {time:.1f} s, {early:.2f} s after its cause"
    measured = (early, least, max(early, most)) if late < most else (late, 0.0, most)
    return scored(requirement, min(margins), said, words, time, why=f"cause at {cause:.1f} s", measured=measured)


def _far_from(members: Sequence[Motion], requirement: Requirement, evidence: Evidence) -> float | None:
    """m that ego keeps away from one of several threats, where that is more than a stop for it needs; else None."""
    ego, before = evidence.motion(EGO), evidence.without.motion(EGO) if evidence.without else None
    if ego is None or before is None or "others" not in requirement.values or before.speed[0] < 1.0:
        return None  # who stands at first waits where it stands
    limits = bounds()["reaction"]
    rate = limits["emergency" if requirement.values["hard"] else "gentle"]["value"]
    n = [min(len(m.x), len(ego.x)) for m in members]
    apart = (box_distance(m.poses[:k], ego.poses[:k], m.size, ego.size) for m, k in zip(members, n, strict=True))
    nearest = min(float(gaps.min()) for gaps in apart)
    needs = float(before.speed[0]) ** 2 / (2 * rate) + limits["short"]["value"]
    return nearest if nearest > needs else None


def _next_reaction(requirement: Requirement, evidence: Evidence, first: float, cause: float) -> float:
    """When ego reacts to one of several: its first reaction, or, where that comes before its cause and another threat
    can have been the reason, when it next begins to brake or still does."""
    others = requirement.values.get("others", ())
    ego = evidence.motion(EGO)
    if first >= cause or not isinstance(others, tuple) or ego is None:
        return first
    reasons = [m.visible_from() for o in others for m in evidence.motions(str(o))]
    if not any(seen is not None and seen <= first for seen in reasons):
        return first
    braking = np.flatnonzero((ego.acceleration < -1.0) & (ego.time >= cause + bounds()["reaction"]["least"]["value"]))
    return float(ego.time[braking[0]]) if len(braking) else first


def _cause(motion: Motion, action: str) -> float | None:
    """When ego can first see that the threat has begun, s."""
    return motion.visible_from(_onset(motion, action) or 0.0)


def _needed(actor: str, evidence: Evidence, hard: bool) -> float:
    """From when ego has to do something: so long before what would happen without as it needs to stop gently.

    Objects of several have names of the program's lines, which differ between the two runs: found by their component.
    """
    limits, other = bounds()["reaction"], evidence.without
    assert other is not None
    one, ego = other.motion(actor), other.motion(EGO)
    if one is None or ego is None:
        return 0.0
    contacts = other.contacts(actor, EGO)
    there = contacts[0].time if contacts else conflict_begins(one, ego)
    if there is None:
        n = min(len(one.x), len(ego.x))
        there = float(one.time[int(np.hypot(one.x[:n] - ego.x[:n], one.y[:n] - ego.y[:n]).argmin())])
    shortly_before = float(ego.speed[ego.at(there - limits["shortly"]["value"])])
    ahead = limits["ahead_hard" if hard else "ahead"]["value"]
    return there - min(shortly_before / limits["gentle"]["value"] + limits["spare"]["value"], ahead)


def _onset(motion: Motion, action: str) -> float | None:
    """When the threat begins: when it first moves sideways, brakes, sets out; None where it is there from the start."""
    limits: dict[str, Any] = bounds()["reaction"]
    if action in ("cut_in", "cut_out", "lane_change", "swerve", "drift", "lose_control", "oncoming"):
        aside = motion.of_course("aside")
        moved = np.abs(aside - aside[0]) > limits["aside"]["value"]
    elif action in ("brake", "stop"):
        moved = motion.acceleration < -1.0
    elif action in ("run_red", "run_stop"):  # when it can no longer stop at its line
        front = motion.of_course("along") + motion.size[0] / 2
        lines = [m.start for m in motion.course.marks if m.kind == "line"]
        rest = min(((s - front) for s in lines if s > front[0]), key=lambda r: r[0], default=np.zeros(len(front)))
        moved = rest < motion.speed**2 / (2 * limits["stopping"]["value"])
    elif action in SETS_OUT and (motion.speed[0] <= 0.3 or action not in TURNS):
        moved = (motion.speed > 0.3) if motion.speed[0] <= 0.3 else np.zeros(len(motion.speed), bool)
    elif action in TURNS:
        moved = (np.abs(motion.heading - motion.heading[0]) > limits["turned"]["value"]) | (motion.acceleration < -1.0)
    else:
        return None
    return float(motion.time[int(np.argmax(moved))]) if moved.any() else None

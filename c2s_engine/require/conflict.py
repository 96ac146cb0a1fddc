"""What S says to threaten ego does threaten it, and ego reacts to it when it can see it, in time.

The threat is judged on the same scene with ego's reaction switched off; the moment of the reaction is where the two
runs part.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from c2s_engine.require.evidence import Evidence, Motion
from c2s_engine.require.geometry import post_encroachment, time_to_collision
from c2s_engine.require.outcome import struck as struck_pairs
from c2s_engine.require.results import scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase

THREATS = ("cut_in", "cross_road", "enter_road", "run_red", "run_stop", "oncoming", "reverse", "drift", "u_turn",
           "lose_control", "stationary", "stop", "brake")  # fmt: skip
"""What may stand or come in ego's way."""
STRONG = ("cut_in", "enter_road", "run_red", "run_stop")
AHEAD_ONLY = ("stationary", "stop", "brake")
"""These threaten only who comes from behind."""
ANSWERS = ("brake", "stop", "swerve", "lane_change", "yield", "wait")
"""What ego does of its own accord in answer to another, where it names whom or waits for what that one does."""


def answers(phase: Phase, structure: Structure) -> bool:
    """Whether a phase of ego is an answer to another: it names whom, waits for what that one does, or has no other
    cause (a moment, a place, a light or sign) where ego reacts."""
    if phase.action not in ANSWERS:
        return False
    trigger, place = phase.trigger, structure.place.spec
    if phase.target is not None:
        return True
    if trigger is not None:
        return trigger.of is not None or trigger.kind in ("distance", "ttc", "action")
    stands = phase.action in ("brake", "stop", "wait")
    return stands and getattr(structure.ego.spec, "reaction", "none") != "none" and not getattr(place, "control", None)


def without_reaction(structure: Structure) -> Structure | None:
    """S with ego's reaction switched off; None where S says no conflict, or ego's code is not written from S.

    Who follows drives on at its speed: keeping the distance is a reaction too.
    """
    if not any(r.check == "reacts" or r.values.get("reaction") for r in required(Scene(structure))):
        return None
    spec = structure.ego.spec
    assert isinstance(spec, EgoSpec)
    first = next((i for i, p in enumerate(spec.phases) if answers(p, structure)), len(spec.phases))
    blind = {"action": "keep_lane", "target": None}
    phases = tuple(p.model_copy(update=blind) if p.action == "follow" else p for p in spec.phases[:first])
    changed = spec.model_copy(update={"reaction": "none", "hard": False, "react_to": None, "phases": phases})
    return structure.with_component(structure.ego.model_copy(update={"spec": changed}))


def required(scene: Scene) -> Iterator[Requirement]:
    if not scene.recognised(EGO):
        return
    reacts = scene.ego.reaction != "none" or any(answers(p, scene.structure) for p in scene.ego.phases)
    struck = {frozenset(pair) for pair in struck_pairs(scene)}
    for actor in _threats(scene, reacts):
        if frozenset((actor, EGO)) in struck or not scene.recognised(actor):
            continue
        name = scene.named(actor)
        text = f"{name} is a threat to ego: " + ("were ego not to react, they" if reacts else "they") + \
            " would collide or come very near."  # fmt: skip
        yield scene.make("conflict", "threatens", actor, "threat", text, other=EGO, reaction=reacts)
        if reacts and scene.ego.reaction != "follow":
            yield scene.make("reaction", "reacts", EGO, f"reaction.{actor}", f"Ego reacts to {name} once it can be "
                             "seen, in time, and not before.", other=actor,
                             action=_onset_of(scene.objects[actor]))  # fmt: skip


def _threats(scene: Scene, reacts: bool) -> list[str]:
    """Whom ego reacts to: the one that S names, else those whose doings or places are in its way.

    Where ego does not react, those whose doings are a threat to whoever is there.
    """
    if not reacts:
        return [a for a, o in scene.objects.items() if any(p.action in STRONG and p.target in (None, EGO)
                                                           for p in o.phases)]  # fmt: skip
    answering = (p for p in scene.ego.phases if answers(p, scene.structure))
    named = scene.ego.react_to or next((t for p in answering for t in _whom(p) if t), None)
    if named is not None and named != EGO:
        return [named] if named in scene.objects else []
    return [actor for actor, spec in scene.objects.items() if _threatens(spec)]


def _whom(phase: Phase) -> tuple[str | None, ...]:
    return phase.target, phase.trigger.of if phase.trigger else None


def _threatens(spec: ObjectSpec) -> bool:
    actions = [p.action for p in spec.phases if p.action in THREATS]
    ahead = spec.placement.position in ("ahead", "partly_in_lane", "intersection_exit") and spec.placement.of == EGO
    aimed = any(p.target in (None, EGO) for p in spec.phases if p.action in THREATS)
    return bool(aimed and any(a not in AHEAD_ONLY for a in actions)) or (bool(actions) and ahead)


def _onset_of(spec: ObjectSpec) -> str:
    """The action with which the threat begins; '' where it is one from the start."""
    return next((p.action for p in spec.phases if p.action in THREATS and p.action != "stationary"), "")


def threatens(requirement: Requirement, evidence: Evidence) -> Result:
    limits = bounds()["conflict"]
    said = f"contact, or within {limits['pet']['value']:g} s (PET) or {limits['ttc']['value']:g} s (TTC)"
    other = evidence.without if requirement.values["reaction"] else evidence
    if other is None:
        return unknown(requirement, said, "cannot be judged: the scene was not run with ego's reaction switched off")
    if (why := _another_scene(requirement.actor, evidence, other)) is not None:
        return unknown(requirement, said, why)
    if found := other.contacts(requirement.actor, EGO):
        return scored(requirement, 1.0, said, f"contact at {found[0].time:.1f} s", found[0].time)
    nearest = [_nearness(m, other.motion(EGO)) for m in other.motions(requirement.actor)]
    pet, ttc = min((p for p, _ in nearest), default=np.inf), min((t for _, t in nearest), default=np.inf)
    margin = max((limits["pet"]["value"] - pet) / limits["pet"]["value"],
                 (limits["ttc"]["value"] - ttc) / limits["ttc"]["value"])  # fmt: skip
    words = [f"{name} {value:.1f} s" for name, value in (("PET", pet), ("TTC", ttc)) if np.isfinite(value)]
    return scored(requirement, max(-1.0, margin), said, ", ".join(words) or "their ways do not meet")


def _nearness(one: Motion, ego: Motion | None) -> tuple[float, float]:
    if ego is None:
        return np.inf, np.inf
    n = min(len(one.x), len(ego.x))
    a, b = one.poses[:n], ego.poses[:n]
    ttc = time_to_collision(a, b, one.size, ego.size, one.step)
    return post_encroachment(a, b, one.size, ego.size, one.step), float(ttc.min())


def _another_scene(actor: str, one: Evidence, other: Evidence) -> str | None:
    """Why two runs are not of the same scene, where they are not."""
    limit = bounds()["conflict"]["same"]["value"]
    for who in (EGO, actor):
        a, b = one.motion(who), other.motion(who)
        if a is None or b is None or np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) > limit:
            return f"cannot be judged: without its reaction the scene is another ({who} starts elsewhere)"
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
        return unknown(requirement, said, "cannot be judged: the scene was not run with ego's reaction switched off")
    if (why := _another_scene(requirement.other or "", evidence, evidence.without)) is not None:
        return unknown(requirement, said, why)
    members = [m for m in evidence.motions(requirement.other or "") if m.course.sight]
    if not members:
        return unknown(requirement, said, "cannot be judged: what ego can see was not recorded")
    time = reaction_time(evidence)
    if time is None:
        return scored(requirement, -1.0, said, "ego does not react")
    causes = [cause for m in members if (cause := _cause(m, str(requirement.values["action"]))) is not None]
    if not causes:
        return scored(requirement, -1.0, said, f"ego reacts at {time:.1f} s to what it never could see", time)
    cause = min(causes)
    late, early = time - max(cause, _needed(requirement.other or "", evidence)), time - cause
    # a threat from the start has no moment before which a reaction would be too early
    margins = [(most - late) / most, *([(early - least) / least] if cause > 0.0 else [])]
    words = f"at {time:.1f} s, {early:.1f} s after its cause"
    measured = (early, least, max(early, most)) if late < most else (late, 0.0, most)
    return scored(requirement, min(margins), said, words, time, why=f"cause at {cause:.1f} s", measured=measured)


def _cause(motion: Motion, action: str) -> float | None:
    """When ego can first see that the threat has begun, s."""
    return motion.visible_from(_onset(motion, action) or 0.0)


def _needed(actor: str, evidence: Evidence) -> float:
    """From when ego has to do something: so long before what would happen without. Objects of several have names of the
    program's lines, which differ between the two runs: they are found by their component."""
    ahead = bounds()["reaction"]["ahead"]["value"]
    other = evidence.without
    assert other is not None
    if contacts := other.contacts(actor, EGO):
        return contacts[0].time - ahead
    one, ego = other.motion(actor), other.motion(EGO)
    if one is None or ego is None:
        return 0.0
    n = min(len(one.x), len(ego.x))
    apart = np.hypot(one.x[:n] - ego.x[:n], one.y[:n] - ego.y[:n])
    return float(one.time[int(apart.argmin())]) - ahead


def _onset(motion: Motion, action: str) -> float | None:
    """When the threat begins: when it first moves sideways, brakes, sets out; None where it is there from the start."""
    limits: dict[str, Any] = bounds()["reaction"]
    if action in ("cut_in", "drift", "lose_control", "oncoming"):
        aside = motion.of_course("aside")
        moved = np.abs(aside - aside[0]) > limits["aside"]["value"]
    elif action in ("brake", "stop"):
        moved = motion.acceleration < -1.0
    elif action in ("run_red", "run_stop"):  # when it can no longer stop at its line
        front = motion.of_course("along") + motion.size[0] / 2
        lines = [m.start for m in motion.course.marks if m.kind == "line"]
        rest = min(((s - front) for s in lines if s > front[0]), key=lambda r: r[0], default=np.zeros(len(front)))
        moved = rest < motion.speed**2 / (2 * limits["stopping"]["value"])
    elif action in ("cross_road", "enter_road", "reverse", "u_turn"):
        moved = (motion.speed > 0.3) if motion.speed[0] <= 0.3 else np.zeros(len(motion.speed), bool)
    else:
        return None
    return float(motion.time[int(np.argmax(moved))]) if moved.any() else None


CHECKS = {"threatens": threatens, "reacts": reacts}

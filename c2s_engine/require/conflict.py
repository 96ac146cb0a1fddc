"""What S says to threaten ego does threaten it, and ego reacts to it when it can see it, in time.

The threat is judged on the same scene with ego's reaction switched off.
"""

from collections.abc import Iterator
from copy import copy

import numpy as np

from c2s_engine.require import arriving
from c2s_engine.require.crossing import crosses
from c2s_engine.require.due import to_meet
from c2s_engine.require.evidence import Evidence, Motion
from c2s_engine.require.geometry import box_distance, lead, post_encroachment, time_to_collision
from c2s_engine.require.moments import OVER_LINE
from c2s_engine.require.natural import MOVING
from c2s_engine.require.outcome import struck as struck_pairs
from c2s_engine.require.reacting import TURNS, another_scene, reacts
from c2s_engine.require.results import scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.components import Structure
from c2s_engine.structure.crossers import crossed_vehicle
from c2s_engine.structure.facts import EGO
from c2s_engine.structure.requirements import Requirement, Result, Value
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, SettingsSpec, Trigger
from c2s_engine.structure.triggers import gives_way_by
from c2s_engine.structure.vocabulary import VEHICLES

THREATS = ("cut_in", "cross_road", "enter_road", "run_red", "run_stop", "oncoming", "reverse", "drift", "u_turn",
           "lose_control", "stationary", "stop", "brake")  # fmt: skip
"""What may stand or come in ego's way."""
STRONG = ("cut_in", "enter_road", "run_red", "run_stop")
AHEAD_ONLY = ("stationary", "stop", "brake")
"""These threaten only who comes from behind."""
APPROACHES = ("crossing_left", "crossing_right", "opposite_approach", "circulating")
ANSWERS = ("brake", "stop", "swerve", "lane_change", "yield", "wait")
"""What ego does of its own accord in answer to another, where it names whom or waits for what that one does."""
WAYS = {"brake": ("brake", "stop", "wait"), "yield": ("brake", "stop", "wait", "yield"),
        "follow": ("brake", "stop", "wait"),
        "evade": ("swerve", "lane_change", "overtake", "oncoming", "leave_road", "brake", "stop", "wait")}  # fmt: skip
"""By reaction, what says how ego does it: a phase without a cause of its own."""

LATER = Trigger(kind="time", value=60.0)
"""After all runs."""
GONE_BY = ("apart", "passed", "speed", "light", "place")
"""What one waits for that is no threat any more, or never was."""


def answers(phase: Phase, structure: Structure) -> bool:
    """Whether a phase of ego is an answer to another: it names whom, waits for what that one does, or has no other
    cause (a moment, a place, a light or sign) where ego reacts."""
    trigger, ego = phase.trigger, structure.ego.spec
    assert isinstance(ego, EgoSpec)
    way = phase.action in WAYS.get(ego.reaction, ())
    if phase.action not in ANSWERS and not (way and trigger is None):
        return False
    if phase.target is not None and phase.target == ego.react_to and way:
        return phase.gap is None
    if phase.target is not None:
        other = structure[phase.target].spec if phase.target in structure and phase.target != EGO else None
        comes = isinstance(other, ObjectSpec) and crosses(other)
        return phase.gap is None and (comes or phase.clearance is None or phase.action != "stop")
    if trigger is not None and (trigger.subject not in (None, EGO) or trigger.kind in GONE_BY):
        return False  # it waits for its chance
    if trigger is not None and (_landmark(structure, trigger.of) or _is_chance(structure, phase)):
        return False
    if trigger is not None:
        return trigger.of is not None or trigger.kind in ("distance", "ttc", "action")
    return way and not _stop_is_controlled(structure)


def _stop_is_controlled(structure: Structure) -> bool:
    """Whether a sign or a light may be why ego stops: not one that stays green for it."""
    lights, control = structure.settings.spec, getattr(structure.place.spec, "control", None)
    assert isinstance(lights, SettingsSpec)
    return bool(control) and not (control == "signal" and lights.light == "green" and not lights.light_changes)


def _is_chance(structure: Structure, phase: Phase) -> bool:
    """Whether ego goes on as another makes room for it: one behind it slows down."""
    slows, cue = WAYS["yield"], phase.trigger
    if phase.action in slows or cue is None or cue.action not in slows or not cue.of:
        return False
    other = structure[cue.of].spec if cue.of in structure else None
    return isinstance(other, ObjectSpec) and "behind" in (other.placement.position, other.placement.along)


def _landmark(structure: Structure, cid: str | None) -> bool:
    """Whether something only tells where ego is: a thing beside the road, or one that is driven over."""
    spec = structure[cid].spec if cid and cid in structure and cid != EGO else None
    if not isinstance(spec, ObjectSpec) or spec.type in MOVING:
        return False
    return spec.placement.position in ("roadside", "sidewalk") or spec.type == "slippery_patch"


def without_reaction(structure: Structure) -> Structure | None:
    """S with ego's reaction switched off; None where S says neither a conflict nor who comes when, where there is no
    reaction, or where ego's code is not written from S."""
    scene = Scene(structure)
    if not any(arriving.required(scene)) and not any(
        r.check == "reacts" or r.values.get("reaction") for r in required(scene)
    ):
        return None
    changed = unaware(structure)
    return changed if changed.ego.spec != structure.ego.spec else None


def unaware(structure: Structure) -> Structure:
    """S whose ego does what it does of its own accord and does not answer to the one that S names, or, where it names
    none, to anybody.

    Who follows that one drives on at its speed: keeping the distance is a reaction too.
    """
    spec = structure.ego.spec
    assert isinstance(spec, EgoSpec)

    def is_answer(phase: Phase) -> bool:
        others = {None, spec.react_to} if spec.react_to else {None, *_actors_named(phase)}
        return answers(phase, structure) and not others.isdisjoint(_actors_named(phase))

    first = next((i for i, p in enumerate(spec.phases) if is_answer(p)), len(spec.phases))
    blind = {"action": "keep_lane", "target": None, "gap": None}
    kept = spec.phases[:first]
    if first < len(spec.phases) and spec.phases[first].action == "yield":  # what it then does, it does at once
        kept += tuple(p for p in spec.phases[first + 1 :] if not is_answer(p))
    others = (None, spec.react_to or None)
    followed = [p for p in kept if p.action == "follow" and (spec.react_to is None or p.target in others)]
    phases = tuple(p.model_copy(update=blind) if p in followed else p for p in kept)
    phases = tuple(_gone_through_with(p) if p.abandoned else p for p in phases)  # breaking off is an answer, too
    of = spec.react_to if any(p.abandoned for p in kept) else None  # for whom it does not wait
    changed = spec.model_copy(update={"reaction": "none", "hard": False, "react_to": of, "phases": phases})
    return structure.with_component(structure.ego.model_copy(update={"spec": changed}))


def _gone_through_with(phase: Phase) -> Phase:
    """What is begun and broken off, gone on with: who overtakes stays out, from where it starts the same."""
    if phase.action in OVER_LINE:
        return phase.model_copy(update={"abandoned": False})
    return phase.model_copy(update={"until": LATER} if phase.action == "overtake" else {})


def required(scene: Scene) -> Iterator[Requirement]:
    if not scene.recognised(EGO):
        return
    answering = any(answers(p, scene.structure) for p in scene.ego.phases)
    reacts = scene.ego.reaction != "none" or answering
    asked_for = answering or scene.stated("E", "reaction")  # not one that is assumed
    struck = {frozenset(pair) for pair in struck_pairs(scene)}
    for actor in _threats(scene, reacts):
        if frozenset((actor, EGO)) in struck or not scene.recognised(actor) or _turns_off(scene, actor):
            continue
        name = scene.named(actor)
        text = f"{name} is a threat to ego: " + ("without a reaction of ego, they" if reacts else "they") + \
            " would collide or come very near."  # fmt: skip
        yield scene.make("conflict", "threatens", actor, "threat", text, other=EGO, reaction=reacts)
        if reacts and asked_for and scene.ego.reaction != "follow":
            others = tuple(a for a in scene.objects if a != actor)
            beside: dict[str, Value] = {"others": others} if others else {}
            beside |= _cue(scene, actor)
            yield scene.make("reaction", "reacts", EGO, f"reaction.{actor}", f"Ego reacts to {name} once it can be "
                             "seen, in time, and not before.", other=actor,
                             action=_onset_of(scene, actor), hard=scene.ego.hard,
                             **beside)  # type: ignore[arg-type]  # fmt: skip


def _cue(scene: Scene, actor: str) -> dict[str, Value]:
    """What another than the threat does that S has ego wait for before it answers: that is cause enough."""
    waits = (p.trigger for p in scene.ego.phases if answers(p, scene.structure) and p.trigger is not None)
    told = next((t for t in waits if t.kind == "action" and t.of not in (None, EGO, actor) and t.action), None)
    return {"cue": str(told.of), "its": str(told.action)} if told is not None else {}


def _turns_off(scene: Scene, actor: str) -> bool:
    """Whether one for whom ego waits in vain, as S says: it leaves the roundabout before it comes to ego's way."""
    spec = scene.objects[actor]
    circles = scene.place.kind == "roundabout" and spec.placement.position == "circulating"
    return circles and any(p.action == "turn_right" for p in spec.phases)


def _threats(scene: Scene, reacts: bool) -> list[str]:
    """Whom ego reacts to: the one that S names, else those whose doings or places are in its way.

    Where ego does not react, those whose doings are a threat to whoever is there.
    """
    if not reacts:
        return [a for a, o in scene.objects.items() if any(
            p.action in STRONG and not p.abandoned and p.target in (None, EGO) for p in o.phases)]  # fmt: skip
    answering = (p for p in scene.ego.phases if answers(p, scene.structure))
    named = scene.ego.react_to or next((t for p in answering for t in _actors_named(p) if t), None)
    if named is not None and named != EGO:
        if gives_way_by(scene.ego):  # the moment of that is required
            return []
        # whom it overtakes of its own accord
        followed = scene.ego.reaction == "follow" and any(
            p.action == "overtake" and p.target == named for p in scene.ego.phases)  # fmt: skip
        spec = scene.objects.get(named)
        doings = [p for p in spec.phases if p.action in THREATS] if spec is not None else []
        if any(p.abandoned for p in doings[:1]):  # it stays beside the road
            return []
        elsewhere = bool(doings) and all(p.target not in (None, EGO) for p in doings)  # what it does is about others
        stays = _landmark(scene.structure, named)  # ego stops by it
        return [named] if spec is not None and not (followed or elsewhere or stays) else []
    before_ego = [a for a in scene.objects if crossed_vehicle(scene.structure, a) == EGO]
    found = [a for a in before_ego if _threatens(scene.objects[a])]
    turns = TURNS if scene.ego.hard else ()  # whoever gives way brakes gently
    comers = [a for a in before_ego if scene.objects[a].placement.position in APPROACHES]
    met = [a for a in comers if _comes_across(scene, scene.objects[a])]
    if found or len(met) == 1:  # nobody else can be meant
        return found or met
    return [a for a in comers if any(p.action in turns for p in scene.objects[a].phases)]


def _comes_across(scene: Scene, spec: ObjectSpec) -> bool:
    """Whether one drives from the opposite approach over the way by which ego turns left."""
    if spec.placement.position != "opposite_approach" or spec.speed == 0 or spec.type not in VEHICLES:
        return False
    if any(p.action in ("stop", "wait", "stationary", "yield") for p in spec.phases):
        return False
    left = scene.place.manoeuvre == "left" or any(p.action == "turn_left" for p in scene.ego.phases)
    return left and not any(p.action == "turn_left" for p in spec.phases)


def _actors_named(phase: Phase) -> tuple[str | None, ...]:
    """Whom a phase names; None where nobody."""
    named = tuple(c for c in (phase.target, phase.trigger.of if phase.trigger else None) if c)
    return named or (None,)


def _threatens(spec: ObjectSpec) -> bool:
    actions = [p.action for p in spec.phases if p.action in THREATS and not p.abandoned]
    ahead = spec.placement.position in ("ahead", "partly_in_lane", "intersection_exit") and spec.placement.of == EGO
    ahead = ahead and not (spec.placement.position == "intersection_exit" and spec.placement.side)  # at the kerb
    aimed = any(p.target in (None, EGO) for p in spec.phases if p.action in THREATS)
    return bool(aimed and any(a not in AHEAD_ONLY for a in actions)) or (bool(actions) and ahead)


def _onset_of(scene: Scene, actor: str) -> str:
    """The action with which the threat begins: the one that ego waits for; '' where it is one from the start."""
    spec, waits = scene.objects[actor], (p.trigger for p in scene.ego.phases if p.trigger is not None)
    if told := next((t.action for t in waits if t.kind == "action" and t.of == actor), None):
        return told
    turning = next((p for p in spec.phases if p.action in TURNS), None)
    turns = turning.action if turning is not None else ""
    beside = spec.placement.position not in APPROACHES  # it slows for it
    if turning is not None and (beside or turning.trigger is not None):
        return turns
    threat = next((i for i, p in enumerate(spec.phases) if p.action in THREATS and p.action != "stationary"), None)
    if threat is not None and turns in [p.action for p in spec.phases[:threat]]:
        return turns
    return spec.phases[threat].action if threat is not None else ""


def threatens(requirement: Requirement, evidence: Evidence) -> Result:
    limits = bounds()["conflict"]
    said = f"contact, or within {limits['pet']['value']:g} s (PET) or {limits['ttc']['value']:g} s (TTC)"
    other = evidence.without if requirement.values["reaction"] else evidence
    if other is None:
        return unknown(requirement, said, "not judged: there was no run with ego's reaction switched off")
    if (why := another_scene(requirement.actor, evidence, other)) is not None:
        return unknown(requirement, said, why)
    if found := other.contacts(requirement.actor, EGO):
        return scored(requirement, 1.0, said, f"contact at {found[0].time:.1f} s", found[0].time)
    ego = _unhindered(requirement.actor, other, evidence)
    beside = min((_passes(m, ego) for m in other.motions(requirement.actor)), default=np.inf)
    if beside < limits["beside"]["value"]:
        return scored(requirement, 1.0, said, f"passes at {beside:.1f} m")
    nearest = [_nearness(m, ego) for m in other.motions(requirement.actor)]
    pet, ttc = min((p for p, _ in nearest), default=np.inf), min((t for _, t in nearest), default=np.inf)
    margin = max((limits["pet"]["value"] - pet) / limits["pet"]["value"],
                 (limits["ttc"]["value"] - ttc) / limits["ttc"]["value"])  # fmt: skip
    near = [f"{name} {value:.1f} s" for name, value in (("PET", pet), ("TTC", ttc)) if np.isfinite(value)]
    due = _due(other.motion(requirement.actor), ego) if margin < 0 else None
    return scored(requirement, max(-1.0, margin), said, ", ".join(near) or "their paths do not cross", due=due)


def _due(one: Motion | None, ego: Motion | None) -> float | None:
    return to_meet(one, ego) if one and ego else None


def _unhindered(actor: str, other: Evidence, evidence: Evidence) -> Motion | None:
    """Ego's motion without its reaction; where a contact with somebody else ends that, it goes on at its speed along
    the way that it takes where it does react."""
    ego, real = other.motion(EGO), evidence.motion(EGO)
    if ego is None or real is None or ego.contact is None or other.contacts(actor, EGO) or other is evidence:
        return ego
    gone = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(real.x), np.diff(real.y)))])
    own = float(np.hypot(np.diff(ego.x), np.diff(ego.y)).sum())
    steps = max(0, len(real.x) - len(ego.x))
    onward = own + ego.speed[-1] * ego.step * np.arange(1, steps + 1)
    onward = onward[onward <= gone[-1]]
    longer = copy(ego)
    for name in ("x", "y", "heading"):
        setattr(longer, name, np.concatenate([getattr(ego, name), np.interp(onward, gone, getattr(real, name))]))
    return longer


def _nearness(one: Motion, ego: Motion | None) -> tuple[float, float]:
    if ego is None:
        return np.inf, np.inf
    n = min(len(one.x), len(ego.x))
    a, b = one.poses[:n], ego.poses[:n]
    ttc = time_to_collision(a, b, one.size, ego.size, one.step)
    return post_encroachment(a, b, one.size, ego.size, one.step), float(ttc.min())


def _passes(one: Motion, ego: Motion | None) -> float:
    """m between the two, at least, where one goes by the other: one of them is ahead first and behind then."""
    if ego is None:
        return np.inf
    n = min(len(one.x), len(ego.x))
    a, b = ego.poses[:n], one.poses[:n]
    ahead = lead(a, b)
    if not (ahead[0] > 0 > ahead[-1] or ahead[0] < 0 < ahead[-1]):
        return np.inf
    return float(box_distance(a, b, ego.size, one.size).min())


CHECKS = {"threatens": threatens, "reacts": reacts}

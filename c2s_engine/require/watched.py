"""What a trigger watches, on the tracks: a phase begins as that comes about, and ends where it is said to end then."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from c2s_engine.require import crossing, moments
from c2s_engine.require.evidence import STANDING, Evidence, Motion
from c2s_engine.require.geometry import box_distance, lead
from c2s_engine.require.results import between, decided, scored, unknown
from c2s_engine.require.scene import TURNS, Scene, bounds
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.quantity import high, low, middle
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import Phase, SettingsSpec, Trigger
from c2s_engine.structure.triggers import clause, is_watched, other_of

STANDS = ("stationary", "wait", "stop", "yield")
SHOWN_AS = {"dark": ("off",), "flashing": ("yellow", "off")}
"""What the signal of a light shows that is out of order, or flashes."""
BENDS = 1 / 150
"""1/m: a bend's curvature."""
AT_LINE = 3.0
"""m before its line within which one stands at it."""
REACHED = 0.5
"""m/s within which a speed is reached."""

NEAR = {"distance": "view", "ttc": "soon"}
"""Bounds of how near is near, by what is watched."""

DRIVES_ON, LONGEST_STAND = ("keep_lane", "follow", "move_along"), 20.0
"""What one does that goes on as before; s before it is due in which one may have come to a stand."""

Array = np.ndarray


def required(scene: Scene) -> Iterator[Requirement]:
    for actor, i, phase in scene.phases():
        cid, path = component_of(actor), f"phases.{i}"
        gives_up = phase.action == "overtake" and phase.abandoned
        name, said = scene.named(actor), phase.action.replace("_", " ")
        of = f"{cid}.{path}.{'abandoned' if gives_up else phase.action}"
        t = phase.trigger
        if t is not None and is_watched(t, actor) and scene.stated(cid, f"{path}.trigger"):
            yield scene.make("order", "begins_when", actor, f"{path}.trigger", f"{name}: {said} begins when "
                             f"{words(scene, t, actor)}.", of=of, action=phase.action,
                             delay=middle(t.delay or 0.0), **_values(scene, t, actor))  # fmt: skip
        if phase.until is not None and scene.stated(cid, f"{path}.until"):
            yield scene.make("order", "ends_when", actor, f"{path}.until", f"{name}: {said} until "
                             f"{words(scene, phase.until, actor)}.", of=of, action=phase.action,
                             **_values(scene, phase.until, actor))  # fmt: skip
        yield from _clearance(scene, actor, path, phase)
    settings = scene.structure.settings.spec
    for i, change in enumerate(settings.light_changes if isinstance(settings, SettingsSpec) else ()):
        text = f"The light turns {change.to} when {words(scene, change.when, EGO)}."
        yield scene.make("settings", "light_turns", EGO, f"light_changes.{i}", text, component="G",
                         delay=middle(change.when.delay or 0.0), **_values(scene, change.when, EGO),
                         turns=change.to)  # fmt: skip
    for i, c in enumerate(getattr(scene.structure.restrictions.spec, "require", ())):
        if c.kind == "closest":
            least, most = c.minimum or 0.0, c.maximum if c.maximum is not None else np.inf
            one, other = scene.named(c.subject), scene.named(c.other or EGO)
            room = f"at least {least:g} m" if np.isinf(most) else f"{least:g} to {most:g} m"
            text = f"The smallest gap between {one} and {other} is {room}."
            yield scene.make("outcome", "closest", c.subject, f"require.{i}", text, other=c.other or EGO, component="T",
                             least=least, most=most)  # fmt: skip


def words(scene: Scene, t: Trigger, actor: str) -> str:
    """A trigger as sentences say it."""
    subject = t.subject or actor
    return clause(t, scene.named(subject), scene.named(_other(scene, t, actor)))


def _other(scene: Scene, t: Trigger, actor: str) -> str:
    return other_of(t, actor, next(iter(scene.objects), EGO))


def _values(scene: Scene, t: Trigger, actor: str) -> dict[str, Any]:
    subject = t.subject or actor
    awaited = ""
    for who, i, phase in scene.phases():
        if t.kind == "action" and who == (t.of or EGO) and phase.action == t.action:
            awaited = f"{component_of(who)}.phases.{i}.{phase.action}"
    return {
        "watched": t.kind, "subject": subject, "than": _other(scene, t, actor), "awaited": awaited,
        "its": t.action or "", "place": t.place or "", "light": t.light or "",
        "value": middle(t.value) if t.value is not None else -1.0,
    }  # fmt: skip


def comes_about(requirement: Requirement, evidence: Evidence) -> float | None:
    """When what is watched first holds, s; None: never, or nothing was recorded of it."""
    v = requirement.values
    kind, value = str(v["watched"]), float(v["value"])  # type: ignore[arg-type]
    if value < 0 and kind in NEAR:
        value = bounds()["order"][NEAR[kind]]["value"]
    if kind == "time":
        return value
    if kind == "action":
        seen, motion = evidence.times.get(str(v["awaited"])), evidence.motion(str(v["than"]))
        begun = seen is not None and motion and v["its"] != "stop"  # that it stops can be seen when it stands
        return moments.onset(motion, str(v["its"]), seen) if begun else seen  # type: ignore[arg-type]
    one, other = evidence.motion(str(v["subject"])), evidence.motion(str(v["than"]))
    if one is None:
        return None
    if kind == "light":
        return _light(one, evidence, str(v["light"]))
    if kind == "speed":
        off = one.smooth - value
        crossed = np.flatnonzero((np.abs(off) < REACHED) | (np.sign(off) != np.sign(off[0])))
        return float(one.time[crossed[0]]) if len(crossed) else None
    if kind == "place":
        return _at_place(one, str(v["place"]), max(value, 0.0))
    if other is None:
        return None
    if kind == "contact":
        found = evidence.contacts(str(v["subject"]), str(v["than"]))
        return found[0].time if found else None
    if kind == "seen":
        if EGO not in (v["subject"], v["than"]):
            return None
        shown = (other if v["subject"] == EGO else one).visible_from()
        if shown != 0.0:  # it comes out from behind something
            return shown
        kind, value = "distance", bounds()["order"]["view"]["value"]
    holds = _of_two(kind, one, other, value)
    first = np.flatnonzero(holds)
    return float(one.time[first[0]]) if len(first) else None


def _of_two(kind: str, one: Motion, other: Motion, value: float) -> Array:
    """At each step whether it holds of two that are both there."""
    n = min(len(one.x), len(other.x))
    if kind == "passed":
        return lead(one.poses[:n], other.poses[:n]) < -one.size[0] / 2
    if kind == "ttc":
        apart = other.poses[:n, :2] - one.poses[:n, :2]
        closing = -np.gradient(apart, one.step, axis=0)
        speed = np.maximum(np.hypot(*closing.T), 0.1)
        rest = (apart * closing).sum(axis=1) / speed
        return (rest > 0) & (rest - (one.size[0] + other.size[0]) / 2 < value * speed)
    gap = box_distance(one.poses[:n], other.poses[:n], one.size, other.size)
    return gap > value if kind == "apart" else gap < value


def _at_place(motion: Motion, place: str, before: float) -> float | None:
    """When its front is so far (m) before a place on its way; of a junction when it is in it or has left it."""
    front = motion.of_course("along") + motion.size[0] / 2
    if place == "bend":
        along = motion.of_course("along")
        turned = np.abs(motion.heading - motion.heading[0])
        bend = np.flatnonzero(turned > 0.06)
        if not len(bend):
            return None
        there = np.flatnonzero(front > along[bend[0]] - before)
        return float(motion.time[there[0]]) if len(there) else None
    kinds = {"stop_line": "line", "crosswalk": "crosswalk", "merge_end": "merge"}
    marks = [m for m in motion.course.marks if m.kind == kinds.get(place, "junction")]
    marks = marks or [m for m in motion.course.marks if place == "stop_line" and m.kind == "junction"]
    if not marks:
        return None
    first = min(marks, key=lambda m: m.start)
    goal = {"past_intersection": first.end + motion.size[0], "merge_end": first.end}.get(place, first.start) - before
    there = np.flatnonzero(front >= goal - {"past_intersection": 0.0, "stop_line": AT_LINE}.get(place, 0.5))
    if len(there) or place != "past_intersection":
        return float(motion.time[there[0]]) if len(there) else None
    inside = [i for i, s in enumerate(motion.course.stays) if s.kind == "junction"]  # of riders beside the lanes
    after = motion.course.stays[inside[-1] + 1 :] if inside else ()
    return after[0].time if after else None


def _light(motion: Motion, evidence: Evidence, state: str) -> float | None:
    """When the light on its way shows a state."""
    return next(_shows(motion, evidence, state), None)


def _shows(motion: Motion, evidence: Evidence, state: str) -> Iterator[float]:
    """The times (s) at which a light on its way begins to show a state."""
    names = {m.name for m in motion.course.marks if m.kind == "line" and m.control == "signal"}
    wanted = SHOWN_AS.get(state, (state,))
    return (t for t, where, shown in evidence.trajectories.lights if where in names and shown in wanted)


def _follows(requirement: Requirement, begun: float, due: float, said: str, seen: str) -> Result:
    """Whether something begins (s) when it is due or soon after, and not before."""
    room = bounds()["order"]["begins"]["value"]
    off = max(due - begun, begun - due - room, 0.0)
    return scored(requirement, 1.0 - off / room * 2, said, seen, begun)


def begins_when(requirement: Requirement, evidence: Evidence) -> Result:
    v, said = requirement.values, "when its trigger condition becomes true"
    motion, seen = evidence.motion(requirement.actor), evidence.times.get(str(v["of"]))
    if motion is None or seen is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    since = comes_about(requirement, evidence)
    if since is None:
        return decided(requirement, False, said, f"at {seen:.1f} s, but the condition never became true", seen)
    if float(v["value"]) < 0 and v["watched"] in NEAR:  # type: ignore[arg-type]
        return _near(requirement, evidence, moments.onset(motion, str(v["action"]), seen))
    due = since + float(v["delay"])  # type: ignore[arg-type]
    begun = moments.onset(motion, str(v["action"]), seen)
    if v["action"] in moments.OVER_LINE and (over := moments.over_line(motion, seen)) is not None:
        begun = min(max(begun, due), over)  # it begins before that, and is over the line after it
    if v["action"] == "stop" and (v["watched"] == "contact" or v["watched"] == "place" and float(v["value"]) <= 0):  # type: ignore[arg-type]
        # it stands there, or comes to rest then, having slowed down before
        begun = min(max(begun, due), seen)
    if v["place"] == "in_intersection" and v["action"] in STANDS and _inside(motion, seen):
        begun = due  # wherever it is in there that it comes to stand
    if v["action"] in DRIVES_ON and begun < due:
        begun = _moves_again(motion, due)
    if v["action"] in TURNS and begun > due and motion.speed[motion.at(due) : motion.at(begun)].min() > STANDING:
        begun = due  # it turns as it comes there
    return _follows(requirement, begun, due, said, f"{begun:.1f} s, condition true at {since:.1f} s")


def _moves_again(motion: Motion, due: float) -> float:
    """When one that stood as it was due to drive on (s) moves off; then, where it drove all along."""
    stood = np.flatnonzero((motion.speed < STANDING) & (motion.time > 0.5) & (motion.time > due - LONGEST_STAND))
    moves = np.flatnonzero((motion.speed > STANDING) & (np.arange(len(motion.speed)) > (stood[0] if len(stood) else 0)))
    return float(motion.time[moves[0]]) if len(stood) and len(moves) else due


def _inside(motion: Motion, time: float) -> bool:
    """Whether one is in a junction then."""
    stays = [s for s in motion.course.stays if s.time <= time]
    return bool(stays) and stays[-1].kind == "junction"


def _near(requirement: Requirement, evidence: Evidence, begun: float) -> Result:
    """Whether the two are near one another as a phase begins (s), where S says only that it waits for that."""
    v, near = requirement.values, bounds()["order"][NEAR[str(requirement.values["watched"])]]["value"]
    one, other = evidence.motion(str(v["subject"])), evidence.motion(str(v["than"]))
    assert one is not None and other is not None
    holds = np.flatnonzero(_of_two(str(v["watched"]), one, other, near))
    off = float(np.abs(one.time[holds] - begun).min())
    room = bounds()["order"]["begins"]["value"]
    return scored(requirement, 1.0 - off / room * 2, "when they are near", f"{begun:.1f} s, {off:.1f} s off", begun)


def ends_when(requirement: Requirement, evidence: Evidence) -> Result:
    v, said = requirement.values, "until its end condition becomes true"
    motion, seen = evidence.motion(requirement.actor), evidence.times.get(str(v["of"]))
    if motion is None or seen is None:
        return unknown(requirement, said, "not judged: the action did not occur")
    since = comes_about(requirement, evidence)
    if since is None:
        return decided(requirement, False, said, "the condition never became true", seen)
    if str(v["action"]) not in STANDS:
        found = f"condition true at {since:.1f} s, started at {seen:.1f} s"
        return decided(requirement, since >= seen - 0.5, said, found, since)
    moves = np.flatnonzero((motion.speed > STANDING) & (motion.time > max(seen, since - 2.0)))
    if not len(moves):
        return decided(requirement, False, said, "it does not move again", since)
    moved = float(motion.time[moves[0]])
    return _follows(requirement, moved, since, said, f"moves at {moved:.1f} s, condition true at {since:.1f} s")


def _clearance(scene: Scene, actor: str, path: str, phase: Phase) -> Iterator[Requirement]:
    cid = component_of(actor)
    if phase.clearance is None or phase.target is None or not scene.stated(cid, f"{path}.clearance"):
        return
    least, most, stands = low(phase.clearance), high(phase.clearance), phase.action == "stop"
    where = "stands" if stands else "goes by with"
    text = f"{scene.named(actor)}: {phase.action.replace('_', ' ')}: {where} {least:g} m " \
        f"{'before' if stands else 'between it and'} {scene.named(phase.target)}."  # fmt: skip
    other = scene.objects.get(phase.target)
    across = actor == EGO and stands and other is not None and crossing.crosses(other)
    yield scene.make("place", "clearance", actor, f"{path}.clearance", text, other=phase.target, stands=stands,
                     across=across, least=least, most=most)  # fmt: skip


def clearance(requirement: Requirement, evidence: Evidence) -> Result:
    v, one, other = requirement.values, evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    said = f"{v['least']:g} m"
    if one is None or other is None:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    n = min(len(one.x), len(other.x))
    gaps = box_distance(one.poses[:n], other.poses[:n], one.size, other.size)
    at = int(gaps.argmin())
    if v["stands"]:
        stands = np.flatnonzero((one.speed[:n] < STANDING) & (one.time[:n] > 0.5))
        if not len(stands):
            return decided(requirement, False, said, "it does not stand")
        at = int(stands[0])
        if v["across"] and other.course.ego_along:  # who crosses walks on: to their way, along ego's lane
            front = float(one.of_course("along")[at]) + one.size[0] / 2
            gaps[at] = crossing.way_across(other)[0] - other.size[1] / 2 - front
    limits = bounds()["clearance"]
    room = limits["stands" if v["stands"] else "passes"]["value"] + limits["share"]["value"] * float(v["most"])  # type: ignore[arg-type]
    return between(requirement, float(gaps[at]), room, said, f"{gaps[at]:.1f} m", float(one.time[at]))


def closest(requirement: Requirement, evidence: Evidence) -> Result:
    v, one, other = requirement.values, evidence.motion(requirement.actor), evidence.motion(requirement.other or EGO)
    least, most = float(v["least"]), float(v["most"])  # type: ignore[arg-type]
    said = f"no nearer than {least:g} m" if np.isinf(most) else f"{least:g} to {most:g} m at the nearest"
    if one is None or other is None:
        return unknown(requirement, said, "not judged: one of the two is missing from the run")
    n = min(len(one.x), len(other.x))
    gaps = box_distance(one.poses[:n], other.poses[:n], one.size, other.size)
    at = int(gaps.argmin())
    touch = bool(evidence.contacts(requirement.actor, requirement.other or EGO))
    nearest = 0.0 if touch else float(gaps[at])
    margin = min(nearest - least, most - nearest) / max(0.5, 0.25 * least)
    return scored(requirement, -1.0 if touch and least > 0 else margin, said, f"{nearest:.1f} m", float(one.time[at]),
                  measured=(nearest, least, most))  # fmt: skip


def light_turns(requirement: Requirement, evidence: Evidence) -> Result:
    v, ego = requirement.values, evidence.motion(EGO)
    said = f"turns {v['turns']} then"
    due = comes_about(requirement, evidence)
    if ego is None or due is None:
        return unknown(requirement, said, "not judged: its condition never became true")
    due += float(v["delay"])  # type: ignore[arg-type]
    turns = list(_shows(ego, evidence, str(v["turns"])))
    if not turns:
        return decided(requirement, False, said, "the light never turns that colour")
    if v["watched"] == "time" and float(v["value"]) < 0:  # type: ignore[arg-type]  # no moment is said
        due = turns[0]
    nearest = min(turns, key=lambda t: abs(t - due))
    room = bounds()["order"]["turns"]["value"]
    seen = f"{nearest:.1f} s, condition true at {due:.1f} s"
    return scored(requirement, 1.0 - abs(nearest - due) / room, said, seen, nearest)


CHECKS = {"begins_when": begins_when, "ends_when": ends_when, "clearance": clearance, "closest": closest,
          "light_turns": light_turns}  # fmt: skip

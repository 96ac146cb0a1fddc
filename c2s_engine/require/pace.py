"""The run begins with what is said, not with a long drive, and is over soon after."""

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence, Motion
from c2s_engine.require.moments import beside, onset
from c2s_engine.require.phases import AT_JUNCTION, LASTING
from c2s_engine.require.results import scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure.facts import EGO, component_of
from c2s_engine.structure.quantity import high
from c2s_engine.structure.requirements import Requirement, Result

CHANGES_SPEED = ("accelerate", "start")
LONGEST_GAIN = 12.0
"""s within which a speed is reached, with breaks."""


def required(scene: Scene) -> Iterator[Requirement]:
    ids = tuple(
        f"{component_of(actor)}.phases.{i}.{end}"
        for actor, i, p in scene.phases() if p.action not in LASTING
        for end in (p.action, *({"overtake": ("back", "abandoned"), "swerve": ("back",)}.get(p.action, ())))
    )  # fmt: skip
    if not ids:
        return
    then = [f"{component_of(actor)}.phases.{i}.{p.action}" for actor, i, p in scene.phases()
            if i and p.action in ("follow", "stationary", "wait")]  # fmt: skip
    then += [key.removesuffix("follow") + "gap" for key in then if key.endswith("follow")]  # it has come to that
    changes = getattr(scene.structure.settings.spec, "light_changes", ())
    awaited = [*(p.trigger for _, _, p in scene.phases()), *(c.when for c in changes)]
    timed = max((high(t.value) for t in awaited if t and t.kind == "time" and t.value is not None), default=0.0)
    if any(p.trigger and p.trigger.place == "merge_end" for _, _, p in scene.phases()):
        timed = max(timed, bounds()["pace"]["merge"]["value"])  # the whole acceleration lane comes first
    lasting = max((high(p.duration) for _, _, p in scene.phases() if p.duration is not None), default=0.0)
    comes_up = tuple(actor for actor, i, p in scene.phases() if i == 0 and p.action == "follow")
    yield scene.make("pace", "first_event", EGO, "pace.first", "The first event comes within seconds, not at once.",
                     component="T", of=ids, timed=timed, comes_up=comes_up)  # fmt: skip
    spec = scene.structure.restrictions.spec
    if getattr(spec, "duration", None) is None or not scene.stated("T", "duration"):
        yield scene.make("pace", "soon_over", EGO, "pace.over", "The run ends soon after the last event.",
                         component="T", of=ids, then=tuple(then), lasting=lasting, reacts=scene.ego.reaction != "none",
                         round=scene.place.kind == "roundabout")  # fmt: skip
    yield scene.make("pace", "not_cut_short", EGO, "pace.whole", "The run does not end in the middle of an action.",
                     component="T")  # fmt: skip
    yield scene.make("pace", "no_dead_time", EGO, "pace.dead", "There is no long stretch without an event.",
                     component="T", of=ids, lasting=max(lasting, timed))  # fmt: skip


def _moments(requirement: Requirement, evidence: Evidence) -> list[float]:
    """When what is said was seen, and ego's reaction, in order."""
    of = requirement.values["of"]
    assert isinstance(of, tuple)
    found = [t for key in of if (t := evidence.times.get(str(key))) is not None]
    return sorted(found)


def _last(requirement: Requirement, moments: list[float], evidence: Evidence) -> float:
    """The last thing that happens: of what is said, a junction left behind, a speed reached, a contact, that somebody
    comes to its stand or that ego's braking for others is over."""
    seen = ((key, action, m, evidence.times.get(key)) for key, action, m in _seen(requirement, evidence))
    round_it = bool(requirement.values["round"])
    ends: dict[str, Callable[[Motion, float], float]] = {}
    ends |= dict.fromkeys(AT_JUNCTION, partial(_leaves, round_it=round_it))
    ends |= dict.fromkeys(CHANGES_SPEED, _reached) | {"swerve": _back_in_lane}
    left = [ends[action](m, t) for _, action, m, t in seen if t is not None and action in ends]
    stands = [
        float(m.time[len(m.speed) - 1 - int((m.speed[::-1] >= STANDING).argmax())])
        for m in evidence.everybody if m.moves and m.speed[-1] < STANDING
    ]  # fmt: skip
    follows = bounds()["pace"]["follows"]["value"]
    then = [t + follows * str(key).endswith("follow") for key in requirement.values["then"]  # type: ignore[union-attr]
            if (t := evidence.times.get(str(key))) is not None]  # fmt: skip
    contacts = [c.time for c in evidence.facts.contacts]
    return max([*moments, *then, *left, *stands, *_braked(requirement, evidence), *contacts])


def _seen(requirement: Requirement, evidence: Evidence) -> Iterator[tuple[str, str, Motion]]:
    """The phases of what is said: their ids, their actions, those who drive them."""
    of = requirement.values["of"]
    assert isinstance(of, tuple)
    for key in map(str, of):
        component, _, rest = key.partition(".")
        yield from ((key, rest.rpartition(".")[2], m) for m in evidence.motions(EGO if component == "E" else component))


def _reached(motion: Motion, time: float) -> float:
    """When somebody who gains speed at `time` no longer does."""
    first, last = motion.at(time), motion.at(time + LONGEST_GAIN)
    gaining = motion.acceleration[first : last + 1] > bounds()["phase"]["change_rate"]["value"] / 2
    return float(motion.time[first + int(np.flatnonzero(gaining)[-1])]) if gaining.any() else time


def _back_in_lane(motion: Motion, time: float) -> float:
    """When somebody who leaves the middle of its lane at `time` is back in it; then, where it does not come back."""
    first, limits = motion.at(time), bounds()["phase"]
    aside = np.nan_to_num(np.abs(motion.of_course("aside")))[first:]
    out = int((aside > limits["out"]["value"]).argmax())
    back = np.flatnonzero(aside[out:] < limits["back"]["value"])
    return float(motion.time[first + out + back[0]]) if len(back) else time


def _leaves(motion: Motion, time: float, round_it: bool) -> float:
    """When somebody who comes into a junction at `time` is out of it, or where its run or its way ends there; of a
    roundabout the last of its junctions."""
    stays = motion.course.stays
    if round_it:
        time = max([time, *(s.time for s in stays if s.kind == "junction")])
    inside = next((k for k, s in enumerate(stays) if s.kind == "junction" and s.time > time - 1.0), None)
    if inside is None:
        return time
    if inside + 1 < len(stays):
        return stays[inside + 1].time
    moving = np.flatnonzero(motion.speed > STANDING)  # it may have come to a stand there
    return max(time, float(motion.time[moving[-1]])) if len(moving) else time


def _braked(requirement: Requirement, evidence: Evidence) -> list[float]:
    """When ego's last braking for others is over, and when it is back in its lane, where it reacts."""
    ego = evidence.motion(EGO)
    if ego is None or not requirement.values["reacts"]:
        return []
    braking = np.flatnonzero(ego.acceleration < -bounds()["phase"]["change_rate"]["value"])
    aside = np.nan_to_num(np.abs(ego.of_course("aside"))) > bounds()["phase"]["back"]["value"]
    out = np.flatnonzero(aside) if not aside[-1] else np.zeros(0, int)
    return [float(ego.time[found[-1]]) for found in (braking, out) if len(found)]


def first_event(requirement: Requirement, evidence: Evidence) -> Result:
    limits = bounds()["pace"]
    least, most = limits["first"]["value"]
    most = max(most, float(requirement.values["timed"]) + 2.0)  # type: ignore[arg-type]
    said, moments = f"within {least:g} to {most:g} s", _moments(requirement, evidence)
    begun = [onset(m, "overtake", t) for key, action, m in _seen(requirement, evidence)
             if action == "overtake" and (t := evidence.times.get(key)) is not None]  # fmt: skip
    moments = sorted([*moments, *begun, *_coming_up(requirement, evidence)])
    moments = [m for m in moments if m > 0.0] or moments  # what is so from the first is no event
    if not moments:
        return unknown(requirement, said, "not judged: none of the described events occurred")
    return scored(requirement, min(moments[0] - least, most - moments[0]), said, f"{moments[0]:.1f} s", moments[0],
                  measured=(moments[0], least, most))  # fmt: skip


def _coming_up(requirement: Requirement, evidence: Evidence) -> list[float]:
    """When those who follow another from the first begin to slow down for it."""
    comes: list[float] = []
    for motion in (m for actor in requirement.values["comes_up"] for m in evidence.motions(str(actor))):  # type: ignore
        slower = np.flatnonzero(motion.smooth < motion.smooth[0] - bounds()["phase"]["change"]["value"])
        comes += [float(motion.time[slower[0]])] if len(slower) else []
    return comes


def soon_over(requirement: Requirement, evidence: Evidence) -> Result:
    limit = bounds()["pace"]["after"]["value"] + float(requirement.values["lasting"])  # type: ignore[arg-type]
    said, moments = f"at most {limit:g} s later", _moments(requirement, evidence)
    if not moments:
        return unknown(requirement, said, "not judged: none of the described events occurred")
    after = evidence.end - _last(requirement, moments, evidence)
    return scored(requirement, (limit - after) / 2.0, said, f"{after:.1f} s later", evidence.end,
                  measured=(after, 0.0, limit))  # fmt: skip


def no_dead_time(requirement: Requirement, evidence: Evidence) -> Result:
    limit = max(bounds()["pace"]["dead"]["value"], float(requirement.values["lasting"]) + 2.0)  # type: ignore[arg-type]
    said, moments = f"at most {limit:g} s between two events", _moments(requirement, evidence)
    if not moments:
        return unknown(requirement, said, "not judged: none of the described events occurred")
    all_of = sorted({0.0, *moments, *(c.time for c in evidence.facts.contacts), *_speed_moments(evidence)})
    gap, at = max(((b - a), a) for a, b in zip(all_of, all_of[1:], strict=False)) if len(all_of) > 1 else (0.0, 0.0)
    return scored(requirement, (limit - gap) / 2.0, said, f"{gap:.1f} s", at)


def _speed_moments(evidence: Evidence) -> list[float]:
    """When somebody brakes (all the while), gains speed, turns, comes into a junction or first moves aside: not said,
    and yet something that happens."""
    limits, moving = bounds()["phase"], [m for m in evidence.everybody if m.moves]
    times = [m.time[m.acceleration < -limits["change_rate"]["value"] / 2] for m in moving]
    times += [m.time[np.abs(beside(m)) > limits["begun"]["value"]][:1] for m in moving]
    telling = ("brake", "accelerate", "stop", "turn_left", "turn_right", "cross_path", "lane_change", "yield")
    seen = [e.time for o in evidence.facts.objects for e in o.events if e.event in telling]
    seen += [s.time for m in moving for s in m.course.stays if s.kind == "junction"]
    turn = bounds()["pace"]["turns"]["value"]
    times += [m.time[1:][np.diff(np.floor((m.heading - m.heading[0]) / turn)) != 0] for m in moving]
    return [*seen, *(float(t) for some in times for t in some)]


def not_cut_short(requirement: Requirement, evidence: Evidence) -> Result:
    limit, said = bounds()["pace"]["amid"]["value"], "nobody brakes hard at the end"
    moving = [m for m in evidence.everybody if m.moves and m.contact is None and m.speed[-1] > STANDING]
    braking = [m for m in moving if float(m.acceleration[-3:].mean()) < -limit]
    seen = f"{braking[0].name} brakes" if braking else "none does"
    return scored(requirement, -1.0 if braking else 1.0, said, seen, evidence.end)


CHECKS = {
    "not_cut_short": not_cut_short, "first_event": first_event, "soon_over": soon_over, "no_dead_time": no_dead_time,
}  # fmt: skip

"""What a run must keep to all along, as T says: bounds on how somebody moves, how near it comes to whom, no contact."""

from collections.abc import Iterator

import numpy as np

from c2s_engine.require.evidence import Evidence, Motion
from c2s_engine.require.measures import HORIZON, Line, Pair
from c2s_engine.require.results import decided, scored, unknown
from c2s_engine.require.scene import Scene, bounds
from c2s_engine.structure import sentences
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.specs import Limit, RestrictionsSpec

UNITS = {"speed": "m/s", "acceleration": "m/s2", "deceleration": "m/s2", "lateral_acceleration": "m/s2",
         "jerk": "m/s3", "gap": "m", "ttc": "s"}  # fmt: skip
APART = ("gap", "ttc")
"""What is between two, rather than of one."""

TRIED = 0.3
"""m/s2 under which nobody brakes: a bound on braking says nothing of that."""


def required(scene: Scene) -> Iterator[Requirement]:
    spec = scene.structure.restrictions.spec
    assert isinstance(spec, RestrictionsSpec)
    names = {cid: o.name for cid, o in scene.objects.items()}
    for i, limit in enumerate(spec.limits):
        text = f"{sentences.limit(limit, names)}."
        check = "untouched" if limit.kind == "collision" else "apart" if limit.kind in APART else "within"
        yield scene.make("limit", check, limit.subject, f"limits.{i}", text, other=limit.other, component="T",
                         **_values(limit))  # fmt: skip


def _values(limit: Limit) -> dict[str, float | str]:
    found: dict[str, float | str] = {"measure": limit.kind}
    found |= {"least": limit.minimum} if limit.minimum is not None else {}
    return found | ({"most": limit.maximum} if limit.maximum is not None else {})


def within(requirement: Requirement, evidence: Evidence) -> Result:
    """How somebody moves, once bodies have settled to their speeds."""
    settles, series = bounds()["natural"]["settles"]["value"], []
    for motion in evidence.motions(requirement.actor):
        settled = motion.time >= settles
        series.append((_of(motion, str(requirement.values["measure"]))[settled], motion.time[settled]))
    braking = requirement.values["measure"] == "deceleration" and requirement.values.get("least") is None
    if braking and series and all(values.max(initial=0.0) < TRIED for values, _ in series):
        said = f"at most {requirement.values['most']:g} m/s2"
        return unknown(requirement, said, "not judged: it never brakes")
    return _kept(requirement, series)


def _of(motion: Motion, measure: str) -> np.ndarray:
    if measure == "speed":
        return motion.speed
    if measure == "lateral_acceleration":
        return motion.lateral
    gain = motion.acceleration
    if measure == "jerk":
        return np.abs(np.gradient(gain, motion.step)) if len(gain) > 1 else np.zeros(len(gain))
    return np.maximum(gain if measure == "acceleration" else -gain, 0.0)


def apart(requirement: Requirement, evidence: Evidence) -> Result:
    """How near one comes to another, or to anybody else."""
    mine = {o.name for o in evidence.members(requirement.actor)}
    others = {o.name for o in evidence.members(requirement.other)} if requirement.other else \
        {o.name for o in evidence.facts.objects} - mine  # fmt: skip
    tracks = evidence.trajectories.tracks
    series = []
    for one in (t for t in tracks if t.name in mine and t.x):
        for other in (t for t in tracks if t.name in others and t.x):
            pair = Pair(evidence.step, one, other, Line(one))
            values = pair.gap if requirement.values["measure"] == "gap" else np.minimum(pair.ttc, HORIZON)
            series.append((values, np.arange(len(values)) * evidence.step))
    return _kept(requirement, series)


def _kept(requirement: Requirement, series: list[tuple[np.ndarray, np.ndarray]]) -> Result:
    """What of the values (with their times, s) comes nearest to, or farthest over, a bound."""
    unit, most = UNITS[str(requirement.values["measure"])], requirement.values.get("most")
    least = requirement.values.get("least")
    parts = [f"at least {least:g}"] if least is not None else []
    said = f"{' and '.join([*parts, *([f'at most {most:g}'] if most is not None else [])])} {unit}"
    worst: tuple[float, float, float] | None = None
    share = bounds()["limit"]["share"]["value"]
    for values, times in series:
        for bound, sign, at in ((most, 1, values.argmax() if len(values) else 0),
                                (least, -1, values.argmin() if len(values) else 0)):  # fmt: skip
            if bound is None or not len(values):
                continue
            room = max(abs(float(bound)), 0.1)  # type: ignore[arg-type]
            margin = (sign * (float(bound) - float(values[at])) + share * room) / (0.25 * room)  # type: ignore[arg-type]
            if worst is None or margin < worst[0]:
                worst = (margin, float(values[at]), float(times[at]))
    if worst is None:
        return unknown(requirement, said, "not judged: the actor it applies to is missing from the run")
    margin, value, time = worst
    measured = None if most is None else (value, float(least or 0), float(most))  # type: ignore[arg-type]
    return scored(requirement, margin, said, f"{value:.1f} {unit}", time, measured=measured)


def untouched(requirement: Requirement, evidence: Evidence) -> Result:
    """That one touches neither the other nor, where none is named, anybody."""
    if not evidence.members(requirement.actor):
        return unknown(requirement, "no contact", "not judged: it is missing from the run")
    for contact in evidence.facts.contacts:
        who = {evidence.components.get(contact.one), evidence.components.get(contact.other)}
        if requirement.actor in who and requirement.other in (None, *who):
            return decided(requirement, False, "no contact", f"{contact.one} and {contact.other} collide", contact.time)
    return decided(requirement, True, "no contact", "none")


CHECKS = {"within": within, "apart": apart, "untouched": untouched}

"""The measures of one run from its tracks."""

from itertools import combinations
from typing import Any

import numpy as np

from c2s_engine.require.evidence import STANDING, Evidence, Motion
from c2s_engine.require.measures import Line, Pair, pairs
from c2s_engine.structure.facts import EGO, RunFacts, Trajectories
from c2s_engine.structure.measures import ActorMeasures, Measures, PairMeasures

MANY = 8
"""Others than ego of whom every two are measured."""
SETTLED = 0.5
"""s after the start from which on speeds count: until then bodies are given their speeds."""


def measured(facts: RunFacts, ways: Trajectories) -> Measures:
    """Ego and each other, two others of whom one moves, and each actor that moves, in the run's order."""
    moving = [m for m in Evidence(facts, ways).everybody if m.moves]
    return Measures(
        pairs=tuple(extremes(p) for p in pairs(ways)), others=_of_others(ways, {m.name for m in moving}),
        actors=tuple(_actor(m) for m in moving),
    )  # fmt: skip


def _of_others(ways: Trajectories, moving: set[str]) -> tuple[PairMeasures, ...]:
    """Of two others than ego their gap and their time to collision; of long rows and crowds none."""
    tracks = [t for t in ways.tracks if t.name != EGO and t.x]
    if len(tracks) > MANY:
        return ()
    two = [(a, b) for a, b in combinations(tracks, 2) if {a.name, b.name} & moving]
    return tuple(_nearest(Pair(ways.step, a, b, Line(a))) for a, b in two)


def _nearest(pair: Pair) -> PairMeasures:
    """The smallest gap of a pair and its smallest time to collision."""
    least: dict[str, Any] = {"gap_m": round(float(pair.gap.min()), 2)}
    least["gap_at_s"] = round(int(np.argmin(pair.gap)) * pair.step, 2)
    soonest = int(np.argmin(pair.ttc))
    if np.isfinite(pair.ttc[soonest]):
        least |= {"ttc_s": round(float(pair.ttc[soonest]), 2), "ttc_at_s": round(soonest * pair.step, 2)}
    return PairMeasures(one=pair.ego.name, other=pair.other.name, **least)


def extremes(pair: Pair) -> PairMeasures:
    """The smallest values of a run."""
    ttc, required, gap = pair.ttc, pair.required, pair.gap
    worst, hardest, nearest = int(np.argmin(ttc)), int(np.argmax(required)), int(np.argmin(gap))
    some, found = bool(np.isfinite(ttc[worst])), pair.pet
    return PairMeasures(
        other=pair.other.name,
        gap_m=round(float(gap[nearest]), 2),
        gap_at_s=round(nearest * pair.step, 2),
        ttc_s=round(float(ttc[worst]), 2) if some else None,
        ttc_at_s=round(worst * pair.step, 2) if some else None,
        pet_s=round(found[0], 2) if found else None,
        pet_at_s=round(found[1], 2) if found else None,
        required_deceleration_mps2=round(float(required[hardest]), 2),
        required_deceleration_at_s=round(hardest * pair.step, 2) if required[hardest] > 0 else None,
    )


def gaps(ways: Trajectories) -> dict[str, list[float]]:
    """By each other's name, m between its box and ego's at each step."""
    return {p.other.name: [round(float(g), 2) for g in p.gap] for p in pairs(ways)}


def _actor(motion: Motion) -> ActorMeasures:
    first = min(len(motion.speed) - 1, round(SETTLED / motion.step))
    speed, braking = motion.speed[first:], -motion.acceleration[first:]
    slow, hard = int(np.argmin(speed)), int(np.argmax(braking))
    standing = np.flatnonzero((speed < STANDING) & (np.maximum.accumulate(speed) > 1.0))
    return ActorMeasures(
        name=motion.name,
        fastest=round(float(speed.max()), 2),
        slowest=round(float(speed[slow]), 2),
        slowest_at_s=round((first + slow) * motion.step, 2),
        braking=round(max(0.0, float(braking[hard])), 2),
        braking_at_s=round((first + hard) * motion.step, 2),
        stands_at_s=round((first + int(standing[0])) * motion.step, 2) if len(standing) else None,
    )

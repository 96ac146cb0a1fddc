"""The decisive moments of a run: what a picture is drawn of."""

from dataclasses import dataclass

import numpy as np

from c2s_engine.require import shown_by
from c2s_engine.require.measures import Pair, pairs
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import EGO, RunFacts, Trajectories
from c2s_engine.structure.specs import EgoSpec, ObjectSpec

NEAR = 0.25
"""s: moments closer than that are one."""
UNDER_WAY = 0.3
"""s: by then every actor has the speed that it starts with."""
UNEVENTFUL = ("keep_lane", "approach", "follow", "stationary", "passes_first")
REACTIONS = ("brake", "brake_hard", "swerve", "lane_change_left", "lane_change_right", "stop")


@dataclass(frozen=True)
class Moment:
    """A time of the run (s) with what makes it decisive."""

    time: float
    what: str


def moments(structure: Structure, facts: RunFacts, ways: Trajectories) -> list[Moment]:
    """Start, first said event, ego's first reaction, closest approach, contact, end; those that coincide are one."""
    last = (len(ways.tracks[0].x) - 1) * ways.step if ways.tracks else 0.0
    found = [Moment(min(UNDER_WAY, last), "start")]
    said = _said(structure)
    events = sorted((e.time, o.name, e.event, e.other or "") for o in facts.objects for e in o.events if e.time > 0)
    told = [e for e in events if e[2] in said] or [e for e in events if e[2] not in UNEVENTFUL]
    if told:
        found.append(Moment(told[0][0], f"first event: {_words(told[0])}"))
    if reacted := [e for e in events if e[1] == EGO and e[2] in REACTIONS]:
        found.append(Moment(reacted[0][0], _words(reacted[0])))
    if touched := [e for e in events if e[2] == "hits"]:
        found.append(Moment(touched[0][0], _words(touched[0])))
    if nearest := closest(facts, ways):
        pair, at = nearest
        gap = f"{pair.gap[at]:.1f} m between ego and {pair.other.name}"
        found.append(Moment(at * ways.step, f"closest approach: {gap}"))
    found.append(Moment(last, "end"))
    return _apart([m for m in found if m.time <= last + 1e-6])


def closest(facts: RunFacts, ways: Trajectories) -> tuple[Pair, int] | None:
    """Ego and whom it comes nearest to, with the step; those that move or stand on the road before things beside it."""
    moving = {o.name for o in facts.objects if o.moves}
    known = pairs(ways)
    chosen = [p for p in known if p.other.name in moving] or [p for p in known if p.other.kind != "prop"] or known
    if not chosen:
        return None
    pair = min(chosen, key=lambda p: float(p.gap.min()))
    return pair, int(np.argmin(pair.gap))


def _said(structure: Structure) -> set[str]:
    """The events that show what S says of others and of ego."""
    specs = [c.spec for c in structure.components if isinstance(c.spec, EgoSpec | ObjectSpec)]
    actions = {p.action for s in specs for p in s.phases}
    return {e for a in actions for e in shown_by(a)} - {"keep_lane", "stationary", "follow"}


def _words(event: tuple[float, str, str, str]) -> str:
    _, who, what, other = event
    return f"{who} {what.replace('_', ' ')}{' ' + other if other else ''}"


def _apart(found: list[Moment]) -> list[Moment]:
    kept: list[Moment] = []
    for moment in sorted(found, key=lambda m: m.time):
        if kept and moment.time - kept[-1].time < NEAR:
            kept[-1] = Moment(kept[-1].time, f"{kept[-1].what}; {moment.what}")
        else:
            kept.append(moment)
    return kept

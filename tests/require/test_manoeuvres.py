"""How what leads out of the lane ends: each requirement by a run that shows it and one that just does not."""

from typing import Any

import numpy as np
import pytest
from roads import Actor, Scene, event, ramp
from test_both_sides import ego, other, s, verdict

from c2s_engine.structure.components import Structure
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Placement, Trigger

PASSES = (event("overtake", 6.0, "other"),)
FAST = ramp((0, 14), (12, 14))
OUT = ramp((0, 0), (2, 0), (4, -3.5), (7, -3.5))
BACK = ramp((0, 0), (2, 0), (4, -3.5), (8, -3.5), (10, 0), (12, 0))


def overtaking(**values: Any) -> Structure:
    slow = ObjectSpec(placement=Placement(position="ahead"))
    return s(slow, ego=EgoSpec(phases=(Phase(action="overtake", target="O1", **values),)))


def passer(x: np.ndarray, speed: Any = FAST, events: tuple = PASSES) -> Scene:
    return Scene([ego(x=x, speed=speed, events=events), other(speed=8.0, y=20.0)])


def skidder(turned: float, last: float) -> Scene:
    slides = {
        "x": ramp((0, 0), (3, 0), (5, -1.8), (12, -1.8)),
        "heading": ramp((0, 0), (3.5, 0), (5, turned), (12, turned)),
        "speed": ramp((0, 10), (3, 10), (5, last), (12, last)),
    }
    return Scene([ego(), other(events=(event("skid", 4.0),), **slides)])


ABANDONED = overtaking(abandoned=True)
STAYS_OUT = ramp((0, 0), (2, 0), (4, -2.0), (12, -2.0))
BRIEFLY = ramp((0, 0), (2, 0), (4, -2.0), (6, -2.0), (8, 0), (12, 0))
SLIDES = s(ObjectSpec(phases=(Phase(action="lose_control", side="left"), Phase(action="stop"))))
HARD = s(ObjectSpec(phases=(Phase(action="stop"),)), ego=EgoSpec(reaction="brake", hard=True))
RIDER = ObjectSpec(type="bicycle", phases=(Phase(
    action="swerve", side="left", trigger=Trigger(kind="action", of="ego", action="overtake")),))  # fmt: skip
PASSED = s(RIDER, ego=EgoSpec(phases=(Phase(action="overtake", target="O1"),)))


def swerves_at(y: float) -> Scene:
    aside = {"x": ramp((0, 0), (5, 0), (6, -1.1), (8, 0), (12, 0)), "events": (event("swerve", 7.8),)}
    rider = Actor("other", "O1", y=y, speed=8.0, kind="bicycle", **aside)
    return Scene([ego(x=-2.8, speed=FAST, events=PASSES), rider])


TWICE = s(ObjectSpec(phases=(Phase(action="swerve", side="left"), Phase(action="swerve", side="right"))))
SWERVES = (0, 0), (1, 0), (2, -1.5), (4, 0), (5, 0), (6, 1.5), (8, 0), (12, 0)
SWERVED = (event("swerve", 3.6),)
TWO_OVER = s(ObjectSpec(phases=(Phase(action="lane_change"), Phase(action="lane_change"))))
ONE, TWO = event("lane_change", 3.0), event("lane_change", 7.0)


BEHIND = s(ObjectSpec(placement=Placement(position="ahead")), ego=EgoSpec(reaction="brake"))
ONCE = ramp((0, 10), (2, 10), (4, 5.5), (6, 8.5), (12, 7.5))
AGAIN = ramp((0, 10), (2, 10), (3, 5.5), (4, 8.5), (5, 5.5), (6, 8.5), (7, 5.5), (12, 6))
WITH_IT = ramp((0, 10), (1, 10), (2, 5.5), (3, 8.5), (4, 5.5), (5, 8.5), (6, 5.5), (12, 6))
CASES = {
    "no surging": ("E.smooth", BEHIND, Scene([ego(speed=ONCE), other(speed=7.0)]),
                   Scene([ego(speed=AGAIN), other(speed=7.0)])),
    "no surging but with who is ahead": ("E.smooth", BEHIND, Scene([ego(speed=AGAIN), other(speed=WITH_IT)]),
                                         Scene([ego(speed=AGAIN), other(speed=7.0)])),
    "back in its lane": ("E.phases.0.back", overtaking(), passer(BACK), passer(OUT)),
    "back with a gap": ("E.phases.0.gap", overtaking(gap=30.0), passer(BACK), passer(BACK, 12.0)),
    "broken off": ("E.phases.0.abandoned", ABANDONED, passer(BRIEFLY, 8.0), passer(BRIEFLY, FAST)),
    "broken off and back": ("E.phases.0.abandoned", ABANDONED, passer(BRIEFLY, 8.0), passer(STAYS_OUT, 8.0)),
    "slides to a stand": ("O1.phases.0.ends", SLIDES, skidder(0.6, 0.0), skidder(0.6, 3.0)),
    "at an angle": ("O1.phases.0.ends", SLIDES, skidder(0.2, 0.0), skidder(0.1, 0.0)),
    "swerves again": ("O1.phases.1.swerve", TWICE, Scene([ego(), other(x=ramp(*SWERVES), events=SWERVED)]),
                      Scene([ego(), other(x=ramp(*SWERVES[:4], SWERVES[-1]), events=SWERVED)])),
    "swerves to the other side": ("O1.phases.1.side", TWICE, Scene([ego(), other(x=ramp(*SWERVES), events=SWERVED)]),
                                  Scene([ego(), other(x=ramp(*((t, -abs(x)) for t, x in SWERVES)), events=SWERVED)])),
    "changes lanes again": ("O1.phases.1.lane_change", TWO_OVER, Scene([ego(), other(events=(ONE, TWO))]),
                            Scene([ego(), other(events=(ONE,))])),
    "alongside": ("O1.phases.0.awaits", PASSED, swerves_at(34.0), swerves_at(44.0)),
    "as in an emergency": (
        "E.hard", HARD, Scene([ego(speed=ramp((0, 10), (4, 10), (6, 0), (12, 0))), other()]),
        Scene([ego(speed=ramp((0, 10), (4, 10), (7, 0), (12, 0))), other()]),
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_run_that_shows_it_and_one_that_just_does_not(case) -> None:
    requirement, structure, shows, misses = CASES[case]
    assert verdict(structure, shows, requirement) is True
    assert verdict(structure, misses, requirement) is False


def test_who_passes_in_the_next_lane_or_hits_the_other_need_not_come_back() -> None:
    from c2s_engine.require import require

    beside = s(ObjectSpec(placement=Placement(position="left_lane")),
               ego=EgoSpec(phases=(Phase(action="overtake", target="O1"),)))  # fmt: skip
    phases = (Phase(action="overtake", target="O1"), Phase(action="collide", target="O1"))
    hits = s(ObjectSpec(), ego=EgoSpec(phases=phases))
    for structure in (beside, hits):
        assert "E.phases.0.back" not in {r.id for r in require(structure)}

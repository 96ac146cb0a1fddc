"""Who may be meant with a speed: who is named before it, whom its own words name, who meets one that stands."""

import re

from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity

OWN_SPEED = re.compile(
    r"\b(?P<whose>\w+)(?: 's)? (?:speed|velocity|pace)(?: (?:is|was|of|at|about|around|constant))*\s*[:=,]?\s*$"
)
"""Whose speed is named right before it: "pedestrian speed 5 km/h", "walking speed: 5 km/h"."""
ON_FOOT = frozenset(("walking", "running", "crossing"))


def named_before(scene: Scene, span: Span) -> list[Entity]:
    """Those who are named before a speed, in their order."""
    return [scene.cast.of[i] for i in sorted(scene.cast.of) if scene.words[i].start < span.start]


def explicit_owner(scene: Scene, near: str) -> Entity | None:
    """Whose speed the words right before it name, as a noun of somebody's or as that of a walk."""
    said = OWN_SPEED.search(near)
    if said is None:
        return None
    if said["whose"] in ON_FOOT:
        return next((e for e in reversed(scene.actors) if e.person), None)
    named = [e for e in scene.actors if e.noun == said["whose"]]
    return named[-1] if len(named) == 1 else None

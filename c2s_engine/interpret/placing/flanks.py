"""From which side one comes at a junction, by whose flank was struck: "its front hit the passenger side of V1"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.interpret.who.mentions import Entity

SIDES = {"driver 's": "left", "driver": "left", "drivers": "left", "passenger": "right", "passenger 's": "right"}
FLANK = "|".join(sorted(language.words("flanks"), key=len, reverse=True))
SIDE = r"(?P<side>left|right|driver 's|drivers?|passenger(?: 's)?)(?:[- ]hand)?"
PART = rf"(?:front |rear |near |back )?(?:{FLANK})\b"
STRUCK = (
    re.compile(rf"@(?P<of>\w+) 's (?:\w+ )?{SIDE} {PART}"),
    re.compile(rf"\b{SIDE} {PART} of (?:the )?@(?P<of>\w+)"),
    re.compile(rf"\b(?:on|in|into|at|to) (?:its|the|his|her|their) {SIDE} {PART}"),
    re.compile(r"\bfrom (?:the |its |his |her )?(?P<side>left|right)(?: (?:hand )?side)?\b(?! (?:lane|turn))"),
)


def comes_from(scene: Scene, entity: Entity) -> str | None:
    """The side from which one comes across ego's way, by a collision with ego: who strikes ego's right flank comes from
    the right; so does he whose left flank ego strikes."""
    for hit in scene.clauses.events:
        if hit.act == "collide" and hit.done and {hit.agent, hit.patient} == {entity, scene.cast.ego}:
            found = _struck(hit)
            if found is not None:
                return found
    return None


def _struck(hit: Event) -> str | None:
    for pattern in STRUCK:
        told = pattern.search(hit.whole)
        if told is None:
            continue
        side = SIDES.get(told["side"], told["side"])
        owner = told.groupdict().get("of") or (hit.patient.key if hit.patient is not None else "")
        return side if owner == "ego" else OPPOSITE[side]
    return None

"""Compass directions of two vehicles: which way one comes from, seen from the other."""

import re

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.bearings import COMPASS, heading
from c2s_engine.interpret.who.mentions import Entity


def compass(scene: Scene, entity: Entity) -> str | None:
    """left, right (coming from there), opposite or same, by the compass directions of ego and the other."""
    own, other = heading(scene.clauses, scene.cast.ego), heading(scene.clauses, entity)
    led = next((e.patient for e in scene.events(scene.cast.ego) if e.act == "follow"), None)
    if own is None and led is not None and led is not entity:
        own = heading(scene.clauses, led)  # ego drives behind it
    if own is None or other is None:
        return None
    return {0: "same", 90: "left", 180: "opposite", 270: "right"}[(other - own) % 360]


STANDS = re.compile(
    r"\b(?:on|at|along|in|from|by|near|off) (?:the )?(?P<way>north|south|east|west)(?P<bound>bound)?(?:ern)? "
    r"(?:side|edge|shoulder|curb|kerb|verge|sidewalk|pavement|footpath|roadside)\b"
)


def roadside(scene: Scene, text: str) -> str | None:
    """The side of the road, seen from ego, that a text names by the compass, or by who drives there: "on the west
    side", "on the northbound side"."""
    match, own = STANDS.search(text), heading(scene.clauses, scene.cast.ego)
    if match is None or own is None:
        return None
    turned = (COMPASS[match["way"]] - own) % 360
    return ({0: "right", 180: "left"} if match["bound"] else {90: "right", 270: "left"}).get(turned)

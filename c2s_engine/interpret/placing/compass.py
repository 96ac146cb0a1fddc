"""Compass directions of two vehicles: which way one comes from, seen from the other."""

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.bearings import heading
from c2s_engine.interpret.who.mentions import Entity


def compass(scene: Scene, entity: Entity) -> str | None:
    """left, right (coming from there), opposite or same, by the compass directions of ego and the other."""
    own, other = heading(scene.clauses, scene.cast.ego), heading(scene.clauses, entity)
    if own is None or other is None:
        return None
    return {0: "same", 90: "left", 180: "opposite", 270: "right"}[(other - own) % 360]

"""Who is in another arm of a junction, and who waits beside ego."""

import re

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity

BY_ITS_SIDE = re.compile(
    r"\bto (?:the )?@ego 's (?:immediate )?(?:left|right)\b|\bto the (?:left|right) of (?:the )?@ego\b"
)


def waits_beside(scene: Scene, entity: Entity, told: str) -> bool:
    """Whether one on one side of ego at a junction goes ego's way or stands there, for all that is told."""
    if not {e.act for e in scene.events(entity)} <= {"travel", "stationary", "go_straight"}:
        return False
    scene.events(scene.cast.ego)
    return BY_ITS_SIDE.search(told) is not None


def in_another_arm(scene: Scene, entity: Entity) -> bool:
    """Whether one that is told to be on one side of ego, and in no lane, is in another arm of the junction."""
    where = scene.where(entity)
    told = " ".join(t for _, t in where.phrases)
    there = where.lane in ("left", "right") and where.rel is None and "lane" not in told
    return there and not waits_beside(scene, entity, told)

"""Where along the road one is or comes to be, seen from ego."""

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene


def position_text(scene: Scene, entity: Entity) -> str:
    """What is said of one's place, and the clauses of what it does."""
    return " ; ".join([*(t for _, t in scene.where(entity).phrases), *(e.whole for e in scene.events(entity))])


def along_of(rel: str | None) -> str:
    return {"ahead": "ahead", "behind": "behind", "beside": "abreast"}.get(rel or "", "ahead")


def at_edge(scene: Scene, entity: Entity) -> bool:
    """Whether a cyclist on one side rides along the road's edge: nothing says that it has a lane of its own there."""
    where = scene.where(entity)
    return entity.type == "bicycle" and not any("lane" in text for _, text in where.phrases)


def passes_ego(scene: Scene, entity: Entity) -> bool:
    return any(e.act == "overtake" and (e.patient is None or e.patient.ego) for e in scene.events(entity))


CIRCULATES = re.compile(
    r"\b(circulat\w+|circl(?:e|es|ed|ing)\b"
    r"|(go|goes|going|drive|drives|driving|come|comes|coming|ride|riding|cycle|cycling|travelling) "
    r"(a)?round\b|already (in|on|inside)\b|(in|inside|on) the (roundabout|circle|ring|circulatory \w+)\b)"
)
OWN_LANE = re.compile(
    r"(?<!into )(?<!onto )(?<!into the )(?:@ego 's (\w+ )?lane|(same|ego|own|its|@ego) lane|lane of (the )?@ego)"
    r"|same lane as"
)


def wrong_way(scene: Scene, entity: Entity) -> bool:
    """Whether one drives the wrong way in a lane of ego's direction: on a motorway, or in ego's own lane."""
    where = scene.where(entity)
    if not entity.mover or entity.person:
        return False
    divided = scene.road.kind == "motorway" or scene.road.oncoming is False
    own = [t for _, t in where.phrases] + [e.whole for e in scene.events(entity)]
    if where.lane == "oncoming" and any(OWN_LANE.search(t) for t in _met_there(scene, entity)):
        return True
    comes = where.lane == "oncoming" and divided and any(OWN_LANE.search(text) for text in own)
    if comes:
        return True
    if where.facing != "against":
        return False
    if scene.road.kind == "motorway" or scene.road.ramp or where.lane in ("same", "left", "right"):
        return True
    return any(OWN_LANE.search(text) for text in own)


COMES_TO_BE = frozenset(("overtake", "oncoming", "lane_change", "drift", "swerve", "cut_in", "lose_control"))
"""What brings one into ego's lane that was not there before."""


def _met_there(scene: Scene, entity: Entity) -> list[str]:
    """What tells in which lane ego meets one, or one comes towards it, who did not get there before ego's eyes."""
    if any(e.act in COMES_TO_BE for e in scene.events(entity)):
        return []
    met = [e.whole for e in scene.events(scene.cast.ego) if e.patient is entity and e.act in ("approach", "yield")]
    return [*met, *(e.whole for e in scene.events(entity) if e.act in ("approach", "travel", "stationary"))]


def along_from_events(scene: Scene, entity: Entity) -> str | None:
    """Where along the road one in another lane is, by what happens: behind where it gains, beside where ego hits it
    while it changes lanes."""
    if passes_ego(scene, entity):
        return "behind"
    own = scene.events(scene.cast.ego)
    changed = next((e for e in own if e.act == "lane_change"), None)
    hit = next((e for e in own if e.act == "collide" and e.patient is entity), None)
    return "beside" if changed is not None and hit is not None and changed.order < hit.order else None

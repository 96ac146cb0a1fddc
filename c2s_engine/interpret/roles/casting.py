"""Which of those spoken of belong to the scene."""

from c2s_engine.interpret import language
from c2s_engine.interpret.roles.only_named import mentioned_alone
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import VEHICLES, ZONES, Entity


def actors(scene: Scene) -> list[Entity]:
    """The entities that belong to the scene: those that do something, are somewhere, or have something done to them."""
    kept = []
    _traffic_named(scene)
    for entity in scene.cast.entities:
        own = scene.events(entity)
        where = scene.where(entity)
        passive = [e for e in scene.clauses.events if e.patient is entity and (e.done)]
        if "group" in entity.roles:
            continue
        if entity.mover and any(e.done and e.trigger and e.trigger.get("of") is entity for e in scene.clauses.events):
            kept.append(entity)
            continue
        flew = all(e.act == "collide" and e.patient is not scene.cast.ego for e in own)
        if entity.type == "debris" and own and flew and where.open:
            continue  # "Unit 3 was hit by debris"
        if entity.noun in ("somebody", "someone") and not own and not passive and where.rel is None:
            continue
        if entity.noun in language.table("actors")["fixed"] and not any(e.act == "collide" for e in passive):
            continue
        if (
            entity.label
            and len(scene.cast.entities) <= 6
            and (len(scene.cast.entities) == 1 or own or passive or where.rel or where.lane or entity.roles)
        ):
            kept.append(entity)
            continue
        if entity.mover and where.hidden_by is not None:
            kept.append(entity)
            continue
        if (
            not own
            and not passive
            and not entity.roles - {"adversary"}
            and where.rel is None
            and where.lane is None
            and not mentioned_alone(scene, entity)
        ):
            continue
        if entity.noun == "traffic" and any(
            e is not entity and (e.roles & entity.roles or scene.where(e).lane == where.lane is not None)
            for e in scene.cast.entities
        ):
            continue
        if (
            not own
            and entity.type in ("vehicle", "pedestrian")
            and entity.count > 1
            and where.rel is None
            and where.lane is None
            and not (entity.person and scene.road.crosswalk)
            and "parked" not in entity.roles
        ):
            continue
        only_denied = [e for e in scene.clauses.events if e.agent is entity or e.patient is entity]
        if (
            only_denied
            and not own
            and not passive
            and where.rel is None
            and where.lane is None
            and not entity.roles
            and entity.type not in ZONES
        ):
            continue
        kept.append(entity)
    for entity in list(kept):
        blocker = scene.where(entity).hidden_by
        if blocker is not None and blocker not in kept:
            if not scene.events(blocker):
                blocker.roles.add("stationary")
            kept.append(blocker)
    generic = [
        e
        for e in kept
        if e.noun
        in (
            "obstacle",
            "obstruction",
            "hazard",
            "object",
            "obstacles",
            "objects",
            "hazards",
            "road user",
            "blockage",
            "stationary object",
            "vehicle",
            "vehicles",
            "road users",
            "actor",
            "obstacle vehicle",
        )
    ]
    for entity in generic:
        specific = [
            e
            for e in kept
            if e is not entity and (e.type != "vehicle" or entity.noun != "vehicle") and e not in generic
        ]
        same = [e for e in specific if entity.type == "obstacle" or e.type in VEHICLES]
        if (
            same
            and "oncoming" not in entity.roles
            and not [e for e in scene.events(entity) if e.act not in ("travel", "approach", "stationary")]
            and (entity.type == "obstacle" or entity.count > 1)
        ):
            kept.remove(entity)
    return kept


def _traffic_named(scene: Scene) -> None:
    """One that ego waits for, where oncoming traffic was spoken of, is that traffic."""
    traffic = next((e for e in scene.cast.entities if e.noun == "traffic" and "oncoming" in e.roles), None)
    waits = [e for e in scene.clauses.events if e.agent.ego and e.act == "yield" and e.done]
    for other in [e.patient for e in waits] if traffic is not None else ():
        if other is None or other is traffic or other.person or not other.mover:
            continue
        where = scene.where(other)
        if where.lane is None and where.rel is None:
            where.lane = "oncoming"

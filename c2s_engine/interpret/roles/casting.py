"""Which of those spoken of belong to the scene."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.roles.only_named import mentioned_alone, seen
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.where.concealed import FIXED
from c2s_engine.interpret.who.mentions import VEHICLES, ZONES, Entity

HIDE = ("wall", "hedge", "billboard", "building")
"""Of what stands beside the road, that whose side is told for what it hides."""
TREES = frozenset(("tree", "trees"))
SCREENS = FIXED | TREES | {"hedges", "bushes"}
SAYS = language.words("says")


def _stands_aside(scene: Scene, entity: Entity, blocker: Entity) -> None:
    """What grows or was built beside the road stands there, on the side from which comes whom it hides."""
    if blocker.type not in HIDE:
        blocker.type, blocker.typed = "tree" if blocker.noun in TREES else "obstacle", True
    where = scene.where(blocker)
    if where.lane in (None, "same", "left", "right") and where.gap is None:
        where.lane, where.rel = "roadside", None
        where.side = where.side or scene.where(entity).side


def _tried(event: Event) -> bool:
    """Whether ego means to overtake and does not, or avoids to hit somebody: who is ahead is there all the same."""
    avoided = event.act == "collide" and event.mode == "negated"
    avoided = avoided and (
        event.adverbial == "before" or re.search(r"\b(?:avoid|miss|prevent|not to|to not)", event.whole) is not None
    )
    return event.agent.ego and (event.act == "overtake" and event.mode == "hypothetical" or bool(avoided))


def actors(scene: Scene) -> list[Entity]:
    """The entities that belong to the scene: those that do something, are somewhere, or have something done to them."""
    kept = []
    _traffic_named(scene)
    for entity in scene.cast.entities:
        own = scene.events(entity)
        where = scene.where(entity)
        passive = [e for e in scene.clauses.events if e.patient is entity and (e.done or _tried(e))
                   and (entity.mover or e.act != "travel")]  # what is carried is not on the road  # fmt: skip
        if "group" in entity.roles or _title_only(scene, entity):
            continue
        flew = all(e.act == "collide" and e.patient is not scene.cast.ego for e in own)
        if entity.type == "debris" and own and flew and where.open:
            continue  # "Unit 3 was hit by debris"
        if entity.noun in ("somebody", "someone") and not own and not passive and where.rel is None:
            continue
        struck = any(e.act == "collide" for e in passive)
        screens = entity.type in HIDE and where.side is not None and not struck
        if entity.noun in FIXED and not screens and not struck:
            continue
        if screens:
            _stands_aside(scene, entity, entity)
        if (
            entity.label
            and len(scene.cast.entities) <= 6
            and (len(scene.cast.entities) == 1 or own or passive or where.rel or where.lane or entity.roles)
            or (entity.person or entity.type in ("bicycle", "motorcycle"))
            and entity.noun not in ("somebody", "someone", "people")
            and seen(scene, entity)
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
        if blocker is not None and blocker.noun in SCREENS:
            _stands_aside(scene, entity, blocker)
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


OFF = re.compile(r"\b(?:off|out|up|down|on|alight|board)\b")


def _title_only(scene: Scene, entity: Entity) -> bool:
    """Whether one is only named in a title, whose part another has in what the text then tells: "Cut-in by a slower
    vehicle. ... a passenger car begins a lane change"."""
    last = _title_ends(scene)
    first = entity.mentions[0].word if entity.mentions else 0
    if (
        last is None
        or first > last
        or not entity.mover
        or scene.words[first].dep == "nsubj"
        and scene.words[first].head > last  # "car on the right: pulls out"
        or any(m.word > last and m.kind != "pronoun" for m in entity.mentions)
        or first < 3
        and scene.words[last].norm == ":"
        and any(e.agent is entity and e.done and last < e.word < last + 9 for e in scene.clauses.events)
    ):  # "car in front: emergency braking"
        return False
    where = scene.where(entity)
    kinds = VEHICLES if entity.type == "vehicle" else {entity.type}
    others = [e for e in (scene.cast.ego, *scene.cast.entities) if e is not entity and e.mentions]
    later = [e for e in others if e.mentions[-1].word > last and (e.type in kinds or e.type == entity.type)]
    done = {e.act for e in scene.clauses.events if e.word > last}
    own = {e.act for e in scene.clauses.events if e.agent is entity}
    there = (where.lane, where.side) if where.lane is not None and where.gap is None else None
    again = any((scene.where(e).lane, scene.where(e).side) == there for e in later)
    open_still = where.open and where.side is None and where.gap is None or again or scene.words[last].norm == ":"
    return bool(later) and open_still and own <= done | {"travel"}


def _title_ends(scene: Scene) -> int | None:
    """The last word of a title without a finite verb and without numbers, if the text has one."""
    title = [w for w in scene.words if w.sentence == 0]
    colon = next((w.i for w in title[:14] if w.norm == ":"), None)
    title = title[: colon + 1] if colon is not None else title
    if len(title) == len(scene.words) or not 1 < len(title) <= 14 or title[-1].norm not in (".", ":"):
        return None
    told = any(w.tag in ("VBZ", "VBD", "VBP", "MD") or w.span and w.span.kind in ("quantity", "ego") for w in title)
    return None if told else title[-1].i


def _traffic_named(scene: Scene) -> None:
    """One that ego waits for, where oncoming traffic was spoken of, is that traffic."""
    traffic = next((e for e in scene.cast.entities if e.noun == "traffic" and "oncoming" in e.roles), None)
    waits = [e for e in scene.clauses.events if e.agent.ego and e.act == "yield" and e.done]
    for other in [e.patient for e in waits] if traffic is not None else ():
        if other is None or other is traffic or other.person or not other.mover:
            continue
        scene.where(other)

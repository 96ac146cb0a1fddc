"""Which of those spoken of belong to the scene."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.roles.only_named import imagined, mentioned_alone, put_there, seen
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import VEHICLES, ZONES, Entity

SCREENS = frozenset(language.table("actors")["fixed"]) | {"tree", "trees", "hedges", "bushes"}
SAYS = language.words("says")


def _stands_aside(scene: Scene, entity: Entity, blocker: Entity) -> None:
    """What grows or was built beside the road stands there, on the side from which comes whom it hides."""
    blocker.type, blocker.typed = "obstacle", True
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
        passive = [e for e in scene.clauses.events if e.patient is entity and (e.done or _tried(e))]
        if "group" in entity.roles or _mere_background(scene, entity) or _title_only(scene, entity):
            continue
        if imagined(scene, entity):
            continue
        if entity.mover and any(e.done and e.trigger and e.trigger.get("of") is entity for e in scene.clauses.events):
            kept.append(entity)
            continue
        if not own and not passive and where.rel is None and where.lane is None and _only_spoken_of(scene, entity):
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
            and not put_there(scene, entity)
        ):
            continue
        if entity.noun == "traffic" and any(
            e is not entity and (e.roles & entity.roles or scene.where(e).lane == where.lane is not None)
            for e in scene.cast.entities
        ):
            continue
        if entity.noun == "traffic" and not entity.roles and where.lane in (None, "same") and _led(scene, entity):
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
            _pass_on(scene, entity, [e for e in same if e.mentions[0].word > entity.mentions[0].word])
    return kept


HURT = re.compile(
    r"\b(?:injur|hurt\b|complain|kill|wound|unharmed|unhurt|uninjured|hospital|witness|interview|died|fatal|treated|dead\b)"
)
BROUGHT = ("take", "rush", "airlift", "transport", "fly", "bring", "convey")
OFF = re.compile(r"\b(?:off|out|up|down|on|alight|board)\b")
LET_OFF = re.compile(r"(?:let|allow|pick|drop|set|discharg|collect|unload|deliver|board|alight)\w*$")


def _only_spoken_of(scene: Scene, entity: Entity) -> bool:
    """Whether people are only said to be hurt, to have said something, or to be in a vehicle."""
    if not entity.person or entity.type == "animal":
        return False
    verbs = [scene.words[scene.words[m.word].head] for m in entity.mentions]
    for mention, verb in zip(entity.mentions, verbs, strict=True):
        clause = " ".join(w.norm for w in scene.words[mention.word : mention.word + 8] if w.sentence == verb.sentence)
        before = [w.norm for w in scene.words[max(0, mention.word - 2) : mention.word]]
        off = any(LET_OFF.match(word) for word in before) and OFF.search(clause)
        says = entity.count > 1 and verb.lemma in SAYS
        hurt = HURT.search(clause) and (verb.lemma in ("be", *BROUGHT))
        if not (hurt or off or says):
            return False
    return True


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
    named = bool(later) and open_still and own <= done | {"travel"}
    states = entity.roles & {"stationary", "slow", "parked"}
    if named and not later[0].ego:
        later[0].roles |= states  # "stationary target"
    return named


def _title_ends(scene: Scene) -> int | None:
    """The last word of a title without a finite verb and without numbers, if the text has one."""
    title = [w for w in scene.words if w.sentence == 0]
    colon = next((w.i for w in title[:14] if w.norm == ":"), None)
    title = title[: colon + 1] if colon is not None else title
    if len(title) == len(scene.words) or not 1 < len(title) <= 14 or title[-1].norm not in (".", ":"):
        return None
    told = any(w.tag in ("VBZ", "VBD", "VBP", "MD") or w.span and w.span.kind in ("quantity", "ego") for w in title)
    return None if told else title[-1].i


def _led(scene: Scene, traffic: Entity) -> bool:
    """Whether another vehicle is named that ego has ahead of it or runs into: it is the traffic that slows down."""
    met = {e.patient for e in scene.clauses.events if e.agent.ego and e.act in ("collide", "follow", "approach")}
    return any(e is not traffic and e.type in VEHICLES and (e in met) for e in scene.cast.entities)


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


def _mere_background(scene: Scene, entity: Entity) -> bool:
    """Whether a queue is only the setting ("in a jam") or its cars are named one by one."""
    if entity.noun not in language.table("actors")["queues"]:
        return False
    for mention in entity.mentions:
        head = scene.words[scene.words[mention.word].head]
        if scene.words[mention.word].dep == "pobj" and head.norm in ("in", "during", "within"):
            return True
        if _reason(scene, mention.word):
            return True
    return any(
        e is not entity
        and e.type in VEHICLES
        and (e.count > 1 or "stationary" in e.roles)
        and e.noun not in language.table("actors")["queues"]
        and ("stationary" in e.roles or any(v.act in ("stationary", "stop") for v in scene.events(e)))
        for e in scene.cast.entities
    )


def _reason(scene: Scene, i: int) -> bool:
    """Whether a queue is only why another (not ego) stops or slows: "V3 stopped for congestion"."""
    head = scene.words[scene.words[i].head]
    if scene.words[i].dep != "pobj" or head.norm not in ("for", "of", "to", "with"):
        return False
    halts = [
        e
        for e in scene.clauses.events
        if i in e.words and e.word < i and e.act in ("stop", "brake", "brake_stop", "stationary")
    ]
    return bool(halts) and not halts[-1].agent.ego


def _pass_on(scene: Scene, generic: Entity, members: list[Entity]) -> None:
    """What was said of "two obstacles" holds for those that are then named one by one."""
    where = scene.where(generic)
    for number, member in enumerate(members):
        own = scene.where(member)
        if any(e.act == "stationary" for e in scene.events(generic)) and not scene.events(member):
            member.roles.add("stationary")
        if own.lane is None and own.rel is None:
            own.lane, own.rel = where.lane, where.rel or "ahead"
        if number == 0 and own.gap is None and where.gap is not None:
            own.gap = where.gap

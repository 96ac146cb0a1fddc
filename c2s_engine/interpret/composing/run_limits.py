"""T: what must be kept to all along, and when the run is over, where the text tells."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.stated_limits import StatedLimit
from c2s_engine.structure.specs import Condition, EgoSpec, Limit, RestrictionsSpec


@cache
def _end_patterns() -> dict[str, re.Pattern[str]]:
    data = language.table("endings")
    named = {name: re.compile(data[name]) for name in ("collision", "denied", "stopped", "travelled")}
    lasts = "|".join(language.filled(find, data["words"]) for find in data["lasts"])
    return {**named, "lasts": re.compile(lasts)}


def restrictions(scene: Scene, ids: dict[Entity, str], ego: EgoSpec) -> RestrictionsSpec:
    """The conditions that end the run, and how long it lasts."""
    found: list[Condition] = []
    for start, end in scene.endings:
        text = scene.plain[start:end]
        events = [e for e in scene.clauses.events if start <= scene.words[e.word].start < end]
        hit = _end_patterns()["collision"].search(text)
        if hit is not None and _end_patterns()["denied"].search(text[: hit.start()]) is None:
            found += _collision(scene, ids, events, start, end)
        _end_patterns()["stopped"].search(text)
    limits = tuple(limit for _, limit in limits_of(scene, ids))
    return RestrictionsSpec(limits=limits, terminate_when=tuple(found), duration=None)  # type: ignore[arg-type]


def limits_of(scene: Scene, ids: dict[Entity, str]) -> list[tuple[StatedLimit, Limit]]:
    """The bounds on those who are in the scene, as told and as T has them."""
    return [(told, limit) for told in scene.limits if (limit := _limit(told, ids)) is not None]


def _limit(told: StatedLimit, ids: dict[Entity, str]) -> Limit | None:
    """The bound for who is in the scene; of what is told of somebody else, none."""
    subject = "ego" if told.subject.ego else ids.get(told.subject)
    if subject is None:
        return None
    other = None if told.other is None else "ego" if told.other.ego else ids.get(told.other)
    low, high = (None if v is None else round(v, 2) for v in (told.minimum, told.maximum))
    return Limit(kind=told.kind, subject=subject, other=other, minimum=low, maximum=high)  # type: ignore[arg-type]


def _collision(scene: Scene, ids: dict[Entity, str], events: list[Event], start: int, end: int) -> list[Condition]:
    """Ego's collision with whom the condition names, else with the first who is there; none where nobody is."""
    told = [e for v in events if v.act == "collide" for e in (v.agent, v.patient) if e is not None and not e.ego]
    told += [scene.cast.of[i] for i in sorted(scene.cast.of) if start <= scene.words[i].start < end]
    others = [ids[e] for e in told if e in ids and not e.ego]
    there = [name for name in ids.values() if name != "ego"]
    return [Condition(kind="collision", other=other) for other in [*others, *there][:1]]

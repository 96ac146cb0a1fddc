"""To whom ego's acts are directed where the clause does not name it; signs and lights that it obeys."""

import re

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import PlaceSpec


def faces_red(scene: Scene) -> bool:
    """Whether the light that ego faces is red while it goes on (a right turn on red)."""
    others = {i for e in scene.clauses.events if not e.agent.ego for i in e.words}
    for event in scene.events(scene.cast.ego):
        near = scene.words[max(0, event.word - 8) : event.word + 9]
        told = [w for w in near if w.sentence == scene.words[event.word].sentence and w.i not in others]
        if any(w.norm == "red" for w in told):
            return True
    return bool(re.search(r"right turn on red|turn(s|ing)? right on red", scene.plain))


def yielded(scene: Scene, event: Event, ids: dict[Entity, str]) -> str | None:
    """Whom ego lets pass, where the clause does not name it: the other in conflict with it."""
    near = [e for e in scene.actors if e in ids and e.mover]
    awaited = [
        e.agent
        for e in scene.clauses.events
        if e.adverbial in ("until", "till") and e.agent in near and e.word > event.word and e.order < event.order + 1
    ]
    if awaited:
        return ids[awaited[0]]
    before = [e for e in near if e.mentions and e.mentions[0].word < event.word]
    conflicts = [
        e
        for e in before or near
        if scene.where(e).lane in ("crossing", "oncoming", "left", "right") or "oncoming" in e.roles or e.person
    ]
    conflicts = conflicts or [e for e in before or near if scene.where(e).rel == "behind"]
    comes = [e for e in before if scene.does(e, "cut_in", "lane_change", "enter_road", "overtake")]
    pick = comes if re.search(r"\b(in|out|merge|over)$", event.whole) and comes else conflicts or before or near
    return ids[pick[-1]] if pick else None


def ahead(scene: Scene, ids: dict[Entity, str]) -> str | None:
    ahead = [e for e in scene.actors if e in ids and (scene.where(e).rel == "ahead" or "lead" in e.roles)]
    return ids[ahead[0]] if ahead else None


def passed(scene: Scene, ids: dict[Entity, str]) -> str | None:
    """What ego gets past, where the clause does not name it: what is in its lane ahead."""
    ahead = [
        e
        for e in scene.actors
        if e in ids
        and (
            scene.where(e).rel == "ahead"
            or scene.where(e).lane in ("same", "partly")
            or scene.where(e).lane is None
            and scene.where(e).rel is None
        )
    ]
    vehicles = [e for e in ahead if e.mover]
    pick = vehicles or ahead
    return ids[pick[0]] if pick else None


def last_actor(scene: Scene, ids: dict[Entity, str]) -> str | None:
    movers = [e for e in scene.actors if e in ids]
    return ids[movers[-1]] if movers else None


def for_sign(scene: Scene, event: Event, place: PlaceSpec) -> bool:
    """A stop that a sign or a red light asks for, not another road user."""
    near = event.whole
    sentence = " ".join(w.norm for w in scene.words if w.sentence == scene.words[event.word].sentence)
    if re.search(
        (
            r"stop sign|stop line|red light|traffic (light|signal)|at (the|a) (red|sign|line"
            r"|intersection|junction)|where the cross street"
        ),
        near,
    ):
        return True
    if event.adverbial == "after" and place.kind == "intersection" and place.control in ("signal", "stop"):
        return True
    return (
        scene.road.stop_sign
        and "stop sign" in sentence
        or event.act == "stop"
        and place.kind == "intersection"
        and bool(re.search(r"full stop|complete stop", near))
        and any(
            e.act in ("start", "go_straight", "turn") and e.order > event.order for e in scene.events(scene.cast.ego)
        )
    )


def free_side(place: PlaceSpec) -> str:
    return "right" if place.ego_lane == "leftmost" else "left"


def in_lane_conflict(scene: Scene, place: PlaceSpec) -> bool:
    return any(e.mover or e.type not in ("warning_sign",) for e in scene.actors)

"""Where a vehicle starts of which only what happens tells it."""

import re

from c2s_engine.interpret.placing.compass import compass
from c2s_engine.interpret.placing.flanks import comes_from
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.where.struck import SIDE
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import PlaceSpec

BEHIND_ONE = re.compile(r"[\w ]+? behind (?:the |a |an )?@")
STANDS = ("stop", "stationary", "brake_stop")


def _comes_up_behind(event: Event) -> bool:
    """Whether who does this has the other ahead: follows or passes it, or stops behind it."""
    return event.act in ("follow", "overtake", "held_up") or event.act in STANDS and bool(BEHIND_ONE.match(event.text))


def implied_start(scene: Scene, entity: Entity, acts: list[str], place: PlaceSpec, first: Event | None) -> dict:
    """The start that what happens implies."""
    junction = place.kind == "intersection"
    hit = scene.does(entity, "collide")
    direction = compass(scene, entity)
    if first is not None and first.act == "follow" and first.patient is not None and first.patient.ego:
        return {"position": "behind", "said": True}
    if direction == "same" and junction and "turn" in acts:
        return {"position": "ahead"}
    if "oncoming" in acts:
        return {"position": "oncoming_lane", "said": True}
    if any(e.patient is entity and _comes_up_behind(e) for e in scene.events(scene.cast.ego)):
        return {"position": "ahead", "said": True}
    struck = comes_from(scene, entity) if junction and "turn" not in acts else None
    if struck is not None and place.manoeuvre not in ("left", "right"):
        return {"position": f"crossing_{struck}", "said": True}
    if junction and {"run_red", "run_stop"} & set(acts):
        return {"position": "crossing_left"}
    if junction and "turn" in acts:
        event = scene.does(entity, "turn")
        told = re.search(r"across|in front of|into the path|path of|cut", event.whole if event else "")
        across = told or "adversary" in entity.roles  # it turns so that ego has to answer
        if event is not None and side(event) == "left" and (across or place.manoeuvre == "straight"):
            return {"position": "opposite_approach"}
        return (
            {"position": "crossing_right" if side(event) == "right" else "crossing_left"}
            if event and across
            else {"position": "ahead"}
        )
    if junction and {"cross_path", "go_straight"} & set(acts):
        if place.manoeuvre == "left":
            return {"position": "opposite_approach"}
        return {"position": "crossing_left"}
    if hit is not None and (hit.patient is None or hit.patient.ego):
        if re.search(rf"(rear|back|tail)(?! {SIDE})|from behind", hit.whole) and not hit.passive:
            return {"position": "behind", "said": True}
        if junction or place.kind == "roundabout":
            return {"position": "crossing_left"}
        return {"position": "behind"}
    if any(e.act == "follow" and e.patient is not None and e.patient.ego for e in scene.events(entity)):
        return {"position": "behind", "said": True}
    return {"position": "ahead"}

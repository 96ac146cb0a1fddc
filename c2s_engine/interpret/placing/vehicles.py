"""Where vehicles start, also where only what happens tells it."""

import re

from c2s_engine.interpret.entities import URGENT
from c2s_engine.interpret.placing.arms import waits_beside
from c2s_engine.interpret.placing.compass import compass, roadside
from c2s_engine.interpret.placing.implied_starts import implied_start
from c2s_engine.interpret.placing.lengthwise import (
    CIRCULATES,
    along_from_events,
    along_of,
    passes_ego,
    position_text,
    wrong_way,
)
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.overtakings import PART
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.interpret.where.relations import Where, side_of_text
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import PlaceSpec

ACROSS = re.compile(r"\bacross (?:the |both |two |all |@ego 's |@ego )?(?:\w+ )?(?:lanes?|road|carriageway|street)\b")
MIDDLE = re.compile(r"\b(?:in|on|along) the (?:middle|centre|center) lane\b")
ON_SIDE = re.compile(
    r"(?<!lane )\b(?:on|to) (?:(?:the )?@ego 's (?:left|right)(?! lane|-hand lane)"
    r"|the (?:left|right)(?: side)? of (?:the )?@ego)"
)


def vehicle(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    if wrong_way(scene, entity):
        return facing_ego(where, place)
    if place.kind == "roundabout" and CIRCULATES.search(position_text(scene, entity)):
        return {"position": "crossing_left", "said": True}
    if place.kind == "roundabout" and _enters_before_ego(scene, entity):
        return {"position": "crossing_right", "said": True}
    junction = place.kind == "intersection"
    lane, rel, edge = where.lane, where.rel, where.side
    if lane in (None, "same") and (where.of is None or where.of.ego) and MIDDLE.search(position_text(scene, entity)):
        lane = {"leftmost": "right", "rightmost": "left"}.get(place.ego_lane or "", lane)
    if rel is not None and passes_ego(scene, entity):
        rel = "behind"  # where it comes to be is said with the same words
    if rel == "beside" and where.of is None and _ahead_if_approached(scene, entity) == "ahead":
        rel, lane = "ahead", "same"  # beside another, but ego comes up behind it
    if lane == "oncoming" and rel == "behind" and "oncoming" not in entity.roles:
        lane = None  # the side on which it passes
    told = " ".join(t for _, t in where.phrases)
    if junction and rel is None and waits_beside(scene, entity, told):
        rel = "beside"
    if junction and lane in ("left", "right") and rel is None and "lane" not in told:
        lane, edge = "crossing", lane
    direction = compass(scene, entity) if lane in (None, "same", "crossing", "left", "right", "adjacent") else None
    if direction in ("left", "right") and junction:
        return {"position": f"crossing_{direction}", "said": True}
    if direction == "opposite" and (junction or "turn" in acts or rel in (None, "beside")):
        return {"position": "opposite_approach" if junction else "oncoming_lane", "said": True}
    text = " ".join(t for _, t in where.phrases)
    roles = entity.roles
    moves = [a for a in acts if a not in ("stationary",)]
    first = scene.events(entity)[0] if scene.events(entity) else None
    if ACROSS.search(text) and scene.does(entity, "stationary") and lane in (None, "same", "parked", "roadside"):
        return {"position": "ahead", "said": True}
    if lane == "partly":
        return {"position": "partly_in_lane", "side": edge or side_of_text(text) or "right", "said": True}
    if lane == "ramp":
        return {"position": "on_ramp", "said": True}
    if (
        lane in ("parked", "roadside", "sidewalk")
        or (lane is None and "parked" in roles and rel != "ahead")
        or (lane is None and "enter_road" in acts)
    ):
        came = direction or (compass(scene, entity) if "enter_road" in acts else None)
        sideways = came if came in ("left", "right") else None
        edge = edge or side_of_text(text) or roadside(scene, text) or sideways or "right"
        if lane == "roadside" and where.facing == "across" or "reverse" in acts and lane != "parked":
            return {"position": "roadside", "side": edge, "facing": "across", "said": True}
        along = "behind" if rel == "behind" else "ahead"
        return {
            "position": "parked" if lane != "roadside" or not moves or "enter_road" in acts else "roadside",
            "side": edge,
            "along": along,
            "said": True,
        }
    if lane == "oncoming" or "oncoming" in roles:
        return {
            "position": "opposite_approach" if junction else "oncoming_lane",
            "said": True,
        }
    if lane == "crossing" or "crossing" in roles and junction:
        return {"position": f"crossing_{edge or 'left'}", "said": edge is not None}
    if lane in ("left", "right"):
        same = {"leftmost": "left", "rightmost": "right"}.get(place.ego_lane or "")
        own = where.of is None or where.of.ego and not re.search(rf"lane (?:to|on|of)\b|@ego 's {lane}", text)
        if same == lane and own and re.search(rf"({lane}(-hand|most)?|that( very)?|this|same) lane", text):
            rel = rel if rel in ("behind", "ahead") else _ahead_if_approached(scene, entity)
            if rel is None and not {"cut_in", "lane_change"} & set(acts):  # no lane lies beyond ego's
                rel = "ahead"
            if rel is not None:
                return {"position": rel, "said": True}
        if rel is None and ON_SIDE.search(text) and not {"cut_in", "lane_change", "overtake"} & set(acts):
            rel = "beside"
        return {
            "position": f"{lane}_lane",
            "along": along_of(rel or along_from_events(scene, entity)),
            "said": True,
        }
    if junction and place.manoeuvre in ("left", "right") and (acts == ["stationary"] or "stationary" in roles):
        return {"position": "intersection_exit", "said": True}
    if rel is None and lane is None and _passed_from_left_lane(scene, entity, place):
        return {"position": "right_lane", "along": "ahead", "said": True}
    if lane == "adjacent" or "adjacent" in roles:
        free = {"leftmost": "right", "rightmost": "left"}.get(place.ego_lane or "")
        edge = edge or _cut_side(scene, entity) or free or "left"
        return {
            "position": f"{edge}_lane",
            "along": along_of(rel or ("behind" if "overtake" in acts else None)),
            "said": True,
        }
    towards = next((side(e) for e in scene.events(scene.cast.ego) if e.act == "lane_change" and side(e)), None)
    if rel == "beside":
        return {"position": "beside", "side": edge or towards or "left", "said": True}
    if "cut_in" in acts or "cut_in" in roles:
        event = scene.does(entity, "cut_in")
        start = _cut_side(scene, entity) or "left"
        if place.ego_lane == "leftmost":
            start = "right"
        parted = rel == "behind" and any(e.mode == PART and e.agent is entity for e in scene.clauses.events)
        if parted or lane in (None, "same") and acts[:1] == ["follow"] and {"lane_change", "overtake"} & set(acts):
            return {"position": "behind", "said": True}
        if event is not None and "overtake" in acts or rel == "behind":
            return {"position": f"{start}_lane", "along": "behind", "said": True}
        return {"position": f"{start}_lane", "along": along_of(rel), "said": True}
    if passes_ego(scene, entity):
        if (
            lane == "same"
            or (place.oncoming or place.lanes in (None, 1) and place.kind not in ("motorway",))
            and _cut_side(scene, entity) != "right"
            or scene.does(entity, "leave_road") is not None
            or (rel == "behind" or first is not None and first.act == "follow" and _of_ego(first))
            and (entity.type in URGENT or "lane_change" in acts[: acts.index("overtake")])  # out of ego's lane
        ):
            return {"position": "behind", "said": True}
        lateral = _cut_side(scene, entity) or "left"
        return {
            "position": f"{lateral}_lane" if place.ego_lane != "leftmost" or lateral == "right" else "behind",
            "along": "behind",
            "said": True,
        }
    if rel == "behind":
        return {"position": "behind", "said": True}
    if rel == "ahead" or "lead" in roles or lane == "same":
        return {"position": "ahead", "said": True}
    if "following" in roles:
        return {"position": "behind", "said": True}
    return implied_start(scene, entity, acts, place, first)


def _of_ego(event: Event) -> bool:
    """Whether what another does is about ego."""
    return event.patient is not None and event.patient.ego


def _passed_from_left_lane(scene: Scene, entity: Entity, place: PlaceSpec) -> bool:
    """Whether ego passes it from the left lane in which it drives already: then it is in the right one."""
    ego = scene.cast.ego
    passing = scene.does(ego, "overtake") if place.ego_lane == "leftmost" else None
    if passing is None or passing.patient is not entity:
        return False
    before = [e for e in scene.events(ego) if e.order < passing.order]
    return not any(e.act in ("lane_change", "oncoming") or e.patient is entity for e in before)


def _enters_before_ego(scene: Scene, entity: Entity) -> bool:
    """Whether one enters the roundabout in which ego drives, or before it without giving way."""
    enters = [e for e in scene.events(entity) if re.match(r"(enter|drive into|pull (out )?into|join)\b", e.text)]
    inside = any(CIRCULATES.search(e.whole) for e in scene.events(scene.cast.ego))
    denied = any(e.agent is entity and re.match(r"(yield|give way)\b", e.text) for e in scene.clauses.events)
    return bool(enters) and (inside or denied)


def facing_ego(where: Where, place: PlaceSpec) -> dict:
    """Where one is that comes the wrong way: ahead in ego's lane, unless the lane beside is named."""
    own = {"leftmost": "left", "rightmost": "right"}.get(place.ego_lane or "")
    named = re.search(r"(left|right)(-hand|most)? lane", " ".join(t for _, t in where.phrases))
    lane = named[1] if named else where.lane
    if lane not in ("left", "right") or lane == own:
        return {"position": "ahead", "facing": "against", "said": True}
    return {"position": f"{lane}_lane", "along": "ahead", "facing": "against", "said": True}


def _ahead_if_approached(scene: Scene, entity: Entity) -> str | None:
    """Ahead, where ego approaches or follows it."""
    met = any(e.patient is entity and e.act in ("approach", "follow", "held_up") for e in scene.events(scene.cast.ego))
    return "ahead" if met else None


def _cut_side(scene: Scene, entity: Entity) -> str | None:
    """The side that one who cuts in comes from."""
    for event in scene.events(entity):
        if event.act == "overtake" and event.side is not None:
            return event.side  # "undertakes"
        if event.act in ("cut_in", "lane_change", "overtake"):
            match = re.search(
                r"from (the |its )?(adjacent |next |neighbou?ring )?(left|right)|(on|in) (the |its )?(left|right)",
                event.whole,
            )
            if match:
                return match[3] or match[6]
            towards = side(event)
            if towards and event.act != "overtake":
                return OPPOSITE[towards]
    return None

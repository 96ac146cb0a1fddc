"""Where people, animals and cyclists start."""

import re

from c2s_engine.interpret.placing.compass import roadside
from c2s_engine.interpret.placing.lengthwise import CIRCULATES, along_of, at_edge, passes_ego, position_text, wrong_way
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.scene import side as move_side
from c2s_engine.interpret.what.towards import OPPOSITE
from c2s_engine.interpret.where.relations import Where, side_of_text
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import PlaceSpec


def person(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    if entity.type == "bicycle" and place.kind == "roundabout" and CIRCULATES.search(position_text(scene, entity)):
        return {"position": "crossing_left", "said": True}
    passing = scene.does(entity, "overtake")
    by = where.side or side_of_text(passing.whole) if passing is not None else None
    if entity.type == "bicycle" and by and place.manoeuvre == by and place.kind == "intersection":
        return {"position": "roadside", "side": by, "along": "behind", "said": True}  # between ego and the kerb
    walks_over = entity.person and "cross_road" in acts  # "as she passes the truck"
    if "overtake" in acts and not walks_over and (where.lane is None and not where.rel or passes_ego(scene, entity)):
        return {"position": "behind", "said": True}
    crosses = "cross_road" in acts or "enter_road" in acts or "cut_in" in acts and entity.person
    crosses = crosses or _on_crosswalk(scene, entity, acts) or entity.person and "crossing" in entity.roles
    along = "move_along" in acts and not crosses
    text = " ".join(e.whole for e in scene.events(entity)) + " " + " ".join(t for _, t in where.phrases)
    edge = (
        where.side
        or side_of_text(re.sub(r"@\w+ (turn|travel)\w* (left|right)", "", " ".join(t for _, t in where.phrases)))
        or _sentence_side(scene, entity)
    )
    edge = edge or roadside(scene, text)
    if wrong_way(scene, entity):
        return {"position": "ahead", "facing": "against", "said": True}
    if entity.type == "bicycle":
        over = place.kind in ("intersection", "roundabout") or "cross_road" not in acts
        if (
            where.lane == "crossing"
            and over
            and not re.search(r"\b(cross|crosses) (the|a) (road|street|crosswalk|zebra)|crosswalk|sidewalk", text)
        ):
            return {"position": f"crossing_{where.side or 'right'}", "said": True}
        if (where.lane == "oncoming" or "oncoming" in entity.roles) and not crosses:
            return {"position": "opposite_approach" if place.kind == "intersection" else "oncoming_lane", "said": True}
        if where.rel == "behind" and where.side and at_edge(scene, entity) and place.kind == "intersection":
            return {"position": "roadside", "side": where.side, "along": "behind", "said": True}
        own = {"leftmost": "left", "rightmost": "right"}.get(place.ego_lane or "")
        beside = where.rel or place.ego_lane and where.lane != own
        if where.lane in ("left", "right") and beside and "cross_road" not in acts:
            return {"position": f"{where.lane}_lane", "along": along_of(where.rel), "said": True}
        if "oncoming" in acts and where.rel is None and not crosses:
            return {"position": "oncoming_lane", "said": True}
        if where.lane == "oncoming" and place.kind == "intersection":
            return {"position": "opposite_approach", "said": True}
    if (
        crosses
        and entity.type == "bicycle"
        and place.kind == "intersection"
        and (where.lane == "oncoming" or "oncoming" in entity.roles)
    ):
        return {"position": "opposite_approach", "said": True}
    if crosses:
        if place.kind == "intersection" and place.manoeuvre in ("left", "right") and where.lane not in ("parked",):
            return {"position": "intersection_exit", "side": edge or "right", "said": True}
        position = (
            "sidewalk"
            if where.lane == "sidewalk"
            or place.sidewalk
            or where.lane in (None, "crossing")
            and (scene.road.setting == "urban" or scene.road.crosswalk)
            and entity.type != "animal"
            else "roadside"
        )
        return {
            "position": position,
            "side": _from_side(text) or edge or None or _behind_whom(scene, where, text) or "right",
            "said": where.lane is not None or where.side is not None,
        }
    alone = entity.type == "bicycle" and entity.count == 1 and "overtake" not in acts
    into = scene.does(entity, "cut_in") if alone and where.rel in (None, "ahead", "beside") else None
    if into is not None and where.lane not in ("crossing", "oncoming"):
        kerb = OPPOSITE.get(move_side(into) or "", edge or "right")
        return {"position": "partly_in_lane", "side": kerb, "said": where.lane is not None}
    side = where.side or ("right" if where.rel == "beside" else None)
    if (
        entity.type == "bicycle"
        and where.lane != "sidewalk"
        and side
        and place.manoeuvre == side
        and where.rel in (None, "ahead", "beside")
    ):
        return {"position": "partly_in_lane", "side": side, "said": True}
    if entity.type == "bicycle" and where.lane == "sidewalk":
        return {"position": "sidewalk", "side": edge or "right", "said": True}
    if along or entity.type == "bicycle":
        follows = any(e.act == "follow" and e.patient is not None and e.patient.ego for e in scene.events(entity))
        if where.rel == "behind" or follows and where.rel is None:
            return {"position": "behind", "said": True}
        if entity.person and where.lane in ("sidewalk", "roadside"):
            inside = re.search(r"inside the|in the lane|on the road|edge of the lane", text)
            return {
                "position": "partly_in_lane" if inside else "sidewalk" if where.lane == "sidewalk" else "roadside",
                "side": edge or "right",
                "facing": None,
                "said": True,
            }
        if entity.type == "bicycle" and (
            where.lane in ("roadside", "partly")
            or where.lane == "parked"
            and "stationary" in acts
            or re.search(r"(right|left)(-hand)? (edge|side)|edge of|near the (curb|kerb)", text)
        ):
            facing = "against" if where.facing == "against" and where.lane == "partly" else None
            return {"position": "partly_in_lane", "side": edge or "right", "facing": facing, "said": True}
        if where.lane == "same" and re.search(r"edge", text) or entity.person and along:
            return {
                "position": "partly_in_lane",
                "side": edge or "right",
                "facing": None,
                "said": where.lane is not None,
            }
        return {"position": "ahead", "said": where.rel is not None or where.lane is not None}
    if where.lane in ("sidewalk", "roadside", "parked"):
        return {
            "position": "sidewalk" if where.lane == "sidewalk" else "roadside",
            "side": edge or "right",
            "said": True,
        }
    if entity.person and where.side and where.rel is None and where.lane is None:  # "another is on the right"
        walk = place.sidewalk or scene.road.crosswalk or scene.road.setting == "urban"
        return {"position": "sidewalk" if walk else "roadside", "side": where.side, "said": True}
    if _behind_ego(where):
        return {"position": "behind", "said": True}
    return {"position": "ahead", "said": where.rel == "ahead" or where.lane == "same"}


def _behind_ego(where: Where) -> bool:
    """Whether it is told to be behind ego, or behind nobody who is named and out of nobody's sight."""
    of_ego = where.of is None or where.of.ego
    return where.rel == "behind" and of_ego and where.hidden_by is None


def _on_crosswalk(scene: Scene, entity: Entity, acts: list[str]) -> bool:
    """Whether a person or cyclist of whom no act is told is on a crosswalk: then it crosses."""
    if acts or not (entity.person or entity.type == "bicycle") or not scene.road.crosswalk or entity.roles:
        return False
    words = scene.words[entity.mentions[0].word : entity.mentions[0].word + 7]
    return bool(re.search(r"cross|zebra", " ".join(w.norm for w in words)))


def _sentence_side(scene: Scene, entity: Entity) -> str | None:
    """The side that the sentence of a person's first mention names for it."""
    first = entity.mentions[0]
    passing = {i for e in scene.clauses.events if e.act == "overtake" and e.agent is not entity for i in e.words}
    own = [w for w in scene.words if w.sentence == scene.words[first.word].sentence and w.i not in passing]
    sentence = " ".join(w.norm for w in own)
    match = re.search(r"(left|right) side|(?:from|on) (?:the |its )?(left|right)\b(?! lane|-hand lane)", sentence)
    return (match[1] or match[2]) if match else None


def _from_side(text: str) -> str | None:
    match = re.search(r"from (the |its |@\w+ 's )?(far |opposite )?(left|right)", text)
    return match[3] if match else None


LEFT = re.compile(r"\b(?:from|out of|off|leave|exit) (?:the |a |an )?(?:\w+ )?@KEY\b")


def _keyed(text: str, entity: Entity) -> str:
    """A text in which one road user is called KEY."""
    return re.sub(rf"@{entity.key}\b", "@KEY", text)


def _behind_whom(scene: Scene, where: Where, told: str = "") -> str | None:
    """The side of one who hides somebody or whom it leaves, where that stands on one side or comes the other way."""
    blocker = where.hidden_by or next((e for e in scene.actors if LEFT.search(_keyed(told, e))), None)
    theirs = scene.where(blocker) if blocker is not None else None
    if theirs is None:
        return None
    return "left" if theirs.lane == "oncoming" else theirs.side

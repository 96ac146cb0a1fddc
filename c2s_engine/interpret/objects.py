"""O1..N: each actor's type, start, speed and phases."""
# ruff: noqa: E501  (patterns and tables of cases stay on one line)

import re
from dataclasses import dataclass, field

from c2s_engine.interpret import language
from c2s_engine.interpret.clauses import Event
from c2s_engine.interpret.mentions import PERSONS, ZONES, Entity
from c2s_engine.interpret.phases import phases_of
from c2s_engine.interpret.relations import Where, side_of_text
from c2s_engine.interpret.scene import Scene, side
from c2s_engine.structure.components import Assumption, Unmet
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Placement, PlaceSpec

OPPOSITE = {"left": "right", "right": "left"}


@dataclass
class Draft:
    """An object on its way to S."""

    entity: Entity | None
    spec: ObjectSpec
    assumed: list[Assumption] = field(default_factory=list)
    unmet: list[Unmet] = field(default_factory=list)


def compose_object(scene: Scene, entity: Entity, ids: dict[Entity, str], place: PlaceSpec, ego: EgoSpec) -> Draft:
    """The object of an entity."""
    assumed: list[Assumption] = []
    kind = "car" if entity.type in ("vehicle",) else "bicycle" if entity.type == "rider" else entity.type
    if entity.type == "vehicle":
        assumed.append(Assumption(field="type", value="car", reason="the text says only that it is a vehicle"))
    if "guessed" in entity.roles:
        assumed.append(
            Assumption(
                field="type",
                value=kind,
                reason=f"“{entity.noun}” is no known road user: its type is taken from what it does",
            )
        )
    placement = _placement(scene, entity, ids, place, assumed)
    phases = phases_of(scene, entity, ids, placement, place)
    speed = _speed(scene, entity, kind, phases, ego, placement, place, assumed, ids[entity])
    spec = ObjectSpec(
        name=_name(entity, placement),
        type=kind,
        count=min(8, entity.count),
        placement=placement,
        speed=speed,
        phases=tuple(phases),  # type: ignore[arg-type]
    )
    return Draft(entity, spec, assumed)


def _name(entity: Entity, placement: Placement) -> str:
    if entity.label and entity.label.isdigit():
        return f"v{entity.label}"
    for role in ("lead", "oncoming"):
        if role in entity.roles:
            return role
    return (entity.noun or entity.type).replace("-", " ")


def _placement(
    scene: Scene, entity: Entity, ids: dict[Entity, str], place: PlaceSpec, assumed: list[Assumption]
) -> Placement:
    where = scene.where(entity)
    acts = [e.act for e in scene.events(entity)]
    values = (_person if entity.person or entity.type == "bicycle" else _thing if not entity.mover else _vehicle)(
        scene, entity, where, acts, place
    )
    if not values.pop("said", False):
        assumed.append(
            Assumption(
                field="placement.position", value=values["position"], reason="the text does not say where it starts"
            )
        )
    of = "ego"
    if (
        where.of is not None
        and not where.of.ego
        and where.of in ids
        and where.of is not entity
        and values["position"]
        in ("ahead", "behind", "left_lane", "right_lane", "beside", "parked", "partly_in_lane", "roadside")
    ):
        of = ids[where.of]
    hidden = ids.get(where.hidden_by) if where.hidden_by is not None else None
    gap = where.gap
    if gap is None and where.gap_time is not None and values["position"] in ("ahead", "behind"):
        speed = scene.speeds.get(scene.cast.ego) or scene.speeds.get(entity)
        if speed:
            closing = (speed[0] + speed[1]) / 2
            own = scene.speeds.get(entity)
            ttc = bool(re.search(r"ttc|time[- ]to[- ]collision", scene.plain))
            if ttc and own and own is not speed:
                closing = max(1.0, closing - own[0])
            low = closing * where.gap_time
            gap = (low * 1.02, low * 1.2)
    if gap is None and values["position"] == "ahead" and (ttc_start := _start_ttc(scene)) is not None:
        speed, own = scene.speeds.get(scene.cast.ego), scene.speeds.get(entity)
        if speed and not any(scene.where(e).gap for e in scene.actors):
            closing = max(1.0, speed[0] - (own[0] if own else 0.0))
            gap = (closing * ttc_start * 1.02, closing * ttc_start * 1.2)
    if gap is None and values["position"] in ("ahead", "behind") and not any(scene.where(e).gap for e in scene.actors):
        for span in scene.spans:
            if (
                span.kind == "quantity"
                and span.data["dimension"] == "distance"
                and re.search(
                    r"(gap|distance|headway|separation|spacing)( of| is| was|:|=)? ?(about |at least |roughly )?$",
                    scene.plain[max(0, span.start - 30) : span.start],
                )
            ):
                gap = (span.data["low"], span.data["high"])
                break
    if gap is not None:
        low, high = sorted(gap)
        values["gap"] = round(low, 1) if high - low < 0.5 else (round(low, 1), round(high, 1))
    return Placement(of=of, hidden_by=hidden if hidden != "ego" else None, **values)


def _start_ttc(scene: Scene) -> float | None:
    """The time to collision at the start, where it is no trigger of what another does."""
    for span in scene.spans:
        if span.kind == "quantity" and span.data["dimension"] == "time":
            near = scene.plain[max(0, span.start - 45) : span.end + 35]
            used = any(
                e.trigger
                and e.trigger["kind"] == "ttc"
                and not e.agent.ego
                and e.act not in ("travel", "stationary")
                and e.trigger["value"] == span.data["low"]
                for e in scene.clauses.events
            )
            if re.search(r"\bttc\b|time[- ]to[- ](collision|contact)", near) and not used:
                return span.data["low"]
    return None


def _person(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    if "overtake" in acts and (where.lane is None and not where.rel or _passes_ego(scene, entity)):
        return {"position": "behind", "said": True}
    crosses = "cross_road" in acts or "enter_road" in acts or "cut_in" in acts and entity.person
    crosses = crosses or _on_crosswalk(scene, entity, acts)
    along = "move_along" in acts and not crosses
    text = " ".join(e.whole for e in scene.events(entity)) + " " + " ".join(t for _, t in where.phrases)
    edge = (
        where.side
        or side_of_text(re.sub(r"@\w+ (turn|travel)\w* (left|right)", "", " ".join(t for _, t in where.phrases)))
        or _sentence_side(scene, entity)
    )
    if entity.type == "bicycle":
        if where.lane == "crossing" and not re.search(
            r"\b(cross|crosses) (the|a) (road|street|crosswalk|zebra)|crosswalk|sidewalk", text
        ):
            return {"position": f"crossing_{where.side or 'right'}", "said": True}
        if (where.lane == "oncoming" or "oncoming" in entity.roles) and not crosses:
            return {"position": "opposite_approach" if place.kind == "intersection" else "oncoming_lane", "said": True}
        if where.lane in ("left", "right") and where.rel:
            return {"position": f"{where.lane}_lane", "along": _along(where.rel), "said": True}
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
            or where.lane is None
            and (scene.road.setting == "urban" or scene.road.crosswalk)
            and entity.type != "animal"
            else "roadside"
        )
        return {
            "position": position,
            "side": _from_side(text) or edge or "right",
            "said": where.lane is not None or where.side is not None,
        }
    if (
        "stationary" in acts
        and (where.lane in ("same", None) and where.rel != "beside")
        and where.lane not in ("sidewalk", "roadside")
    ):
        return {"position": "ahead", "said": True}
    if (
        entity.type == "bicycle"
        and where.side
        and place.manoeuvre == where.side
        and where.rel in (None, "ahead", "beside")
    ):
        return {"position": "partly_in_lane", "side": where.side, "said": True}
    if along or entity.type == "bicycle":
        if where.rel == "behind" and where.lane != "same":
            return {"position": "behind", "said": True}
        if where.rel == "behind":
            return {"position": "behind", "said": True}
        if entity.person and where.lane in ("sidewalk", "roadside"):
            inside = re.search(r"inside the|in the lane|on the road|edge of the lane", text)
            return {
                "position": "partly_in_lane" if inside else "sidewalk" if where.lane == "sidewalk" else "roadside",
                "side": edge or "right",
                "facing": _facing(text),
                "said": True,
            }
        if entity.type == "bicycle" and (
            where.lane in ("roadside", "partly")
            or re.search(r"(right|left)(-hand)? (edge|side)|edge of|near the (curb|kerb)", text)
        ):
            return {"position": "partly_in_lane", "side": edge or "right", "said": True}
        if where.rel == "beside":
            return {"position": "beside", "side": edge or "right", "said": True}
        if where.lane == "same" and re.search(r"edge", text) or entity.person and along:
            return {
                "position": "partly_in_lane",
                "side": edge or "right",
                "facing": _facing(text),
                "said": where.lane is not None,
            }
        if entity.type == "bicycle" and where.side and where.lane is None:
            return {"position": "partly_in_lane", "side": where.side, "said": True}
        return {"position": "ahead", "said": where.rel is not None or where.lane is not None}
    if where.lane in ("sidewalk", "roadside", "parked"):
        return {
            "position": "sidewalk" if where.lane == "sidewalk" else "roadside",
            "side": edge or "right",
            "said": True,
        }
    return {"position": "ahead", "said": where.rel == "ahead" or where.lane == "same"}


def _on_crosswalk(scene: Scene, entity: Entity, acts: list[str]) -> bool:
    """Whether a person of whom no act is told is on a crosswalk: then it crosses."""
    if acts or not entity.person or not scene.road.crosswalk or entity.roles:
        return False
    words = scene.words[entity.mentions[0].word : entity.mentions[0].word + 7]
    return bool(re.search(r"cross|zebra", " ".join(w.norm for w in words)))


def _sentence_side(scene: Scene, entity: Entity) -> str | None:
    """The side that the sentence of a person's first mention names for it."""
    first = entity.mentions[0]
    sentence = " ".join(w.norm for w in scene.words if w.sentence == scene.words[first.word].sentence)
    match = re.search(r"(left|right) side|(?:from|on) (?:the |its )?(left|right)\b(?! lane|-hand lane)", sentence)
    return (match[1] or match[2]) if match else None


def _facing(text: str) -> str | None:
    return (
        "against"
        if re.search(r"facing (the )?(traffic|oncoming)|against (the )?traffic|towards (the )?@ego", text)
        else None
    )


def _from_side(text: str) -> str | None:
    match = re.search(r"from (the |its |@\w+ 's )?(far |opposite )?(left|right)", text)
    return match[3] if match else None


def _along(rel: str | None) -> str:
    return {"ahead": "ahead", "behind": "behind", "beside": "abreast"}.get(rel or "", "ahead")


def _thing(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    text = " ".join(t for _, t in where.phrases)
    edge = where.side or side_of_text(text)
    if where.lane in ("parked", "roadside", "sidewalk") and not re.search(
        r"(in|on|block\w*) (the|its) (\w+ )?lane", text
    ):
        return {
            "position": "sidewalk" if where.lane == "sidewalk" else "roadside",
            "side": edge or "right",
            "said": True,
        }
    if where.lane == "partly":
        return {"position": "partly_in_lane", "side": edge or "right", "said": True}
    if where.lane in ("left", "right"):
        return {"position": f"{where.lane}_lane", "along": "ahead", "said": True}
    if where.lane == "oncoming":
        return {"position": "oncoming_lane", "said": True}
    if entity.type in ZONES and edge and where.lane is None:
        return {"position": "roadside", "side": edge, "said": True}
    return {"position": "ahead", "said": where.rel is not None or where.lane is not None}


def _vehicle(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    junction = place.kind == "intersection"
    lane, rel, edge = where.lane, where.rel, where.side
    if junction and lane in ("left", "right") and rel is None and "lane" not in " ".join(t for _, t in where.phrases):
        lane, edge = "crossing", lane
    direction = _compass(scene, entity) if lane in (None, "same", "crossing") else None
    if direction in ("left", "right") and junction:
        return {"position": f"crossing_{direction}", "said": True}
    if direction == "opposite" and (junction or "turn" in acts or rel is None):
        return {"position": "opposite_approach" if junction else "oncoming_lane", "said": True}
    text = " ".join(t for _, t in where.phrases)
    roles = entity.roles
    moves = [a for a in acts if a not in ("stationary",)]
    first = scene.events(entity)[0] if scene.events(entity) else None
    if lane == "partly":
        return {"position": "partly_in_lane", "side": edge or side_of_text(text) or "right", "said": True}
    if lane == "ramp":
        return {"position": "on_ramp", "said": True}
    if (
        lane in ("parked", "roadside", "sidewalk")
        or (lane is None and "parked" in roles and rel != "ahead")
        or (lane is None and "enter_road" in acts)
    ):
        edge = edge or side_of_text(text) or _side_of_events(scene, entity) or "right"
        if lane == "roadside" and where.facing == "across" or "reverse" in acts and lane != "parked":
            return {"position": "roadside", "side": edge, "facing": "across", "said": True}
        along = "behind" if rel == "behind" else "ahead"
        return {
            "position": "parked" if lane != "roadside" or not moves or "enter_road" in acts else "roadside",
            "side": edge,
            "along": along,
            "said": True,
        }
    if "parked" in roles and rel == "ahead" and lane is None and _ego_parked(scene):
        return {"position": "parked", "side": "right", "along": "ahead", "said": True}
    if lane == "oncoming" or "oncoming" in roles:
        return {
            "position": "opposite_approach" if junction and not _before_junction(text) else "oncoming_lane",
            "said": True,
        }
    if lane == "crossing" or "crossing" in roles and junction:
        return {"position": f"crossing_{edge or _compass(scene, entity) or 'left'}", "said": edge is not None}
    if lane in ("left", "right"):
        same = {"leftmost": "left", "rightmost": "right"}.get(place.ego_lane or "")
        if (
            same == lane
            and rel in ("behind", "ahead")
            and re.search(rf"{lane}(-hand|most)? lane", text)
            and where.of is None
        ):
            return {"position": rel, "said": True}
        return {
            "position": f"{lane}_lane",
            "along": _along(rel or ("behind" if _passes_ego(scene, entity) or _gains(scene, entity) else None)),
            "said": True,
        }
    if (
        junction
        and place.manoeuvre in ("left", "right")
        and (acts == ["stationary"] or "stationary" in roles)
        and re.search(
            r"(enter|past the corner|after the (turn|corner)|around the corner|behind the (corner|turn)|has just|exit|beyond the)",
            scene.plain,
        )
    ):
        return {"position": "intersection_exit", "said": True}
    if lane == "adjacent" or "adjacent" in roles:
        edge = edge or _cut_side(scene, entity) or "left"
        return {
            "position": f"{edge}_lane",
            "along": _along(rel or ("behind" if "overtake" in acts else None)),
            "said": True,
        }
    towards = next((side(e) for e in scene.events(scene.cast.ego) if e.act == "lane_change" and side(e)), None)
    if rel == "beside":
        return {"position": "beside", "side": edge or towards or "left", "said": True}
    wipes = scene.does(entity, "collide")
    shift = scene.does(entity, "lane_change", "cut_in", "drift")
    if (
        rel is None
        and lane is None
        and wipes is not None
        and shift is not None
        and side(shift)
        and not junction
        and not wipes.agent.ego
    ):
        return {"position": "beside", "side": OPPOSITE[side(shift) or "left"], "said": True}
    if "cut_in" in acts or "cut_in" in roles:
        event = scene.does(entity, "cut_in")
        start = _cut_side(scene, entity) or "left"
        if place.ego_lane == "leftmost":
            start = "right"
        if event is not None and "overtake" in acts or rel == "behind":
            return {"position": f"{start}_lane", "along": "behind", "said": True}
        return {"position": f"{start}_lane", "along": _along(rel), "said": True}
    if _passes_ego(scene, entity):
        if (
            lane == "same"
            or (place.oncoming or place.lanes in (None, 1) and place.kind not in ("motorway",))
            and _cut_side(scene, entity) != "right"
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
    return _implied(scene, entity, acts, place, first)


def _implied(scene: Scene, entity: Entity, acts: list[str], place: PlaceSpec, first: Event | None) -> dict:
    """The start that what happens implies."""
    junction = place.kind == "intersection"
    hit = scene.does(entity, "collide")
    ego_hits = next((e for e in scene.events(scene.cast.ego) if e.act == "collide" and e.patient is entity), None)
    direction = _compass(scene, entity)
    if direction in ("left", "right") and junction:
        return {"position": f"crossing_{direction}", "said": True}
    if direction == "opposite":
        return {"position": "opposite_approach" if junction else "oncoming_lane", "said": True}
    if "oncoming" in acts:
        return {"position": "oncoming_lane", "said": True}
    if junction and {"run_red", "run_stop"} & set(acts):
        return {"position": "crossing_left"}
    if junction and "turn" in acts:
        event = scene.does(entity, "turn")
        across = re.search(r"across|in front of|into the path|path of|cut", event.whole if event else "")
        if event is not None and side(event) == "left" and (across or place.manoeuvre == "straight"):
            return {"position": "opposite_approach"}
        return (
            {"position": "crossing_right" if side(event) == "right" else "crossing_left"}
            if event and across
            else {"position": "ahead"}
        )
    if junction and {"cross_path", "go_straight"} & set(acts):
        if place.manoeuvre == "left" and not re.search("cross", first.whole if first else ""):
            return {"position": "opposite_approach"}
        return {"position": "crossing_left"}
    if hit is not None and (hit.patient is None or hit.patient.ego):
        if (
            re.search(r"(rear|back|tail|from behind)", hit.whole)
            and not hit.passive
            or re.search(r"from behind|rear-end", hit.whole)
        ):
            return {"position": "behind", "said": True}
        if re.search(r"rear-end", hit.whole):
            return {"position": "behind", "said": True}
        if junction:
            return {"position": "crossing_left"}
        return {"position": "behind"}
    if any(e.act == "follow" and e.patient is not None and e.patient.ego for e in scene.events(entity)):
        return {"position": "behind", "said": True}
    if any(e.patient is entity and e.act in ("follow", "overtake", "held_up") for e in scene.events(scene.cast.ego)):
        return {"position": "ahead", "said": True}
    if (
        ego_hits is not None
        and junction
        and not re.search(r"rear|back|behind", ego_hits.whole)
        and acts
        and "stop" not in acts
        and "stationary" not in acts
        and "brake" not in acts
    ):
        return {"position": "crossing_left"}
    if junction and any(e.act == "yield" and e.patient is entity for e in scene.events(scene.cast.ego)):
        return {"position": "opposite_approach" if place.manoeuvre == "left" else "crossing_left"}
    return {"position": "ahead"}


COMPASS = {"north": 0, "east": 90, "south": 180, "west": 270}


def _heading(text: str) -> int | None:
    match = re.search(r"\b(north|south|east|west)(?:bound|ward|wards|erly)?\b", text)
    if match is None:
        return None
    from_it = re.search(r"(from|of) (the )?(north|south|east|west)\b(?!bound)", text)
    return (COMPASS[match[1]] + (180 if from_it else 0)) % 360


def _compass(scene: Scene, entity: Entity) -> str | None:
    """left, right (coming from there), opposite or same, by the compass directions of ego and the other."""

    def heading(who: Entity) -> int | None:
        for event in scene.clauses.events:
            if event.agent is who:
                found = _heading(event.whole)
                if found is not None:
                    return found
        for mention in who.mentions:
            words = [
                w.norm
                for w in scene.words[max(0, mention.word - 1) : mention.word + 8]
                if w.sentence == scene.words[mention.word].sentence
            ]
            found = _heading(" ".join(words))
            if found is not None:
                return found
        return None

    own, other = heading(scene.cast.ego), heading(entity)
    if own is None or other is None:
        return None
    return {0: "same", 90: "left", 180: "opposite", 270: "right"}[(other - own) % 360]


def _side_of_events(scene: Scene, entity: Entity) -> str | None:
    for event in scene.events(entity):
        found = side_of_text(event.whole)
        if found and event.act in ("enter_road", "stationary", "reverse", "start"):
            return found
    return None


def _cut_side(scene: Scene, entity: Entity) -> str | None:
    """The side that one who cuts in comes from."""
    for event in scene.events(entity):
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


def _passes_ego(scene: Scene, entity: Entity) -> bool:
    return any(e.act == "overtake" and (e.patient is None or e.patient.ego) for e in scene.events(entity))


def _gains(scene: Scene, entity: Entity) -> bool:
    return any(e.act == "approach" and re.search(r"behind|rear|back", e.whole) for e in scene.events(entity)) or any(
        e.act == "approach" and e.text.startswith("close") for e in scene.events(entity)
    )


def _before_junction(text: str) -> bool:
    return bool(re.search(r"before the (intersection|junction)|in the oncoming lane", text))


def _ego_parked(scene: Scene) -> bool:
    return any(e.act == "stationary" and "park" in e.whole for e in scene.events(scene.cast.ego))


def _speed(
    scene: Scene,
    entity: Entity,
    kind: str,
    phases: list,
    ego: EgoSpec,
    placement: Placement,
    place: PlaceSpec,
    assumed: list[Assumption],
    own_id: str,
) -> float | tuple[float, float] | None:  # noqa: ANN001
    said = scene.speeds.get(entity)
    defaults = language.table("defaults")
    first = phases[0].action if phases else None
    begins = next((e for e in scene.events(entity) if e.act not in ("approach", "lead", "held_up")), None)
    waited = (
        begins is not None
        and begins.act == "stationary"
        and first in ("cut_in", "lane_change", "turn_left", "turn_right", "go_straight", "run_red", "run_stop")
    )
    standing = (
        waited
        or first in ("stationary", "wait", "start", "enter_road")
        or "stationary" in entity.roles
        and first in (None, "stationary")
        or placement.position in ("parked",)
        or kind
        not in (
            "car",
            "truck",
            "van",
            "bus",
            "police_car",
            "ambulance",
            "fire_truck",
            "motorcycle",
            "bicycle",
            *PERSONS,
        )
    )
    if said is not None and not (standing and said[1] == 0):
        low, high = said[0], said[1]
        if standing and first in (None, "stationary"):
            return 0.0
        return round(low, 2) if high - low < 0.05 else (round(low, 2), round(high, 2))
    if first == "reverse":
        assumed.append(Assumption(field="speed", value="9 km/h", reason="a usual speed backwards"))
        return 2.5
    if standing:
        return (
            None
            if kind
            not in (
                "car",
                "truck",
                "van",
                "bus",
                "motorcycle",
                "police_car",
                "ambulance",
                "fire_truck",
                "bicycle",
                "pedestrian",
                "child",
                "animal",
            )
            else 0.0
            if first not in ("cross_road", "enter_road") or kind not in PERSONS
            else None
        )
    if kind in PERSONS or kind == "bicycle":
        text = " ".join(e.text for e in scene.events(entity))
        key = "running" if kind == "pedestrian" and re.search(r"\b(run|dart|dash|rush|sprint|jog|bolt)", text) else kind
        value = defaults["types"][key]
        assumed.append(Assumption(field="speed", value=f"{value['value']} m/s", reason=value["reason"]))
        return float(value["value"])
    own = ego.speed if isinstance(ego.speed, int | float) else (sum(ego.speed) / 2 if ego.speed else 12.0)
    own = own or 8.0
    text = " ".join(e.text for e in scene.events(entity)) + " " + " ".join(t for _, t in scene.where(entity).phrases)
    factor = "same"
    if "slow" in entity.roles or re.search(r"\b(crawl|creep|trundle|slow(ly|er)?|dawdle|grind|inch|plod|chug)\b", text):
        factor = "slow"
    elif any(p.action == "overtake" and p.target == own_id for p in ego.phases) or _passed_by_another(scene, entity):
        factor = "slow"
    elif (
        placement.position == "beside"
        and any(p.action == "cut_in" for p in phases)
        or placement.along == "abreast"
        and any(p.action == "cut_in" for p in phases)
    ):
        factor = "gaining"
    elif (
        placement.along == "behind"
        and placement.position in ("left_lane", "right_lane")
        or "fast" in entity.roles
        or any(p.action == "overtake" for p in phases)
        or placement.position == "behind"
        and any(p.action == "collide" for p in phases)
    ):
        factor = "fast"
    elif (
        placement.position == "ahead"
        and not any(p.action in ("brake", "stop", "follow") for p in phases)
        and any(
            e.act in ("approach", "overtake", "held_up", "collide") and (e.patient is entity)
            for e in scene.events(scene.cast.ego)
        )
    ):
        factor = "slow"
    value = defaults["factors"][factor]
    speed = round(max(2.0, own * value["value"]), 2)
    if placement.position.startswith("crossing") or placement.position == "opposite_approach":
        return None
    assumed.append(Assumption(field="speed", value=f"{speed * 3.6:.0f} km/h", reason=value["reason"]))
    return speed


def _passed_by_another(scene: Scene, entity: Entity) -> bool:
    """Whether another road user (not ego) overtakes this one: it is slower."""
    return any(e.act == "overtake" and e.patient is entity and e.done and not e.agent.ego for e in scene.clauses.events)


def settle(scene: Scene, ego: EgoSpec, place: PlaceSpec, drafts: list[Draft], ids: dict[Entity, str]) -> EgoSpec:
    """Ego's spec once all objects are known (nobody is referred to who is not there); no object beyond the outer lanes."""
    if place.kind == "on_ramp":
        for draft in drafts:
            at = draft.spec.placement
            if at.position in ("right_lane", "left_lane") or at.position == "beside":
                moved = at.model_copy(
                    update={
                        "position": "left_lane" if at.position != "beside" else "beside",
                        "side": "left" if at.position == "beside" else None,
                    }
                )
                draft.spec = draft.spec.model_copy(update={"placement": moved})
    outer = {
        "leftmost": ("left_lane", "right_lane", "left", "right"),
        "rightmost": ("right_lane", "left_lane", "right", "left"),
    }
    lane = place.ego_lane if place.ego_lane in outer else None
    for draft in drafts if lane else ():
        wrong, right, side_wrong, side_right = outer[lane]  # type: ignore[index]
        at = draft.spec.placement
        if at.of == "ego" and (at.position == wrong or at.position == "beside" and at.side == side_wrong):
            moved = at.model_copy(
                update={
                    "position": right if at.position == wrong else "beside",
                    "side": at.side if at.position == wrong else side_right,
                }
            )
            draft.spec = draft.spec.model_copy(
                update={
                    "placement": moved,
                    "phases": tuple(
                        p.model_copy(update={"side": side_wrong}) if p.action == "cut_in" else p
                        for p in draft.spec.phases
                    ),
                }
            )
    known = {"ego", *(f"O{n}" for n in range(1, len(drafts) + 1))}
    aside = next((p.side for p in ego.phases if p.action == "lane_change"), None)
    for draft in drafts if aside else ():
        # ego makes room: who comes from behind in its lane just drives on past it
        if draft.spec.placement.position == "behind" and draft.spec.placement.of == "ego":
            kept = tuple(p for p in draft.spec.phases if not (p.action == "overtake" and p.target == "ego"))
            draft.spec = draft.spec.model_copy(update={"phases": kept})
    react = ego.react_to if ego.react_to in known else None
    return ego.model_copy(update={"react_to": react})


def signs(scene: Scene, place: PlaceSpec, number: int) -> list[Draft]:
    """Signs that the text names and that are no road users: they stand as props where the map has none."""
    found = []
    if (
        scene.road.stop_sign
        and not any(e.type == "stop_sign" for e in scene.actors)
        and place.kind == "intersection"
        and place.control != "stop"
    ):
        found.append(
            Draft(
                None,
                ObjectSpec(name="stop_sign", type="stop_sign", placement=Placement(position="roadside", side="right")),
            )
        )
    return found

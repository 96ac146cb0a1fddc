"""Where an object starts: position, side, gap, what hides it."""

import re

from c2s_engine.interpret.mentions import ZONES, Entity
from c2s_engine.interpret.placing_people import person
from c2s_engine.interpret.placing_vehicles import vehicle
from c2s_engine.interpret.relations import Where, side_of_text
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import Placement, PlaceSpec


def place_object(
    scene: Scene, entity: Entity, ids: dict[Entity, str], place: PlaceSpec, assumed: list[Assumption]
) -> Placement:
    where = scene.where(entity)
    acts = [e.act for e in scene.events(entity)]
    values = (person if entity.person or entity.type == "bicycle" else _thing if not entity.mover else vehicle)(
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
        if place.ego_lane == {"left": "leftmost", "right": "rightmost"}[where.lane] and where.of is None:
            return {"position": "ahead", "said": True}
        return {"position": f"{where.lane}_lane", "along": "ahead", "said": True}
    if where.lane == "oncoming":
        return {"position": "oncoming_lane", "said": True}
    if entity.type in ZONES and edge and where.lane is None:
        return {"position": "roadside", "side": edge, "said": True}
    if where.rel == "behind":
        return {"position": "behind", "said": True}
    return {"position": "ahead", "said": where.rel is not None or where.lane is not None}

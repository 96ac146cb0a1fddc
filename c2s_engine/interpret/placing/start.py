"""Where an object starts: position, side, gap, what hides it."""

from c2s_engine.interpret.placing.people import person
from c2s_engine.interpret.placing.stated_gaps import gap_of
from c2s_engine.interpret.placing.vehicles import vehicle
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.where.relations import Where, side_of_text
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Placement, PlaceSpec

UNSAID = "the text does not say where it starts"


def place_object(
    scene: Scene, entity: Entity, ids: dict[Entity, str], place: PlaceSpec, ego: EgoSpec, assumed: list[Assumption]
) -> Placement:
    where = scene.where(entity)
    acts = [e.act for e in scene.events(entity)]
    values = (person if entity.person or entity.type == "bicycle" else _thing if not entity.mover else vehicle)(
        scene, entity, where, acts, place
    )
    if not values.pop("said", False):
        assumed.append(Assumption(field="placement.position", value=values["position"], reason=UNSAID))
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
    gap = gap_of(scene, entity, values["position"], ego)
    if gap is not None:
        low, high = sorted(gap)
        values["gap"] = round(low, 1) if high - low < 0.5 else (round(low, 1), round(high, 1))
    return Placement(of=of, hidden_by=hidden if hidden != "ego" else None, **values)


def _thing(scene: Scene, entity: Entity, where: Where, acts: list[str], place: PlaceSpec) -> dict:
    text = " ".join(t for _, t in where.phrases)
    edge = where.side or side_of_text(text)
    if where.lane in ("parked", "roadside", "sidewalk"):
        return {
            "position": "sidewalk" if where.lane == "sidewalk" else "roadside",
            "side": edge or "right",
            "said": True,
        }
    if where.lane in ("left", "right"):
        if place.ego_lane == {"left": "leftmost", "right": "rightmost"}[where.lane] and where.of is None:
            return {"position": "ahead", "said": True}
        return {"position": f"{where.lane}_lane", "along": "ahead", "said": True}
    if where.lane == "oncoming":
        return {"position": "oncoming_lane", "said": True}
    if where.rel == "behind":
        return {"position": "behind", "said": True}
    return {"position": "ahead", "said": where.rel is not None or where.lane is not None}

"""Where along the road one is or comes to be, seen from ego."""

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene


def along_of(rel: str | None) -> str:
    return {"ahead": "ahead", "behind": "behind", "beside": "abreast"}.get(rel or "", "ahead")


def passes_ego(scene: Scene, entity: Entity) -> bool:
    return any(e.act == "overtake" and (e.patient is None or e.patient.ego) for e in scene.events(entity))

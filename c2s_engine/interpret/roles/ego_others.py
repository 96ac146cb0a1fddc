"""To whom ego's acts are directed where the clause does not name it; signs and lights that it obeys."""

from collections.abc import Sequence

from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import Phase, PlaceSpec


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


def free_side(place: PlaceSpec) -> str:
    return "right" if place.ego_lane == "leftmost" else "left"


def way_back(phases: Sequence[Phase]) -> str | None:
    """The side on which the lane lies from which the last step to a side went, None where there was none."""
    gone = next((p.side for p in reversed(phases) if p.side and p.action in ("lane_change", "oncoming", "drift")), None)
    return {"left": "right", "right": "left"}.get(gone or "")


def in_lane_conflict(scene: Scene, place: PlaceSpec) -> bool:
    return any(e.mover or e.type not in ("warning_sign",) for e in scene.actors)

"""How fast ego is at first: as said, else as what happens with the others needs it."""

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import Phase, PlaceSpec


def ego_pace(
    scene: Scene, ids: dict[Entity, str], place: PlaceSpec, phases: list[Phase], assumed: list[Assumption]
) -> float | tuple[float, float] | None:
    said = scene.speeds.get(scene.cast.ego)
    if said is not None:
        low, high = said[0], said[1]
        return round(low, 2) if high - low < 0.05 else (round(low, 2), round(high, 2))
    lead = next(
        (
            e
            for e in scene.actors
            for p in phases
            if p.action == "follow" and ids.get(e) == p.target and e in scene.speeds
        ),
        None,
    )
    if lead is not None:
        low, high = scene.speeds[lead][0], scene.speeds[lead][1]
        if not any(e.act in ("approach", "brake") and e.agent.ego for e in scene.clauses.events):
            assumed.append(
                Assumption(
                    field="speed", value=f"{low * 3.6:.0f} km/h", reason="it follows at the speed of the one ahead"
                )
            )
            return round((low + high) / 2, 2)
    if phases and phases[0].action in ("stationary", "enter_road", "start", "wait"):
        assumed.append(Assumption(field="speed", value="0 km/h", reason="it stands at first"))
        return 0.0
    table = language.table("defaults")["speeds"]
    key = (
        place.kind if place.kind in table and place.kind not in ("road", "curve") else scene.road.setting or place.kind
    )
    if place.kind in ("straight",):
        key = scene.road.setting or "road"
    entry = table.get(key, table["road"])
    value, reason = float(entry["value"]), entry["reason"]
    if place.speed_limit and place.kind not in ("intersection", "roundabout"):
        value, reason = (
            round(min(value * 1.4, place.speed_limit), 2),
            language.table("defaults")["limits"]["maximum_from_limit"]["reason"],
        )
    if any(p.action == "reverse" for p in phases[:1]):
        value, reason = 3.0, "a usual speed backwards"
    assumed.append(Assumption(field="speed", value=f"{value * 3.6:.0f} km/h", reason=reason))
    return value

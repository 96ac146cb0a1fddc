"""How fast ego is at first: as said, else as what happens with the others needs it."""

from c2s_engine.interpret import language
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import Phase, PlaceSpec

FASTER = 1.3
"""How much faster one is before it brakes to a speed."""


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
    flow = _speed_among_others(scene, ids, phases)
    if flow is not None and not (
        phases and phases[0].action in ("stationary", "enter_road", "start", "wait", "reverse")
    ):
        value, reason = flow
        assumed.append(Assumption(field="speed", value=f"{value * 3.6:.0f} km/h", reason=reason))
        return value
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


def _speed_among_others(scene: Scene, ids: dict[Entity, str], phases: list[Phase]) -> tuple[float, str] | None:
    """Ego's speed as what happens with the others needs it, whose speeds are told: (m/s, why)."""
    factors = language.table("defaults")["factors"]
    targets = {p.target for p in phases if p.action in ("overtake", "collide")}
    for entity in sorted(scene.actors, key=lambda e: ids.get(e) not in targets):
        said, where = scene.speeds.get(entity), scene.where(entity)
        if (
            said is None
            or entity not in ids
            or not entity.mover
            or entity.person
            or entity.type == "bicycle"
            or said[1] < 3
        ):
            continue
        if where.lane in ("oncoming", "crossing", "parked", "roadside") or "oncoming" in entity.roles:
            continue
        acts = scene.events(entity)
        passes = any(e.act == "overtake" and (e.patient is None or e.patient.ego) for e in acts)
        caught = ids[entity] in targets or any(
            e.act in ("approach", "held_up") and e.patient is entity and e.agent.ego
            for e in scene.clauses.events
            if e.done
        )
        if any(e.act in ("turn", "go_straight", "run_red", "cross_path") for e in acts) and where.rel is None:
            continue
        follows = _keeps_behind(scene, entity)
        gains = where.rel == "behind" and not follows
        name = "closing" if caught else "passed" if passes or gains else "flow"
        if (
            name == "flow"
            and where.rel is None
            and where.lane not in ("left", "right", "same")
            and "lead" not in entity.roles
            and not follows
        ):
            continue
        factor = factors[name]
        return round(min(50.0, max(3.0, (said[0] + said[1]) / 2 * factor["value"])), 2), factor["reason"]
    return None


def _keeps_behind(scene: Scene, entity: Entity) -> bool:
    """Whether one follows ego, and neither comes up, passes nor hits it: it is as fast as ego."""
    acts = scene.events(entity)
    behind = scene.where(entity).rel == "behind" and any(e.act == "travel" for e in acts)
    follows = any(e.act == "follow" and (e.patient is None or e.patient.ego) for e in acts)
    gains = any(e.act in ("approach", "overtake", "collide", "cut_in", "held_up") for e in acts)
    return (behind or follows) and not gains

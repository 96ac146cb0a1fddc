"""How fast an object is at first: as said, else as what happens needs it."""

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS, PERSONS, URGENT, Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Placement


def pace_of(
    scene: Scene,
    entity: Entity,
    kind: str,
    phases: list,
    ego: EgoSpec,
    placement: Placement,
    assumed: list[Assumption],
    own_id: str) -> float | tuple[float, float] | None:  # noqa: ANN001
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
        or kind not in MOVERS
    )
    if said is not None and not (standing and said[1] == 0):
        low, high = said[0], said[1]
        if standing and first in (None, "stationary"):
            return 0.0
        return round(low, 2) if high - low < 0.05 else (round(low, 2), round(high, 2))
    held = (
        ego.phases and ego.phases[0].action == "stationary" and placement.position == "ahead" and placement.of == "ego"
    )
    if held and not scene.events(entity) and entity.mover and not entity.person and said is None:
        assumed.append(Assumption(field="speed", value="0 km/h", reason="ego stands behind it"))
        return 0.0
    if first == "reverse":
        assumed.append(Assumption(field="speed", value="9 km/h", reason="a usual speed backwards"))
        return 2.5
    if standing:
        return (
            None
            if kind not in MOVERS
            else 0.0
            if first not in ("cross_road", "enter_road") or kind not in PERSONS
            else None
        )
    own = ego.speed if isinstance(ego.speed, int | float) else (sum(ego.speed) / 2 if ego.speed else 12.0)
    own = own or 8.0
    if kind in PERSONS or kind == "bicycle":
        text = " ".join(e.text for e in scene.events(entity))
        key = "running" if kind == "pedestrian" and re.search(r"\b(run|dart|dash|rush|sprint|jog|bolt)", text) else kind
        value = defaults["types"][key]
        assumed.append(Assumption(field="speed", value=f"{value['value']} m/s", reason=value["reason"]))
        return float(value["value"])
    text = " ".join(e.text for e in scene.events(entity)) + " " + " ".join(t for _, t in scene.where(entity).phrases)
    factor = "same"
    if (
        "slow" in entity.roles
        or re.search(
            r"\b(crawl|creep|trundle|slow(ly|er)|dawdle|grind|inch|nudge|plod|chug|roll (forward|ahead|into))\b", text
        )
        or any(p.action == "overtake" and p.target == own_id for p in ego.phases)
    ):
        factor = "slow"
    elif (
        placement.along == "behind"
        and placement.position in ("left_lane", "right_lane")
        or "fast" in entity.roles
        or _hurries(scene, entity, kind, placement)
        or any(p.action == "overtake" for p in phases)
        or placement.position == "behind"
        and placement.of == "ego"
        and any(p.action == "collide" for p in phases)
    ):
        factor = "fast"
    elif (
        placement.position == "ahead"
        and placement.facing != "against"
        and not any(p.action in ("brake", "stop", "follow") for p in phases)
        and (
            any(
                e.act in ("approach", "overtake", "held_up", "collide") and (e.patient is entity)
                for e in scene.events(scene.cast.ego)
            )
        )
    ):
        factor = "slow"
    value = defaults["factors"][factor]
    speed = round(max(2.0, own * value["value"]), 2)
    if placement.position.startswith("crossing") or placement.position == "opposite_approach":
        return None
    assumed.append(Assumption(field="speed", value=f"{speed * 3.6:.0f} km/h", reason=value["reason"]))
    return speed


FAST = re.compile(
    r"\b((at|with) (a )?(very )?(high|great|excessive) speed|(too )?fast|speeding|at speed|rapidly|quickly|tailgat\w+"
    r"|clos(e|es|ing) (in|up)|catch(es|ing)? (up|@ego)|rac(es|ing)|blue lights|sirens?)\b"
)


def _hurries(scene: Scene, entity: Entity, kind: str, placement: Placement) -> bool:
    """Whether it is said to be fast, or is an emergency vehicle that comes from behind."""
    if placement.position == "behind" and kind in URGENT:
        return True
    if any(e.act == "follow" for e in scene.events(entity)):
        return False
    return any(e.agent is entity and FAST.search(e.whole) for e in scene.events(entity))

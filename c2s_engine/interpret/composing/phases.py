"""An object's events become its phases: the steps of a behaviour, without repetitions."""

import re

from c2s_engine.interpret.composing.lasting import lasting
from c2s_engine.interpret.composing.steps import steps_of
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import Phase, Placement, PlaceSpec


def phases_of(
    scene: Scene, entity: Entity, ids: dict[Entity, str], placement: Placement, place: PlaceSpec
) -> list[Phase]:
    """The phases of an object."""
    events = scene.events(entity)
    if not entity.mover:
        return []
    found: list[Phase] = []
    ego_key = ids[scene.cast.ego]
    crossing = placement.position.startswith("crossing") or placement.position == "opposite_approach"
    for event in events:
        who = ids.get(event.patient) if event.patient is not None else None
        halted = bool(found) and found[-1].action in ("stop", "brake")
        if halted and event.act == "stationary" and scene.words[event.word].tag == "VB":
            continue  # it stops "to pick up passengers"
        if event.act == "go_straight" and found and found[-1].action in ("stop", "wait", "yield"):
            found = [p for p in found if p.action != "go_straight"]  # it goes on only then
        found += lasting(event, steps_of(event, entity, who, ego_key, placement, place, crossing, found))
    if "stationary" in entity.roles and not any(p.action not in ("stationary", "wait") for p in found):
        found = [Phase(action="stationary")]
    if entity.person and not found and not entity.roles and placement.position in ("sidewalk", "roadside"):
        near = " ".join(w.norm for w in scene.words[entity.mentions[0].word : entity.mentions[0].word + 7])
        on_it = place.crosswalk and re.search(r"cross|zebra", near) is not None
        comes = re.search(r"\bfrom (?:the |its )?(?:left|right|far|near)\b", near) is not None
        found = [Phase(action="cross_road" if on_it or comes else "stationary")]
    if entity.person and not found and (scene.where(entity).rel == "beside" or _stands(scene, entity)):
        found = [Phase(action="stationary")]
    if "parked" in entity.roles and not found:
        found = [Phase(action="stationary")]
    stands = {"stop", "stationary"} & {p.action for p in found} or entity.roles & {"parked", "stationary"}
    if stands and _run_into(scene, entity):
        found = [p for p in found if p.action != "collide" or p.target == ego_key]  # it is only pushed on
    found = _merged(found)
    if crossing and not any(
        p.action in ("turn_left", "turn_right", "go_straight", "u_turn", "stationary", "collide", "stop", "wait")
        for p in found
    ):
        at = next((i for i, p in enumerate(found) if p.action in ("brake", "stop")), len(found))
        found.insert(at, Phase(action="go_straight"))
    if any(p.action in ("turn_left", "turn_right", "u_turn") for p in found) and place.kind == "intersection":
        found = [p for p in found if p.action != "go_straight"]
    return found[:8]


def _run_into(scene: Scene, entity: Entity) -> bool:
    """Whether ego runs into it."""
    return any(e.act == "collide" and e.patient is entity for e in scene.events(scene.cast.ego))


def _stands(scene: Scene, entity: Entity) -> bool:
    """Whether a person of whom nothing is told is "standing" or "waiting" in a note."""
    first = scene.words[entity.mentions[0].word]
    after = [w.norm for w in scene.words[first.i + 1 : first.i + 9] if w.sentence == first.sentence]
    return bool({"standing", "waiting", "sitting", "kneeling"} & set(after))


def _merged(phases: list[Phase]) -> list[Phase]:
    """Without repetitions; a brake that ends in a stop is one phase."""
    found: list[Phase] = []
    for phase in phases:
        last = found[-1] if found else None
        again = phase.trigger is not None and last is not None and phase.rate != last.rate  # "then brakes fully"
        back = last is not None and last.side and phase.side and last.side != phase.side
        other = last is not None and phase.action == "overtake" and len({last.target, phase.target} - {None}) == 2
        if last is not None and last.action == phase.action and not (again or back or other):
            found[-1] = last.model_copy(update={k: v for k, v in phase if v is not None and getattr(last, k) is None})
            continue
        if last is not None and last.action == "brake" and phase.action == "stop" and phase.trigger is None:
            found[-1] = phase.model_copy(update={"rate": phase.rate or last.rate, "trigger": last.trigger})
            continue
        if last is not None and last.action == "brake" and phase.action in ("wait", "start") and last.speed is None:
            found[-1] = last.model_copy(update={"action": "stop"})
        if (
            last is not None
            and last.action == "stationary"
            and phase.action in ("brake", "go_straight", "lane_change", "stop")
        ):
            found[-1] = phase
            continue
        if (
            last is not None
            and last.action == "start"
            and phase.action
            in (
                "enter_road",
                "cut_in",
                "go_straight",
                "turn_left",
                "turn_right",
                "accelerate",
                "cross_road",
                "move_along",
            )
        ):
            found[-1] = phase if phase.action != "accelerate" else last
            continue
        if (
            last is not None
            and last.action == "enter_road"
            and phase.action in ("start", "lane_change", "cut_in", "stationary")
        ):
            continue
        if last is not None and last.action == "reverse" and phase.action == "enter_road":
            continue
        if last is not None and last.action == "stationary" and phase.action == "yield":
            continue  # it stands "to let a pedestrian over"
        if last is not None and last.action == "lose_control" and phase.action in ("oncoming", "leave_road", "drift"):
            found[-1] = phase
            continue
        found.append(phase)
    if len(found) > 1 and found[0].action == "stationary":
        found = (
            found[1:]
            if found[1].action
            in (
                "enter_road",
                "cut_in",
                "cross_road",
                "reverse",
                "start",
                "turn_left",
                "turn_right",
                "overtake",
                "collide",
            )
            else found
        )
    if any(p.action in ("cross_road",) for p in found):
        found = [p for p in found if p.action != "stationary" or found.index(p) > 0]
    return found

"""What changes once all objects are known: nobody absent is referred to, none stands beyond the outer lanes."""

from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.composing.steps import rate_of, trigger_of
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import EgoSpec, Phase, PlaceSpec


def settle(scene: Scene, ego: EgoSpec, place: PlaceSpec, drafts: list[Draft], ids: dict[Entity, str]) -> EgoSpec:
    """Ego's spec once all objects are known (nobody absent is referred to); no object beyond the outer lanes."""
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
    goes = next((p for p in ego.phases if p.action in ("lane_change", "leave_road", "stop")), None)
    aside = goes.side if goes is not None and goes.action == "lane_change" else None
    for draft in drafts if aside else ():
        # ego makes room: who comes from behind in its lane just drives on past it
        pulls_out = any(p.action == "lane_change" for p in draft.spec.phases)
        if draft.spec.placement.position == "behind" and draft.spec.placement.of == "ego" and not pulls_out:
            kept = tuple(p for p in draft.spec.phases if not (p.action == "overtake" and p.target == "ego"))
            draft.spec = draft.spec.model_copy(update={"phases": kept})
    _open_circles(drafts)
    ego = _brakes_for_nobody(scene, ego, drafts)
    react = ego.react_to if ego.react_to in known else None
    return ego.model_copy(update={"react_to": react})


def _open_circles(drafts: list[Draft]) -> None:
    """Place by ego, or hide by nobody, who would be placed by one that is placed by it in turn."""
    before = {"ego"}
    for number, draft in enumerate(drafts, start=1):
        at = draft.spec.placement
        of = at.of if at.of in before else "ego"
        hidden_by = at.hidden_by if at.hidden_by in before else None
        if (of, hidden_by) != (at.of, at.hidden_by):
            moved = at.model_copy(update={"of": of, "hidden_by": hidden_by})
            draft.spec = draft.spec.model_copy(update={"placement": moved})
        before.add(f"O{number}")


def _brakes_for_nobody(scene: Scene, ego: EgoSpec, drafts: list[Draft]) -> EgoSpec:
    """Ego's spec with a braking of its own where everybody else is behind it: there is nobody to react to."""
    if ego.reaction != "brake" or not drafts or any(p.action in ("brake", "stop") for p in ego.phases):
        return ego
    if any(d.spec.placement.position != "behind" or d.spec.placement.of != "ego" for d in drafts):
        return ego
    told = scene.does(scene.cast.ego, "brake", "brake_stop", "stop")
    if told is None:
        return ego
    action = "brake" if told.act == "brake" else "stop"
    phase = Phase(action=action, rate=rate_of(told), trigger=trigger_of(told))  # type: ignore[arg-type]
    return ego.model_copy(update={"phases": (*ego.phases, phase), "reaction": "none", "hard": False})

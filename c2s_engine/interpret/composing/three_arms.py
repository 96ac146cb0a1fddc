"""A junction with three arms: who comes to it by the side road turns, for nothing lies straight ahead."""

from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.structure.components import Assumption
from c2s_engine.structure.specs import EgoSpec, Phase, PlaceSpec

REASON = "it comes by the side road, where nothing lies straight ahead"


def by_the_side_road(place: PlaceSpec, ego: EgoSpec, drafts: list[Draft]) -> tuple[PlaceSpec, list[Assumption]]:
    """R, where ego stops at the sign and so has the side road: it turns left. Else those turn left, across ego's way,
    who would cross it."""
    if place.arms != 3 or place.manoeuvre not in (None, "straight"):
        return place, []
    crossing = [d for d in drafts if d.spec.placement.position in ("crossing_left", "crossing_right")]
    crossing = [d for d in crossing if any(p.action == "go_straight" for p in d.spec.phases)]
    for draft in crossing:
        draft.spec = draft.spec.model_copy(update={"phases": tuple(map(_turned, draft.spec.phases))})
        draft.assumed.append(Assumption(field="phases", value="turn left", reason=REASON))
    return place, []


def _turned(phase: Phase) -> Phase:
    return phase.model_copy(update={"action": "turn_left"}) if phase.action == "go_straight" else phase

"""What one waits for that another does: "when the lead brakes, the van behind it changes lanes"."""

from __future__ import annotations

from collections.abc import Mapping

from c2s_engine.interpret.composing.delayed import delayed
from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase


def waited_for(scene: Scene, ego: EgoSpec, drafts: list[Draft], ids: Mapping[Entity, str]) -> EgoSpec:
    """Give the phases of the objects and of ego the triggers that clauses about others state; ego's spec then."""
    others: dict[str, ObjectSpec | EgoSpec] = {"ego": ego}
    others |= {ids[d.entity]: d.spec for d in drafts if d.entity is not None}
    for draft in drafts:
        if draft.entity is not None and draft.spec.phases:
            phases = _waiting(scene, draft.entity, draft.spec.phases, ids, others)
            draft.spec = draft.spec.model_copy(update={"phases": phases})
    return ego.model_copy(update={"phases": _waiting(scene, scene.cast.ego, ego.phases, ids, others)})


def _waiting(
    scene: Scene,
    entity: Entity,
    phases: tuple[Phase, ...],
    ids: Mapping[Entity, str],
    others: Mapping[str, ObjectSpec | EgoSpec],
) -> tuple[Phase, ...]:
    found = list(phases)
    return tuple(delayed(scene, entity, found, ids, others))

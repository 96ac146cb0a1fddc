"""What one waits for that another does: "when the lead brakes, the van behind it changes lanes"."""

from __future__ import annotations

from collections.abc import Mapping

from c2s_engine.interpret.composing.delayed import begun, delayed
from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.composing.seen import DONE, ENTERS, MARKS, SEEN, shown
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
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
    for event in scene.events(entity):
        awaited = _awaited(scene, event)
        if awaited is None or awaited.agent not in ids or event.trigger is not None:
            continue
        trigger = shown(scene, awaited, ids[awaited.agent], others)
        at = next((i for i, p in enumerate(found) if p.action in DONE.get(event.act, ()) and p.trigger is None), None)
        if trigger is not None and at is not None:
            found[at : at + 1] = begun(entity, found, at, trigger, None)
    return tuple(delayed(scene, entity, found, ids, others))


def _awaited(scene: Scene, event: Event) -> Event | None:
    """What a clause with "when" or "once" below an event tells of another."""
    for other in scene.clauses.events:
        if other.agent is event.agent or not other.done or scene.clauses.joined_to(other) is not event:
            continue
        if scene.clauses.lasted(event.word) and event.word < other.word:
            continue  # "was changing lanes when the van braked"
        if event.act == "overtake" and other.adverbial == "as":
            continue  # at the same time
        if other.adverbial in MARKS and (other.act in SEEN or other.act in ENTERS):
            return other
    return None

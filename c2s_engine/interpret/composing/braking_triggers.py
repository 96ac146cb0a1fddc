"""Why another brakes, where no word says so: for what was told of somebody just before.

In 7 of 10 scenes of benchmark/reading such a braking has that as its trigger in S by hand; of other actions fewer than
half have, so that those begin as if nothing was said.
"""

from __future__ import annotations

from collections.abc import Mapping

from c2s_engine.interpret.composing.objects import Draft
from c2s_engine.interpret.composing.seen import DONE
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.who.mentions import Entity
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Trigger

NO_REASON = frozenset(("follow", "keep_lane", "stationary", "wait"))
Specs = dict[str, ObjectSpec | EgoSpec]


def braking_triggers(scene: Scene, ego: EgoSpec, drafts: list[Draft], ids: Mapping[Entity, str]) -> None:
    """Give the brakings of objects what another has just done as their trigger."""
    specs: Specs = {"ego": ego, **{ids[d.entity]: d.spec for d in drafts if d.entity is not None}}
    told = _told(scene, ids, specs)
    for (of, first), (whose, at) in zip(told, told[1:], strict=False):
        phase, cause = specs[whose].phases[at], specs[of].phases[first]
        waits = any(p.trigger and p.trigger.of == whose for p in specs[of].phases)
        if whose in ("ego", of) or phase.action != "brake" or phase.trigger or cause.action in NO_REASON or waits:
            continue
        trigger = Trigger(kind="action", of=of, action=cause.action)
        phases = list(specs[whose].phases)
        phases[at] = phase.model_copy(update={"trigger": trigger})
        specs[whose] = specs[whose].model_copy(update={"phases": tuple(phases)})
    for draft in drafts:
        if draft.entity is not None:
            draft.spec = specs[ids[draft.entity]]  # type: ignore[assignment]


def _told(scene: Scene, ids: Mapping[Entity, str], specs: Specs) -> list[tuple[str, int]]:
    """Whose phases, and which of them, events became, in their order."""
    found: list[tuple[str, int]] = []
    events = [e for e in scene.clauses.events if e.done and ids.get(e.agent) in specs]
    for event in sorted(events, key=lambda e: e.order):
        whose, acts = ids[event.agent], DONE.get(event.act, (event.act,))
        phases = enumerate(specs[whose].phases)
        at = next((i for i, p in phases if p.action in acts and (whose, i) not in found), None)
        if at is not None:
            found.append((whose, at))
    return found

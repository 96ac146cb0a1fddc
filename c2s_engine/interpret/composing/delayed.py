"""What comes so long after something else: "2 s later the van cuts in" counts from what was told before."""

from __future__ import annotations

import re
from collections.abc import Mapping

from c2s_engine.interpret.composing.seen import DONE, shown
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase, Trigger

SINCE = re.compile(
    r"#time (?:later|after(?:wards?)?(?! the (?:start|beginning))|thereafter)\b"
    r"|\bafter (?:an?other|a further|further) #time"
)
STILL = frozenset(("stationary", "stop", "wait"))


def delayed(
    scene: Scene,
    entity: Entity,
    phases: list[Phase],
    ids: Mapping[Entity, str],
    others: Mapping[str, ObjectSpec | EgoSpec],
) -> list[Phase]:
    """The phases of one with what is told to come "2 s later" after what it is later than."""
    found = list(phases)
    for event in scene.events(entity):
        told = event.trigger
        if told is None or told["kind"] != "time" or not SINCE.search(event.whole):
            continue
        at = next((i for i, p in enumerate(found) if p.action in DONE.get(event.act, ())), None)
        before = _before(scene, event)
        if at is None or before is None:
            continue
        _phase, lasts = found[at], round(told["value"], 2)
        start = shown(scene, before, ids.get(before.agent, ""), others) if before.agent is not entity else None
        if start is not None:
            found[at : at + 1] = begun(entity, found, at, start, lasts)
    return found


def begun(entity: Entity, phases: list[Phase], at: int, trigger: Trigger | None, late: float | None) -> list[Phase]:
    """A phase as it begins by a trigger, or so long after it: until then one goes on, or waits.

    Of who is on foot only the order is told."""
    if late is None or entity.person:
        return [phases[at].model_copy(update={"trigger": trigger})]
    still = at and phases[at - 1].action in STILL
    pause = Phase(action="wait" if still else "keep_lane", duration=late, trigger=trigger)
    return [pause, phases[at].model_copy(update={"trigger": None})]


def _before(scene: Scene, event: Event) -> Event | None:
    """What was told last before an event, of what can be seen."""
    told = [e for e in scene.clauses.events if e.done and e.act in DONE and e is not event and e.order < event.order]
    return max(told, key=lambda e: e.order, default=None)

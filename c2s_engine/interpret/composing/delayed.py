"""What comes so long after something else: "2 s later the van cuts in" counts from what was told before."""

from __future__ import annotations

import re
from collections.abc import Mapping

from c2s_engine.interpret.composing.lasting import LASTING
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
        at = next((i for i, p in enumerate(found) if p.action in DONE.get(event.act, ()) and _timed(p, told)), None)
        before = _before(scene, event)
        if at is None or before is None:
            continue
        phase, lasts = found[at], round(told["value"], 2)
        if before.trigger is not None and before.trigger["kind"] == "time":
            moment = Trigger(kind="time", value=round(before.trigger["value"] + lasts, 2))
            found[at] = phase.model_copy(update={"trigger": moment})
            continue
        start = shown(scene, before, ids.get(before.agent, ""), others) if before.agent is not entity else None
        if start is not None:
            found[at : at + 1] = begun(entity, found, at, start, lasts)
        elif before.agent is entity and at and found[at - 1].action in LASTING and found[at - 1].duration is None:
            found[at - 1] = found[at - 1].model_copy(update={"duration": lasts})  # "brakes and 2 s later speeds up"
            found[at] = phase.model_copy(update={"trigger": None})
    return found


def begun(entity: Entity, phases: list[Phase], at: int, trigger: Trigger | None, late: float | None) -> list[Phase]:
    """A phase as it begins by a trigger, or so long after it: until then one goes on, or waits.

    Of who is on foot only the order is told."""
    if late is None or entity.person:
        return [phases[at].model_copy(update={"trigger": trigger})]
    still = at and phases[at - 1].action in STILL
    pause = Phase(action="wait" if still else "keep_lane", duration=late, trigger=trigger)
    return [pause, phases[at].model_copy(update={"trigger": None})]


def lateness(scene: Scene, awaited: Event) -> float | None:
    """How long after what a clause tells something comes: "2 s after the lead brakes"."""
    marks = [c for c in scene.words[awaited.word].children if scene.words[c].norm == "after" and c < awaited.word]
    span = scene.words[marks[0] - 1].span if marks and marks[0] else None
    timed = span is not None and span.kind == "quantity" and span.data["dimension"] == "time"
    return round(span.data["low"], 2) if span is not None and timed else None


def _timed(phase: Phase, told: dict[str, object]) -> bool:
    return phase.trigger is not None and phase.trigger.kind == "time" and phase.trigger.value == told["value"]


def _before(scene: Scene, event: Event) -> Event | None:
    """What was told last before an event, of what can be seen."""
    told = [e for e in scene.clauses.events if e.done and e.act in DONE and e is not event and e.order < event.order]
    return max(told, key=lambda e: e.order, default=None)

"""What one road user waits for another to do: "once the bus has stopped, a boy crosses"."""

import re

from c2s_engine.interpret.event import Event
from c2s_engine.interpret.mentions import Entity
from c2s_engine.interpret.objects import Draft
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.specs import Phase, Trigger

PHASES = {
    "brake": ("brake", "stop"),
    "brake_stop": ("stop", "brake"),
    "stop": ("stop", "brake"),
    "turn": ("turn_left", "turn_right", "u_turn"),
    "enter_road": ("enter_road", "cross_road"),
}
"""By what happens, the actions that it may have become, where they are called otherwise."""
SOON = re.compile(r"\bas soon as\b|\bimmediately after\b")


def await_others(scene: Scene, drafts: list[Draft], ids: dict[Entity, str]) -> None:
    """Phases of objects that begin with what another one has done get that as their trigger."""
    of = {d.entity: d for d in drafts if d.entity is not None}
    for event in scene.clauses.events:
        first, then = of.get(event.agent), scene.clauses.joined_to(event)
        later = of.get(then.agent) if then is not None else None
        if first is None or then is None or later is None or first is later or not (event.done and then.done):
            continue
        if not _awaited(scene, event):
            continue
        waits, awaited = _phase(later, then), _phase(first, event)
        if waits is None or awaited is None or waits.trigger is not None:
            continue
        trigger = Trigger(kind="action", of=ids[event.agent], action=awaited.action)
        phases = tuple(p.model_copy(update={"trigger": trigger}) if p is waits else p for p in later.spec.phases)
        later.spec = later.spec.model_copy(update={"phases": phases})


def _awaited(scene: Scene, event: Event) -> bool:
    """Whether the main clause tells what comes after this one, not what is beside it."""
    if event.adverbial in ("once", "after"):
        return True
    around = " ".join(w.norm for w in scene.words[max(0, event.word - 8) : event.word])
    return event.adverbial in ("as", "when") and bool(SOON.search(around))


def _phase(draft: Draft, event: Event) -> Phase | None:
    wanted = PHASES.get(event.act, (event.act,))
    return next((p for p in draft.spec.phases if p.action in wanted), None)

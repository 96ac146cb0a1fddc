"""Said and seen: whether the runs show the actions that a component's phases say."""

import tomllib
from dataclasses import dataclass
from functools import cache

from c2s_engine import paths
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.facts import EGO, ObjectFacts, RunFacts
from c2s_engine.structure.specs import EgoSpec, ObjectSpec, Phase


@dataclass(frozen=True)
class Mark:
    """One action that was said, and in how many of the runs it was seen."""

    component: str
    path: str
    action: str
    runs: int
    seen_in: int

    @property
    def seen(self) -> bool | None:
        """Seen in over half of the runs; None where nothing has run."""
        return None if not self.runs else 2 * self.seen_in > self.runs


@cache
def table() -> dict[str, list[str]]:
    """Action to the events that show it."""
    return tomllib.loads(paths.shipped("seen.toml").read_text("utf-8"))


def marks(structure: Structure, facts: tuple[RunFacts, ...]) -> tuple[Mark, ...]:
    """A mark for every action that leaves an event, in S's order."""
    ran = [f for f in facts if f.ran]
    return tuple(
        mark for c in structure.components for i, phase in enumerate(_phases(c)) for mark in _mark(c, i, phase, ran)
    )


def score(found: tuple[Mark, ...]) -> tuple[int, int]:
    """How many of the actions that were said were seen."""
    counted = [m for m in found if m.seen is not None]
    return sum(1 for m in counted if m.seen), len(counted)


def share(found: tuple[Mark, ...]) -> float:
    """The share of what was said that was seen; 1 where nothing that was said leaves an event."""
    seen, counted = score(found)
    return seen / counted if counted else 1.0


def differences(structure: Structure, facts: tuple[RunFacts, ...]) -> list[str]:
    """A sentence for each action that was said and not seen, with what the component showed instead."""
    ran = [f for f in facts if f.ran]
    found = []
    for mark in marks(structure, facts):
        if mark.seen is not False:
            continue
        shown = [e.event for f in ran[:1] for o in _objects(f, mark.component) for e in o.events]
        instead = f"seen instead: {', '.join(dict.fromkeys(shown))}" if shown else "nothing of note was seen"
        found.append(f"{mark.component}: said {mark.action} ({mark.path}), not seen; {instead}.")
    return found


def _phases(component: Component) -> tuple[Phase, ...]:
    return component.spec.phases if isinstance(component.spec, EgoSpec | ObjectSpec) else ()


def _mark(component: Component, index: int, phase: Phase, ran: list[RunFacts]) -> tuple[Mark, ...]:
    events = list(table().get(phase.action, ()))
    if not events:
        return ()
    if phase.action == "lane_change" and phase.side:
        opposite = "right" if phase.side == "left" else "left"
        events.remove(f"lane_change_{opposite}")
    seen_in = sum(_shown(f, component.id, events, phase.target) for f in ran)
    return (Mark(component.id, f"phases.{index}", phase.action, len(ran), seen_in),)


def _shown(facts: RunFacts, cid: str, events: list[str], target: str | None) -> bool:
    """Whether the component showed one of the events: towards the one it was said about, where both are named."""
    meant = {o.name for o in _objects(facts, "E" if target in ("ego", "E") else target)} if target else set()
    return any(
        e.event in events and (not meant or e.other is None or e.other in meant)
        for o in _objects(facts, cid) for e in o.events
    )  # fmt: skip


def _objects(facts: RunFacts, cid: str) -> list[ObjectFacts]:
    return [o for o in facts.objects if (o.name == EGO if cid == "E" else o.component == cid)]

"""Said and seen: whether the runs show the actions that a component's phases say."""

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

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
    return tomllib.loads((Path(__file__).parent / "seen.toml").read_text("utf-8"))


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


def _phases(component: Component) -> tuple[Phase, ...]:
    return component.spec.phases if isinstance(component.spec, EgoSpec | ObjectSpec) else ()


def _mark(component: Component, index: int, phase: Phase, ran: list[RunFacts]) -> tuple[Mark, ...]:
    events = list(table().get(phase.action, ()))
    if not events:
        return ()
    if phase.action == "lane_change" and phase.side:
        opposite = "right" if phase.side == "left" else "left"
        events.remove(f"lane_change_{opposite}")
    seen_in = sum(any(o.shows(e) for o in _objects(f, component.id) for e in events) for f in ran)
    return (Mark(component.id, f"phases.{index}", phase.action, len(ran), seen_in),)


def _objects(facts: RunFacts, cid: str) -> list[ObjectFacts]:
    return [o for o in facts.objects if (o.name == EGO if cid == "E" else o.component == cid)]

"""Simulation in the loop: what a run did not show goes back as edits of S, kept only where the score rises."""

from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from typing import Any

from c2s_engine.interpret.llm.turn import mend
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import EditError, apply
from c2s_engine.structure.progress import Progress, Say

ROUNDS = 2


@dataclass(frozen=True)
class Outcome:
    """A written S, the share of what it says that its run showed, and what it did not show, a sentence each."""

    structure: Structure
    score: float
    differences: Sequence[str]


Evaluate = Callable[[Structure], Awaitable[Outcome]]
"""Write an S (as far as it is out of date), run it, and compare what was said with what was seen."""


async def improve(
    structure: Structure,
    evaluate: Evaluate,
    *,
    client: OllamaClient,
    reader: Any,
    on_event: Callable[[Progress], None] | None = None,
    rounds: int = ROUNDS,
) -> Outcome:
    """The best outcome after at most `rounds` of the model's edits: no ModelError, and never worse than before."""
    best = await evaluate(structure)
    for _ in range(rounds):
        if not best.differences:
            break
        try:
            edits = await mend(best.differences, best.structure, client=client, reader=reader, on_event=on_event)
            if not edits:
                break
            changed = best.structure
            for edit in edits:
                changed = apply(changed, edit)
            found = await evaluate(changed)
        except (ModelError, EditError, ValueError) as error:
            _say(on_event, f"The run's differences could not be mended. {error}", "warning")
            break
        if found.score <= best.score:
            _say(
                on_event, "A change for the run's differences was dropped: the run showed no more than before.", "info"
            )
            break
        which = ", ".join(sorted({getattr(e, "component", "") or "" for e in edits}))
        _say(on_event, f"Changed after the run: {which}; it now shows {found.score:.0%} of what is said.", "info")
        best = found
    return best


def _say(on_event: Callable[[Progress], None] | None, text: str, severity: Any) -> None:
    if on_event:
        on_event(Say(text=text, severity=severity))

"""How long the steps of a behaviour last, where a clause says so."""

from c2s_engine.interpret.composing.steps import duration_of
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.specs import Phase

LASTING = frozenset(("accelerate", "brake", "follow", "keep_lane", "reverse", "oncoming", "drift", "move_along"))
"""What can go on for a time."""


def lasting(event: Event, phases: list[Phase]) -> list[Phase]:
    """The phases of an event, the only one with the time that it is told to last."""
    if len(phases) != 1 or phases[0].action not in LASTING or phases[0].duration is not None:
        return phases
    duration = duration_of(event)
    return [phases[0].model_copy(update={"duration": duration})] if duration else phases

"""Ego's braking as a step of its own, where the text says from when, how hard or down to which speed."""

from c2s_engine.interpret.composing.steps import duration_of, rate_of, target_speed, trigger_of
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.specs import Phase


def told_braking(event: Event, who: str | None) -> Phase | None:
    """The phase of a braking that is told with its moment, its rate or its final speed; else it only is a reaction."""
    trigger, speed = trigger_of(event), target_speed(event)
    lasts = duration_of(event)
    if trigger is None and speed is None and lasts is None and not _measured(event):
        return None
    return Phase(action="brake", target=who, rate=rate_of(event), speed=speed, duration=lasts, trigger=trigger)


def told_stop(event: Event, who: str | None) -> Phase:
    """The phase of a stop for somebody, with the rate that is told."""
    return Phase(
        action="stop", target=who, rate=rate_of(event) if _measured(event) else None, trigger=trigger_of(event)
    )


def _measured(event: Event) -> bool:
    """Whether the clause states a deceleration, or by how much the speed changes."""
    return any(q["dimension"] in ("acceleration", "change") for q in event.quantities)

"""Ego's braking as a step of its own, where the text says from when, how hard or down to which speed."""

import re

from c2s_engine.interpret.composing.steps import duration_of, rate_of, target_speed, trigger_of
from c2s_engine.interpret.what.event import Event
from c2s_engine.structure.specs import Phase

SHORT_OF = re.compile(
    r"with (?:about |around |some )?#dist"
    r"|#dist (?:to spare|left|short|(?:away )?(?:before|behind|in front of|ahead of|from|off)\b)"
)
"""A distance of whoever stops to the one for whom that is."""


def stated_braking(event: Event, who: str | None) -> Phase | None:
    """The phase of a braking that is told with its moment, its rate or its final speed; else it only is a reaction."""
    trigger, speed = trigger_of(event), target_speed(event)
    lasts = duration_of(event)
    if trigger is None and speed is None and lasts is None and not _measured(event):
        return None
    return Phase(action="brake", target=who, rate=rate_of(event), speed=speed, duration=lasts, trigger=trigger)


def stated_stop(event: Event, who: str | None) -> Phase:
    """The phase of a stop for somebody, with the rate that is told, and how far before that one ego stands then."""
    room = next((q["low"] for q in event.quantities if q["dimension"] == "distance" and who), None)
    short = room if room and SHORT_OF.search(event.text) else None
    rate = rate_of(event) if _measured(event) else None
    return Phase(action="stop", target=who, rate=rate, clearance=short, trigger=trigger_of(event))


def _measured(event: Event) -> bool:
    """Whether the clause states a deceleration, or by how much the speed changes."""
    return any(q["dimension"] in ("acceleration", "change") for q in event.quantities)

"""Who lets people on and off: others pass it, so that it is not whom the text is about."""

import re

from c2s_engine.interpret.what.event import Event

AT_A_STOP = re.compile(
    r"^(?:be|stop|halt|wait|pull (?:in|up)) (?:\w+ )?at (?:an?|the|its) (?:\w+ )?stop\b(?! sign| line| light)"
)


def at_a_stop(event: Event) -> bool:
    """Whether somebody stops at a bus stop."""
    return AT_A_STOP.match(event.text) is not None

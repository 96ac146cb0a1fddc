"""Who stops in the middle of the road on foot has set out to cross it; who goes after one who crosses crosses, too."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event

MIDDLE = re.compile(
    r"\b(?:(?:in|at|on|near) (?:the )?(?:very )?(?:middle|centre|center) of|halfway|half way|midway|"
    r"mid-?(?:street|road|crossing|lane|block))\b|\bin the (?:middle|centre|center)$"
)
SETS_OUT = frozenset(("cross_road", "enter_road", "cross_path", "cut_in", "cut_out"))


def go_after(clauses: Clauses) -> None:
    """ "A child runs across the street, followed by a dog": the dog crosses, too."""
    crossing = {e.agent for e in clauses.events if e.act == "cross_road" and e.done}
    for event in [e for e in clauses.events if e.act == "go_after"]:
        if event.done and crossing and event.patient in (None, *crossing) and event.agent not in crossing:
            event.act = "cross_road"


def set_out(clauses: Clauses) -> None:
    """A crossing before a stop "in the middle of the road", where none is told of."""
    for event in list(clauses.events):
        if event.act not in ("stop", "brake_stop") or not event.done or not event.agent.person:
            continue
        told = any(e.agent is event.agent and e.act in SETS_OUT and e.done for e in clauses.events)
        if not told and MIDDLE.search(event.text.rstrip(" .,;")):
            clauses.events.append(Event.echo(event, act="cross_road", order=event.order - 0.1))

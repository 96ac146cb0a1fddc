"""Passing by the lane of oncoming traffic, passing because ego waits, and titles that only name the subject."""

import re

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

UP_BEHIND = re.compile(r"\bcome (?:up )?(?:from )?behind (?:the )?@")
UP_BEHIND_NEAR = 12
"""Words within which one goes past whom it came up behind."""


def came_up_behind(clauses: Clauses) -> None:
    """Who comes up behind another and goes past, passes that one: "came up from behind her, went past"."""
    ups = [e for e in clauses.events if e.act in ("approach", "travel", "follow") and UP_BEHIND.search(e.whole)]
    for event in [e for e in clauses.events if e.act == "overtake" and e.patient is None]:
        near = (e for e in ups if e.agent is event.agent and 0 < event.word - e.word < UP_BEHIND_NEAR)
        event.patient = next((e.patient for e in near), None)
    _between_the_lines(clauses)


def headings(cast: Cast, clauses: Clauses) -> None:
    """A title about merging ("Cooperative merging with three agents") does not say that ego does it."""
    told = {cast.words[m.word].sentence for m in cast.ego.mentions}
    for event in clauses.events:
        number = cast.words[event.word].sentence
        title = number == 0 and number not in cast.told and number not in told and bool(told)
        if title and event.agent.ego and event.act == "lane_change" and "merg" in cast.words[event.word].norm:
            event.mode = "hypothetical"


OTHER_LANE = re.compile(
    r"\b(?:on|in|via|by|over|using|through|into) (?:the )?(?P<lane>on-?coming|opposite|opposing|other|wrong) "
    r"(?:traffic )?(?:lane|side)\b(?! of (?:the )?@)"
)


OVER_LINE = re.compile(
    r"\bover (?:the |a )?(?:\w+ )?(?:solid|double|continuous|unbroken|yellow|white|cent(?:re|er)|middle)"
    r"(?: \w+){0,2} ?(?:lines?)?\b"
)
BETWEEN_LINES = re.compile(r"\bbetween (?:the |two |both |stationary |slow )*(?:lines|rows|queues|columns|lanes) of\b")


def _others_by_that_lane(clauses: Clauses, road: Road) -> None:
    """Who gets past ego by the lane of oncoming traffic, or over the line, gets into that lane."""
    for event in [e for e in clauses.events if e.act == "overtake" and e.done and e.agent.mover and not e.agent.ego]:
        where = OTHER_LANE.search(event.text)
        over = where is not None and where["lane"] != "other" or OVER_LINE.search(event.text) is not None
        own = [e for e in clauses.events if e.act in ("oncoming", "lane_change") and e.agent is event.agent and e.done]
        if over and not own and road.kind != "motorway" and (event.patient is None or event.patient.ego):
            clauses.events.append(Event.echo(event, act="oncoming", order=event.order - 0.1, side="left"))


def _between_the_lines(clauses: Clauses) -> None:
    """Who comes up between two lines of others comes past ego, too: "filtering up between the lines of cars"."""
    for event in clauses.events:
        if event.act == "overtake" and not event.agent.ego and BETWEEN_LINES.search(event.text):
            event.patient = None


def by_the_other_lane(clauses: Clauses, road: Road) -> None:
    """Who gets past by the lane of oncoming traffic gets into it."""
    _others_by_that_lane(clauses, road)
    if any(e.act == "oncoming" and e.agent.ego for e in clauses.events) or road.kind == "motorway":
        return
    for event in list(clauses.events):
        where = OTHER_LANE.search(event.text)
        over = where is not None and (where["lane"] != "other" or (road.lanes or 1) == 1)
        changes = event.done and event.agent.ego and event.act == "lane_change"
        if over and changes:
            event.act, event.side = "oncoming", "left"  # "as nothing was coming I went out into the other lane"
            return
        if not (event.done and event.agent.ego and event.act in ("overtake", "evade") and where):
            continue
        if where["lane"] == "other" and (road.lanes or 1) > 1:
            continue
        clauses.events.append(Event.echo(event, act="oncoming", order=event.order - 0.1, side="left"))
        return

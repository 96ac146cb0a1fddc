"""Who "pulled out", no more being told: it comes onto the road, or on a motorway into ego's lane."""

from __future__ import annotations

import re

from c2s_engine.interpret.surroundings.place import Road
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import MOTOR, Cast, Entity

BARE = re.compile(
    r"pull out(?: (?:suddenly|abruptly|unexpectedly|right|straight|quickly|slowly|at the last (?:moment|second)))*"
    r"(?= (?:and|but|as|when|while|so|because|without|just)\b| ?[.,;]| ?$)"
)
PLACED = re.compile(r"\b(?:lane|ahead|in front|behind|beside|alongside|overtak\w+|pass\w*|onto|into|from|of)\b")
NEW = frozenset(("a", "an", "another", "some"))


def pulled_out(cast: Cast, clauses: Clauses, road: Road) -> None:
    """Let who is nowhere yet and pulls out come onto the road."""
    for event in clauses.events:
        if event.act != "lane_change" or event.agent.ego or event.agent.type not in MOTOR | {"vehicle"}:
            continue
        if not BARE.match(event.text) or PLACED.search(event.whole) or not _new(event.agent, event.word, cast):
            continue
        if road.kind not in ("intersection", "roundabout"):
            event.act = "enter_road"


def _new(who: Entity, word: int, cast: Cast) -> bool:
    """Whether it is named for the first time, and nothing is told of where it is."""
    first = cast.words[who.mentions[0].word] if who.mentions else None
    if first is None or first.sentence != cast.words[word].sentence or who.roles:
        return False
    return bool(NEW & {cast.words[c].norm for c in first.children}) and not cast._distinguished(first)

"""What begins only when something else is over: a wait, a time that one drives on, what one does not do until."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from c2s_engine.interpret.what.modes import Modes

if TYPE_CHECKING:
    from c2s_engine.interpret.what.event import Event

GOES_ON = ("travel", "keep_lane", "lead", "approach")


class Afterwards(Modes):
    """The part of Clauses that passes the end of one thing on as the beginning of the next."""

    events: list[Event]
    by_word: dict[int, Event]

    def _held_back(self) -> None:
        """What one does not do until something is done comes after that: "does not move until the bus has gone"."""
        for event in self.events:
            if event.mode != "negated":
                continue
            for child in self.words[event.word].children:
                other = self.by_word.get(child)
                if other is not None and other.adverbial in ("until", "till") and other.agent is not event.agent:
                    event.mode, event.order = "fact", max(event.order, other.order) + 0.2
                    other.adverbial = "once" if other.act != "cross_road" else "until"  # one is seen at that before


    def _ended_waits(self) -> None:
        """What ends a wait ("until ego is 20 m away, then crosses") begins what comes next."""
        for event in self.events:
            until = event.trigger is not None and re.search(r"\b(?:until|till)\b", self.render(self._deep(event.word)))
            if event.act not in ("stationary", "stop", "move_along", *GOES_ON) or not until:
                continue
            later = [e for e in self.events if e.agent is event.agent and e.order > event.order and e.trigger is None]
            if later:
                min(later, key=lambda e: e.order).trigger = event.trigger
                event.trigger = None

    def _deep(self, i: int) -> list[int]:
        found = [i]
        for child in self.words[i].children:
            found += self._deep(child)
        return sorted(found)

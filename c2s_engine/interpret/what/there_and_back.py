"""Who leaves his lane and comes back: the way back leads to the other side."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.overtakings import HOME

COMES_BACK = re.compile(
    r"(?:come|get|go|move|steer|swing|pull|slip|drive|cut|find (?:its|his|her) way) (?:\w+ly |just |right )?back\b"
    r"(?! (?:and forth|to|in|into|onto|over) (?!(?:its|his|her|their|the) (?:own |correct |proper |right )*"
    r"(?:lane|side|half)\b)\w)"
)
"""How one comes back over the line, where nothing is said of the lane."""


def there_and_back(clauses: Clauses) -> None:
    """A change back goes to the other side: "drifts to the left ... moves back into its lane"."""
    for event in clauses.events:
        if event.act not in ("lane_change", "cut_in") or not event.done or not HOME.search(event.text):
            continue


def swerves_back(clauses: Clauses) -> None:
    """Who swerves round something and comes back in front of ego has been there: it does not cut in."""
    for event in clauses.events:
        if event.act != "cut_in" or not event.done or event.agent.ego or not HOME.search(event.text):
            continue

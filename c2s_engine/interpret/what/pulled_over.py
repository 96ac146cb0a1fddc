"""Who "had pulled over" before the story begins stands at the side of the road."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import MOTOR
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event

PULLED = re.compile(
    r"(?:pull|draw|move|drive|turn|park|steer|come|coast|roll)\w* (?:(?:well|right|safely|completely|partly) )*"
    r"(?:(?:over|in|up|aside)\b(?! (?:@|front|behind|between|the (?:left|right|other|next) lane|with\b))"
    r"|(?:off (?:the |of the )?(?:road|roadway|highway|carriageway|side)"
    r"|(?:on|to|onto|into|off to|off onto) (?:the |an? |its )?(?:[\w-]+ )?"
    r"(?:shoulder|verge|lay-?by|side of|roadside|emergency lane|kerb|curb|grass|breakdown lane)))"
)
ACTS = frozenset(
    (
        "turn_or_change",
        "leave_road",
        "lane_change",
        "stop",
        "brake_stop",
        "cut_out",
        "cut_in",
        "turn",
        "travel",
        "drift",
        "exit_road",
    )
)


def had_pulled_over(clauses: Clauses) -> None:
    """Let such a one stand, at the roadside where it is another than ego."""
    for event in clauses.events:
        if event.act not in ACTS or event.mode != "fact" or event.agent.type not in MOTOR:
            continue
        if _had(clauses, event) and PULLED.match(event.text):
            event.act, event.patient = "stationary", None
            event.text = event.whole = "stand"
            if not event.agent.ego:
                event.agent.roles.add("parked")


def _had(clauses: Clauses, event: Event) -> bool:
    """Whether it was over before: "had pulled over", "was pulled over" by somebody."""
    helpers = {clauses.words[c].norm for c in clauses.words[event.word].children if c < event.word}
    whom = any(clauses.words[c].dep == "dobj" and c in clauses.cast.of for c in clauses.words[event.word].children)
    return bool({"had", "having"} & helpers) and not whom

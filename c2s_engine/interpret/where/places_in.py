"""The phrases of a clause that tell where somebody starts."""

import re
from collections.abc import Iterator

from c2s_engine.interpret.what.event import Event

PLACE = re.compile(
    r"\b(?:from|out of|off|leave|in|on|along|ahead of|behind) (?!to)[^,.;]*?(?=(?<!\bfrom) from\b|[,.;]|$)"
)
ORIGIN = re.compile(r"from|out of|off|leave")
DONE_THERE = frozenset(
    (
        "brake",
        "stop",
        "brake_stop",
        "accelerate",
        "run_red",
        "turn",
        "keep_lane",
        "lose_control",
        "cross_path",
        "overtake",
    )
)
"""What is done where one starts: "brakes in the left lane"."""
INTO = re.compile(r"\b(into|onto|to|towards) (the |its )?(@\w+ ''?s )?[\w -]*?(lane|road|street|path|way)\b")
OF_PATH = re.compile(r"\b(in front of|ahead of) (the )?@\w+")

LANE_OF_EGO = re.compile(r"(?<=@ego) (?:in|on) the (?:[\w-]+ )?lane\b")
"""In which lane ego is whom another cuts off or passes."""
HALTS_AT = re.compile(r"(?<=ahead|front) (?:stop|halt) (?:at|in|by) .*$")
"""Where one halts that is told to be ahead: it starts there, not where it halts."""
WHY = re.compile(r"\b(?:due to|because of|owing to|caused by) [^,.;]*")
"""Why it is done: where somebody else is."""
PASSES_IN = re.compile(r"in the (?:left|right|middle|cent(?:er|re))(?:-hand)? lane\b")


def _passed_there(event: Event, part: str) -> bool:
    """Whether it is said where another is overtaken, not where one starts."""
    whom = event.agent.ego or event.patient is not None or not PASSES_IN.match(part)
    return event.act == "overtake" and whom and re.match(r"in|on|ahead", part) is not None


def places_in(event: Event) -> Iterator[str]:
    """Each such phrase, without where one goes and whose path is crossed."""
    whole = LANE_OF_EGO.sub("", event.whole) if event.act in ("cut_in", "overtake") else event.whole
    for match in PLACE.finditer(WHY.sub(" ", whole)):
        left = event.act != "leave_road" or "lane" in match[0]  # what is left is the road, unless a lane is named
        if left and (ORIGIN.match(match[0]) or event.act in DONE_THERE):
            part = INTO.sub("", match[0])
            part = HALTS_AT.sub("", part)
            if _passed_there(event, part):
                continue
            yield OF_PATH.sub("", part) if event.act in ("cross_path", "turn") else part

"""The side towards which an event goes."""

import re

from c2s_engine.interpret.what.event import Event

OPPOSITE = {"left": "right", "right": "left"}
"""The other side."""


ORIGIN = re.compile(
    r"\b(?:from|out of) (?:the |its |a |an )?(?:[\w-]+ ){0,2}(?:lane|path|track|bay|shoulder|space|strip)"
    r" (?:on|to|at) (?:the |its )(?P<side>left|right)\b(?! lane)"
)
"""A place on one side that one leaves: it goes towards the other side."""


BEND = re.compile(
    r"\b(?:bends?|curves?|corner)\b(?: \w+){0,2}? (?:to|towards) (?:the )?(?:left|right)\b"
    r"|\b(?:left|right)(?:-hand)? (?:bend|curve|corner)\b"
)
"""The course of the road, which is not that of who drives there."""


def side(event: Event) -> str | None:
    """The side towards which an event goes."""
    origin = ORIGIN.search(event.text)
    text = BEND.sub("", ORIGIN.sub("", event.text))
    for pattern in (
        r"(?:to|onto|into|toward|towards|on|over|in)(?: \w+){0,4}? (left|right)\b",
        r"\b(left|right)(?:ward|wards|-hand)?\b(?! of way)",
    ):
        for match in re.finditer(pattern, text):
            before = text[max(0, match.start(1) - 12) : match.start(1)]
            if event.act == "overtake" and re.match(r"in\b", match[0]):
                continue
            if re.search(r"from (the |its |@\w+ 's )?$", before):
                continue
            return match[1]
    return event.side or (OPPOSITE[origin["side"]] if origin else None)

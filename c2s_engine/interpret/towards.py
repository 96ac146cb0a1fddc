"""The side towards which an event goes."""

import re

from c2s_engine.interpret.event import Event


def side(event: Event) -> str | None:
    """The side towards which an event goes."""
    text = event.text
    for pattern in (
        r"(?:to|onto|into|toward|towards|on|over|in)(?: \w+){0,4}? (left|right)\b",
        r"\b(left|right)(?:ward|wards|-hand)?\b(?! of way)",
    ):
        for match in re.finditer(pattern, text):
            before = text[max(0, match.start(1) - 12) : match.start(1)]
            if (
                event.act == "overtake"
                and re.match(r"in\b", match[0])
                and "lane" in text[match.end() : match.end() + 12]
            ):
                continue
            if re.search(r"from (the |its |@\w+ 's )?$", before):
                continue
            return match[1]
    return event.side

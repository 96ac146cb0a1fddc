"""The other lane of two in one direction: the next one, not the one of those who come the other way."""

import re

OTHER = re.compile(r"\bother (?:(?:traffic|travel|through|open|free) )?lane\b")
ENDS = re.compile(
    r"\blanes? (?:\w+ ){0,2}(?:ends?|ending|narrows?|merges?|becomes?|drops?|closes?|closed)\b"
    r"|\b(?:ending|ends?|closed|dropped) lane\b"
    r"|\blane drop\b|\b(?:two|2) lanes (?:in)?to (?:one|1|a single)\b"
)


DRIVES = frozenset(("travel", "approach", "keep_lane"))

"""Verbs that are left out because they were just said, by data/language/elided.yaml: "has to stop but does not"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement


@cache
def _signs() -> list[tuple[re.Pattern[str], str]]:
    data = language.table("elided")
    words: dict[str, str] = data["words"]
    return [
        (re.compile(re.sub(r"<(\w+)>", lambda m: words[m[1]], find), re.IGNORECASE), new) for find, new in data["signs"]
    ]


def elided(text: str) -> list[Replacement]:
    """What is said of a verb that is left out, with the verb."""
    return [(m.start(), m.end(), m.expand(new)) for pattern, new in _signs() for m in pattern.finditer(text)]

"""Turns of phrase read in plainer words, by data/language/rephrased.yaml: "has to stop but does not", "the moment ego
is 20 m away"."""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement


@cache
def _phrases() -> list[tuple[re.Pattern[str], str]]:
    data = language.table("rephrased")
    words: dict[str, str] = data["words"]
    return [
        (re.compile(language.filled(find, words), re.IGNORECASE), new)
        for section in data["phrases"].values()
        for find, new in section
    ]


def rephrased(text: str) -> list[Replacement]:
    """What is read instead of each such phrase."""
    return [(m.start(), m.end(), m.expand(new)) for pattern, new in _phrases() for m in pattern.finditer(text)]

"""What ends the run: "the test ends when the ego has stopped or hits the target", "end condition: collision"."""

import re
from collections.abc import Iterator
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.what.clauses import Clauses

ENDINGS = frozenset(("collide", "stop", "brake_stop", "stationary"))
"""What may end a run and is not told to happen by that."""


@cache
def _patterns(section: str) -> list[re.Pattern[str]]:
    data = language.table("endings")
    return [re.compile(language.filled(find, data["words"])) for find in data[section]]


def run_ends(plain: str, sentences: list[tuple[int, int]], clauses: Clauses) -> list[tuple[int, int]]:
    """Where the conditions stand that end the run; what stops or hits there is not told to happen."""
    found = [(match.start(), at, stop) for match, at, stop in _conditions(plain, sentences, "ends")]
    criteria = [(match.start(), at, stop) for match, at, stop in _conditions(plain, sentences, "criteria")]
    for event in clauses.events if found or criteria else ():
        at = clauses.words[event.word].start
        judged = event.act == "collide" and any(start <= at < stop for start, _, stop in criteria)
        passed = event.act in ("overtake", "pass_by") and any(start <= at < when for start, when, _ in criteria)
        if judged or passed or event.act in ENDINGS and any(start <= at < stop for start, _, stop in found):
            event.mode = "hypothetical"
    return [(at, stop) for _, at, stop in found]


def _conditions(plain: str, sentences: list[tuple[int, int]], section: str) -> Iterator[tuple[re.Match[str], int, int]]:
    """What leads to a condition, and where the condition stands: up to the end of its sentence."""
    last = 0
    for match in sorted((m for p in _patterns(section) for m in p.finditer(plain)), key=lambda m: m.start()):
        stop = next((end for start, end in sentences if start <= match.end() - 1 < end), len(plain))
        if match.end() >= last:
            yield match, match.end(), stop
            last = stop

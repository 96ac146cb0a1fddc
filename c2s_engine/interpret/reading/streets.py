"""Names of streets that are common nouns, too: "from Pine onto Bush"."""

import re

from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.spans import Span

ON_STREET = re.compile(
    r"\b(?:on|onto|along|off|down|up|from|at|of|and) (?:(?:north|south|east|west)(?:bound)? )?$", re.IGNORECASE
)
"""Before the name of a street."""


def without_streets(text: str, names: list[Span]) -> list[Span]:
    """The names without those things that stand where a street is named, with a capital and no article."""
    return [n for n in names if not _street(text, n)]


def _street(text: str, name: Span) -> bool:
    if name.kind != "actor" or name.data.get("type") in MOVERS or name.data.get("roles"):
        return False
    word = text[name.start : name.end]
    capital = word[:1].isupper() and not word.isupper() and not text[: name.start].isupper()
    return capital and ON_STREET.search(text[: name.start]) is not None

"""Names with a number and no second of the kind: "car1" or "truck_1" beside ego is "the car" or "the truck"."""

import re
from collections import defaultdict

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.rewritten import Replacement

NUMBERED = re.compile(
    rf"\b(?P<noun>{'|'.join([*language.table('ego')['labels']['typed'], 'car'])})[ _]?(?P<number>[1-9])\b"
    r"(?![.,]?\d| ?(?:m|km|s|g|%|mph|kph|metres?|meters?)\b)",
    re.IGNORECASE,
)
EGO = re.compile(r"\bego\b", re.IGNORECASE)


def only_one(text: str) -> list[Replacement]:
    """What such names stand for; nothing where ego has no name of its own, by which "car 1" may be ego."""
    if not EGO.search(text):
        return []
    found: defaultdict[str, list[re.Match[str]]] = defaultdict(list)
    for match in NUMBERED.finditer(text):
        found[match["noun"].lower()].append(match)
    alone = [m for all_ in found.values() if len({m["number"] for m in all_}) == 1 for m in all_]
    return [(m.start(), m.end(), text) for m in alone]

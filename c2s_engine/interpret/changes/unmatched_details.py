"""What a change says that S does not: numbers, places and parts that the component named does not hold."""

import re
from functools import cache
from typing import Any, get_args

from c2s_engine.interpret.changes.refer import refer
from c2s_engine.interpret.reading import amounts, scan
from c2s_engine.structure import vocabulary as v
from c2s_engine.structure.components import Component, Structure
from c2s_engine.structure.quantity import ends
from c2s_engine.structure.specs import AnySpec

NEAR = 0.06
"""By how much two numbers may differ that are the same when told."""


@cache
def vocabulary_words() -> frozenset[str]:
    """The words of the vocabulary for places and parts that mean nothing else."""
    of_parts = {w for part in get_args(v.Part) for w in part.split("_")}
    whole = {p for p in (*get_args(v.Position), *get_args(v.EgoLane)) if "_" not in p}
    return frozenset(of_parts | whole)


def unmatched_details(plain: str, structure: Structure) -> list[str]:
    """The numbers, places and parts in a text that nobody holds of whom it speaks, as they are said."""
    spans = [s for s in scan.names(plain) if s.kind in ("actor", "label", "ego")]
    meant = [refer(f"the {plain[s.start : s.end]}", structure, alone=False) for s in spans]
    named: list[Component] = [c for c in meant if c is not None] or list(structure.components)
    specs = [c.spec for c in (*named, structure.place, structure.settings)]
    numbers, words = _held(specs)
    found = [
        plain[s.start : s.end].strip()
        for s in amounts.quantities(plain)
        if not any(abs(a - s.data["low"]) < NEAR and abs(b - s.data["high"]) < NEAR for a, b in numbers)
    ]
    bare = plain
    for span in spans:
        bare = f"{bare[: span.start]}{' ' * (span.end - span.start)}{bare[span.end :]}"
    said = re.findall(r"[a-z]+", re.sub(r"\bin front of\b", "ahead", bare))
    return [*found, *(w for w in dict.fromkeys(said) if w in vocabulary_words() - words)]


def _held(specs: list[AnySpec]) -> tuple[list[tuple[float, float]], set[str]]:
    """All numbers, and the words of all names of the vocabulary, that specs hold."""
    numbers: list[tuple[float, float]] = []
    words: set[str] = set()

    def take(value: Any) -> None:
        if isinstance(value, dict):
            for part in value.values():
                take(part)
        elif (both := ends(value)) is not None:
            numbers.append(both)
        elif isinstance(value, list | tuple):
            for part in value:
                take(part)
        elif isinstance(value, str):
            words.update(value.split("_"))

    for spec in specs:
        take(spec.model_dump())
    return numbers, words

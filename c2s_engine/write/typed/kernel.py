"""The driving kernel: the few functions and behaviours that generated programs share, emitted only where used."""

import re
from functools import cache
from importlib.resources import files

ORDER = (
    "way", "approach", "pocket", "ring_approach", "along", "bend_start", "straight_on",
    "need", "most_need", "passed", "ttc", "pace", "meeting", "amid", "meet", "strike", "due", "lurk", "gain", "level",
    "lead_on", "drive", "ram", "turn_round", "backwards", "back_into", "walk",
)  # fmt: skip
_NAMES = {
    "drive": "Drive",
    "ram": "Ram|near|touch",
    "turn_round": "TurnRound",
    "backwards": "Backwards",
    "back_into": "BackInto",
    "walk": "Walk",
}
_CALLED = {"most_need": "need", "due": "strike", "level": "lead_on", "amid": "meeting"}
"""The part that another one calls, besides those that all programs have."""


@cache
def source(name: str) -> str:
    """The Scenic text of one kernel part."""
    return (files("c2s_engine.write.typed.kernel_parts") / f"{name}.scenic").read_text()


def needed(code: str) -> frozenset[str]:
    """The kernel parts whose names a piece of code uses."""
    found = {p for p in ORDER if re.search(rf"\b(?:{_NAMES.get(p, p)})\(", code)}
    return frozenset(found | {_CALLED[p] for p in found if p in _CALLED})


def text(parts: frozenset[str]) -> str:
    """Their Scenic text, in a fixed order."""
    return "\n\n".join(source(p).rstrip("\n") for p in ORDER if p in parts)

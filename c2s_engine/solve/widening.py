"""One number becomes a range as far as the sampled scenes still show what is required: a scenario is a distribution."""

from collections.abc import Awaitable, Callable

from c2s_engine.solve.unknowns import Unknown, chosen, unknowns
from c2s_engine.structure.components import Structure
from c2s_engine.write.typed import ResolveError
from c2s_engine.write.typed.usual_values import usual_values

RUNS = 10
"""Scenes that are sampled of each width."""
LEAST = 0.9
"""The share of them that must show all that is required."""
SHARES = (0.2, 0.1)
"""By how much of its value a field varies to either side, the widest first."""
SECONDS = 1.0
"""s of which such a share is taken where one comes later: its value may be 0."""
REASON = "left open: varied as far as at least 90 % of the sampled scenes show what is described"
FIELDS = ("gap", "speed", "rate", "distance", "trigger", "later")


async def widened(structure: Structure, room: float,
                  share_whole: Callable[[Structure], Awaitable[float]]) -> Structure:  # fmt: skip
    """S with ranges for what the text left open, one after the other, each as wide as holds; S itself where none do.

    `share_whole`: of `RUNS` sampled scenes of an S, how many show all that is required.
    """
    for unknown in _open(structure, room):
        for share in SHARES:
            changed = chosen(structure, unknown, _range(unknown, share), REASON)
            if changed is not structure and await share_whole(changed) >= LEAST:
                structure = changed
                break
    return structure


def _open(structure: Structure, room: float) -> list[Unknown]:
    try:
        open_ = unknowns(structure, usual_values(structure, room))
    except ResolveError:
        return []
    return [u for u in open_ if u.path.rsplit(".", 1)[-1] in FIELDS]


def _range(unknown: Unknown, share: float) -> tuple[float, float]:
    least, most = unknown.limits
    width = share * (SECONDS if unknown.path.endswith("later") else unknown.value)
    return round(max(least, unknown.value - width), 2), round(min(most, unknown.value + width), 2)

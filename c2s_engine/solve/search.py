"""A bounded climb: what is tried is kept where more of what is required is seen, or by more."""

from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass
from typing import Any

from c2s_engine.solve.moves import Move, moves
from c2s_engine.solve.unknowns import Field, chosen, unknowns
from c2s_engine.structure.components import Structure
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.write.typed import ResolveError
from c2s_engine.write.typed.usual_values import Usual, usual_values

MOST = 12
"""Runs that one search may cost."""
ENDING = ("soon_over",)
"""Checks of the run's length, which is chosen exactly."""


@dataclass(frozen=True)
class Outcome:
    """What an S came to: its requirements with their results; `kept`: whatever the caller wants back of it."""

    structure: Structure
    requirements: tuple[Requirement, ...]
    results: tuple[Result, ...]
    kept: Any = None

    @property
    def failing(self) -> list[tuple[Requirement, Result]]:
        """What was not seen, the worst first."""
        pairs = zip(self.requirements, self.results, strict=True)
        return sorted((p for p in pairs if not p[1].holds), key=lambda p: p[1].robustness or -1.0)

    @property
    def score(self) -> tuple[int, float, int]:
        """How many were not seen (negative), then by how much they fail; last what the run's length sets right."""
        failing = [(q, r) for q, r in self.failing if q.check not in ENDING]
        missed = sum(r.robustness if r.robustness is not None else -1.0 for _, r in failing)
        return -len(failing), missed, len(failing) - len(self.failing)


Evaluate = Callable[[Structure], Awaitable[Outcome | None]]
"""Write, run and judge an S; None where it does not run."""


async def solve(first: Outcome, evaluate: Evaluate, room: float, *, most: int = MOST,
                freed: tuple[Field, ...] = ()) -> Outcome:  # fmt: skip
    """The best outcome found: `first` where nothing is better. It is bounded in runs and not in time: the same S gives
    the same program on a slow machine, too.

    `freed`: fields that the text says and that may be changed nevertheless."""
    best, tried = first, 0
    seen = {_open_values(first.structure, room, freed)}
    while best.failing and tried < most:
        better = None
        for changed in _candidates(best, room, freed):
            key = _open_values(changed, room, freed)
            if key in seen or tried >= most:
                continue
            seen.add(key)
            tried += 1
            found = await evaluate(changed)
            if found is not None and found.score > best.score:
                better = found
                break
        if better is None:
            break
        best = better
    return best


def _candidates(outcome: Outcome, room: float, freed: tuple[Field, ...]) -> Sequence[Structure]:
    """What may be better than an S, the most promising first."""
    structure = outcome.structure
    try:
        usual = usual_values(structure, room)
    except ResolveError:
        return ()
    open_ = unknowns(structure, usual, freed)
    return [_with(structure, move) for move in moves(structure, outcome.failing, open_, usual) if move]


def _with(structure: Structure, move: Move) -> Structure:
    for unknown, value in move:
        structure = chosen(structure, unknown, value)
    return structure


def _open_values(structure: Structure, room: float, freed: tuple[Field, ...]) -> tuple[tuple[str, str, float], ...]:
    """What is chosen for all unknowns: what tells one candidate from another."""
    try:
        usual = usual_values(structure, room)
    except ResolveError:
        usual = Usual()
    return tuple((u.component, u.path, u.value) for u in unknowns(structure, usual, freed))

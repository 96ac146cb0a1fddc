"""A bounded climb: what is tried is kept where more of what is required is seen, or by more."""

import math
from collections.abc import Awaitable, Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from c2s_engine.solve.moves import Move, ending_of, moves
from c2s_engine.solve.unknowns import Field, Unknown, chosen, unknowns
from c2s_engine.structure.components import Structure
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.write.typed import ResolveError
from c2s_engine.write.typed.usual_values import Usual, usual_values

MOST = 12
"""Runs that one search may cost, besides the last that only sets the run's length."""
FLAT = 0.01
"""By how little a measure differs (m, m/s, s) where an unknown does nothing for it."""
INSIDE = 0.3
"""Of its bounds' width, how far inside them a measure is brought."""
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
    known = [_Known(first, _open_values(first.structure, room, freed))]
    seen = [known[0].values]
    without_room: list[dict[Field, float]] = []
    while best.failing and tried < most:
        better, now = None, _open_values(best.structure, room, freed)
        for changed in _candidates(best, known, room, freed):
            values = _open_values(changed, room, freed)
            if values in seen or tried >= most or any(_beyond(values, w, now) for w in without_room):
                continue
            seen.append(values)
            tried += 1
            found = await evaluate(changed)
            if found is None:
                without_room.append(values)
                continue
            known.append(_Known(found, values))
            if found.score > best.score:
                better = found
                break
        if better is None:
            break
        best = better
    return await _ended(best, evaluate, room, freed)


async def _ended(best: Outcome, evaluate: Evaluate, room: float, freed: tuple[Field, ...]) -> Outcome:
    """The outcome with the run's length set right where that is all that can be: something may not be seen at all."""
    try:
        open_ = unknowns(best.structure, usual_values(best.structure, room), freed)
    except ResolveError:
        return best
    for move in ending_of(best.failing, open_):
        found = await evaluate(_with(best.structure, move))
        if found is not None and found.score > best.score:
            return found
    return best


@dataclass(frozen=True)
class _Known:
    """What was tried: what it came to, with the value of each unknown."""

    outcome: Outcome
    values: dict[Field, float]


def _beyond(values: dict[Field, float], other: dict[Field, float], ran: dict[Field, float]) -> bool:
    """Whether values go as far as those of another that does not run, or further, in what sets that apart from one that
    ran, and are the same in all else but the run's length."""
    apart = {field: value - ran.get(field, value) for field, value in other.items() if field[0] != "T"}
    beyond = {field: values.get(field, math.nan) - other[field] for field in apart}
    return any(apart.values()) and all(beyond[f] * by >= 0 if by else beyond[f] == 0 for f, by in apart.items())


def _candidates(outcome: Outcome, known: Sequence[_Known], room: float,
                freed: tuple[Field, ...]) -> Iterator[Structure]:  # fmt: skip
    """What may be better than an S, the most promising first; `known`: what was tried so far, which grows."""
    structure = outcome.structure
    try:
        usual = usual_values(structure, room)
    except ResolveError:
        return
    open_ = unknowns(structure, usual, freed)
    others = moves(structure, outcome.failing, open_, usual)
    tried = 0
    for move in others:
        length = len(move) == 1 and move[0][0].component == "T"  # which is exact
        while tried < len(known) and not length:  # what is known by now may tell how far
            tried += 1
            yield from (_with(structure, found) for found in _along(outcome, known[tried - 1], open_, known) if found)
        if move:
            yield _with(structure, move)


def _along(outcome: Outcome, other: _Known, open_: Sequence[Unknown], known: Sequence[_Known]) -> Iterator[Move]:
    """Where an unknown that alone was another in `other` made what is measured another, as much of it as brings that
    within its bounds, by the slope (secant); not as far as what was tried that way already, and was no better."""
    unknown = _apart_by(other, open_)
    if unknown is None:
        return
    was = {r.requirement: r.value for r in other.outcome.results}
    alike = [k.values[unknown.component, unknown.path] for k in known if _apart_by(k, open_) == unknown]
    for _, result in outcome.failing:
        before = was.get(result.requirement)
        if result.value is None or result.bounds is None or before is None or abs(before - result.value) < FLAT:
            continue
        low, high = result.bounds
        inside = INSIDE * (high - low) if math.isfinite(high - low) else 0.0
        goal = low + inside if result.value < low else high - inside
        slope = (before - result.value) / (other.values[unknown.component, unknown.path] - unknown.value)
        due = unknown.value + (goal - result.value) / slope
        no_further = all(abs(due - unknown.value) < abs(v - unknown.value) for v in alike
                         if (v > unknown.value) == (due > unknown.value))  # fmt: skip
        if unknown.limits[0] <= due <= unknown.limits[1] and no_further:
            yield unknown.set_to(due, 2)


def _apart_by(other: _Known, open_: Sequence[Unknown]) -> Unknown | None:
    """The one unknown, the run's length aside, that was another in what was tried; None where several were, or none."""
    differ = [u for u in open_ if u.component != "T" and other.values.get((u.component, u.path), u.value) != u.value]
    return differ[0] if len(differ) == 1 else None


def _with(structure: Structure, move: Move) -> Structure:
    for unknown, value in move:
        structure = chosen(structure, unknown, value)
    return structure


def _open_values(structure: Structure, room: float, freed: tuple[Field, ...]) -> dict[Field, float]:
    """What is chosen for all unknowns: what tells one candidate from another."""
    try:
        usual = usual_values(structure, room)
    except ResolveError:
        usual = Usual()
    return {(u.component, u.path): u.value for u in unknowns(structure, usual, freed)}

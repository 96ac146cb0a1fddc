"""What cannot all be shown: which numbers of the text contradict one another, and what would resolve it."""

import time
from collections.abc import AsyncIterator
from dataclasses import dataclass

from c2s_engine.solve.search import Evaluate, Outcome, solve
from c2s_engine.solve.unknowns import Unknown, chosen, find, said, unknowns
from c2s_engine.structure.components import Structure
from c2s_engine.structure.facts import component_of
from c2s_engine.write.typed import ResolveError
from c2s_engine.write.typed.usual_values import usual_values

TIMES = (1.5, 0.7, 0.55, 2.5, 0.4, 4.0, 9.0)
"""Of a number's value, what is tried for it."""
MOST = 8
"""Runs for which the search goes on from the best of them."""
SECONDS = 30.0
"""s after which no further number is looked at."""


@dataclass(frozen=True)
class Relaxation:
    """One number of the text that alone resolves what is not shown, where it has another value (SI units)."""

    said: Unknown
    value: float


async def relaxations(first: Outcome, evaluate: Evaluate, room: float) -> AsyncIterator[Relaxation]:
    """Each number of the text with which, changed alone (and with what is open), all that S requires is shown; the
    value is the nearer of the one found and half way to it.

    Numbers that each resolve it alone are those without which there is no contradiction: each set of fields that
    contradict one another holds all of them.
    """
    until = time.monotonic() + SECONDS
    for number in _concerned(first, room):
        if time.monotonic() >= until:
            return
        found = await _without(number, first, evaluate, room)
        if found.failing:
            continue
        value = _value(found.structure, number, room)
        half = number.within((number.value + value) / 2)
        nearer = await evaluate(chosen(found.structure, number, half)) if half not in (value, number.value) else None
        yield Relaxation(number, half if nearer is not None and not nearer.failing else value)


async def _without(number: Unknown, first: Outcome, evaluate: Evaluate, room: float) -> Outcome:
    """The best that is found where a number may be another: a search from the best of some values of it."""
    best = first
    for value in dict.fromkeys(number.within(number.value * times) for times in TIMES):
        found = await evaluate(chosen(first.structure, number, value)) if value != number.value else None
        if found is not None and found.score > best.score:
            best = found
    return await solve(best, evaluate, room, most=MOST, freed=((number.component, number.path),))


def _concerned(outcome: Outcome, room: float) -> list[Unknown]:
    """The numbers that the text says of those who take part in what is not shown, of ego and of the place."""
    who = {component_of(w) for q, _ in outcome.failing for w in (q.actor, q.other) if w} | {"E", "R", "T"}
    try:
        return [u for u in said(outcome.structure, usual_values(outcome.structure, room)) if u.component in who]
    except ResolveError:
        return []


def _value(structure: Structure, number: Unknown, room: float) -> float:
    """What S says for a number now."""
    key = (number.component, number.path)
    now = find(unknowns(structure, usual_values(structure, room), (key,)), *key)
    return number.value if now is None else now.value

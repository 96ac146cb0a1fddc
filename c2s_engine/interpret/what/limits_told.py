"""What must be kept to all along: "no more than 6 m/s2", "shall not collide". Nobody does anything by that."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast, Entity


@dataclass(frozen=True)
class LimitTold:
    """A bound in the text: of what, for whom, towards whom, from and up to which value (SI), and where it stands."""

    kind: str
    subject: Entity
    other: Entity | None
    minimum: float | None
    maximum: float | None
    span: tuple[int, int]


@cache
def _pattern(name: str) -> re.Pattern[str]:
    return re.compile(language.table("limits")[name])


def limits_told(
    plain: str, sentences: list[tuple[int, int]], quantities: list[Span], cast: Cast, clauses: Clauses
) -> list[LimitTold]:
    """The bounds; their values are taken from the events, which do not reach them."""
    found = [t for start, end in sentences for t in _of_sentence(plain, start, end, quantities, cast, clauses)]
    bounded = {t.span[1] for t in found}
    for event in clauses.events:
        event.quantities = [q for q in event.quantities if q["end"] not in bounded]
    quantities[:] = [q for q in quantities if q.end not in bounded]
    return found


def _of_sentence(
    plain: str, start: int, end: int, quantities: list[Span], cast: Cast, clauses: Clauses
) -> Iterator[LimitTold]:
    demanded = _pattern("demanded").search(plain, start, end) is not None
    for quantity in (q for q in quantities if start <= q.start < end):
        before = plain[start : quantity.start]
        above, below = _pattern("upper").search(before), _pattern("lower").search(before)
        kind = _kind(quantity.data["dimension"], before, plain[quantity.end : end])
        if not kind or not (above or below) or not demanded and quantity.data["dimension"] != "acceleration":
            continue
        at = start + (above or below).start()  # type: ignore[union-attr]
        subject, other = _whose(cast, clauses, start, quantity.start)
        low, high = (None, quantity.data["high"]) if above else (quantity.data["low"], None)
        yield LimitTold(kind, subject, other if kind == "gap" else None, low, high, (at, quantity.end))
    for event in clauses.events:
        if event.act == "collide" and event.mode == "negated" and start <= event.start < end and demanded:
            yield LimitTold("collision", event.agent, event.patient, None, None, (event.start, event.end))
    if demanded and (none := _pattern("untouched").search(plain, start, end)):
        subject, _ = _whose(cast, clauses, start, none.start())
        yield LimitTold("collision", subject, None, None, None, none.span())


def _kind(dimension: str, before: str, behind: str) -> str:
    """What is bounded; empty where it is nothing that can be."""
    around = before + behind
    if dimension == "acceleration":
        if _pattern("sideways").search(around):
            return "lateral_acceleration"
        return "deceleration" if _pattern("braking").search(around) else "acceleration"
    if dimension == "distance":
        return "gap" if _pattern("distance").search(around) else ""
    return "speed" if dimension == "speed" else ""


def _whose(cast: Cast, clauses: Clauses, start: int, at: int) -> tuple[Entity, Entity | None]:
    """Whom it binds, and towards whom: of the event that began last before it in its sentence; else ego."""
    near = [e for e in clauses.events if start <= e.start <= at]
    if not near:
        return cast.ego, None
    event = max(near, key=lambda e: e.start)
    return event.agent, event.patient

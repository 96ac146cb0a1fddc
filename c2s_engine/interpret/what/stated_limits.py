"""What must be kept to all along: "no more than 6 m/s2", "shall not collide". Nobody does anything by that."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.reading.scan import Span
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast, Entity

SLOWS = ("brake", "stop")
"""Acts whose acceleration is one that slows down."""


@dataclass(frozen=True)
class StatedLimit:
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


def stated_limits(
    plain: str, sentences: list[tuple[int, int]], quantities: list[Span], cast: Cast, clauses: Clauses
) -> list[StatedLimit]:
    """The bounds; their values are taken from the events, which do not reach them."""
    found = [t for start, end in sentences for t in _of_sentence(plain, start, end, quantities, cast, clauses)]
    bounded = {t.span[1] for t in found}
    for event in clauses.events:
        event.quantities = [q for q in event.quantities if q["end"] not in bounded]
    quantities[:] = [q for q in quantities if q.end not in bounded]
    return found


def _of_sentence(
    plain: str, start: int, end: int, quantities: list[Span], cast: Cast, clauses: Clauses
) -> Iterator[StatedLimit]:
    demanded = _pattern("demanded").search(plain, start, end) is not None
    for quantity in (q for q in quantities if start <= q.start < end):
        before = plain[start : quantity.start]
        above, below = _pattern("upper").search(before), _pattern("lower").search(before)
        event = _bound(clauses, start, quantity.start)
        slows = event is not None and event.act in SLOWS
        kind = _kind(quantity.data["dimension"], before, plain[quantity.end : end], slows)
        if not kind or not (above or below) or not demanded and quantity.data["dimension"] != "acceleration":
            continue
        at = start + (above or below).start()  # type: ignore[union-attr]
        subject, other = (event.agent, event.patient) if event is not None else (cast.ego, None)
        low, high = (None, quantity.data["high"]) if above else (quantity.data["low"], None)
        yield StatedLimit(kind, subject, other if kind == "gap" else None, low, high, (at, quantity.end))
    for event in clauses.events:
        if event.act == "collide" and event.mode == "negated" and start <= event.start < end and demanded:
            yield StatedLimit("collision", event.agent, event.patient, None, None, (event.start, event.end))
    if demanded and (none := _pattern("untouched").search(plain, start, end)):
        event = _bound(clauses, start, none.start())
        yield StatedLimit("collision", event.agent if event is not None else cast.ego, None, None, None, none.span())


def _kind(dimension: str, before: str, behind: str, slows: bool) -> str:
    """What is bounded, of one who slows down or not; empty where it is nothing that can be."""
    around = before + behind
    if dimension == "acceleration":
        if _pattern("sideways").search(around):
            return "lateral_acceleration"
        return "deceleration" if slows or _pattern("braking").search(around) else "acceleration"
    if dimension == "distance":
        return "gap" if _pattern("distance").search(around) else ""
    return "speed" if dimension == "speed" else ""


def _bound(clauses: Clauses, start: int, at: int) -> Event | None:
    """What is bounded, and whom it binds, and towards whom: the event that began last before it in its sentence."""
    near = [e for e in clauses.events if start <= e.start <= at]
    return max(near, key=lambda e: e.start) if near else None

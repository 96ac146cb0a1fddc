"""Stretches of a text."""

from collections.abc import Container
from dataclasses import dataclass, field
from typing import Any


@dataclass
class Span:
    """A stretch of the text that was recognised as a whole."""

    kind: str
    start: int
    end: int
    data: dict[str, Any] = field(default_factory=dict)


def names_one(span: Span | None, types: Container[str]) -> bool:
    """Whether a span names ego, somebody by a label, or a road user of one of those types."""
    if span is None or span.kind != "actor":
        return span is not None and span.kind in ("ego", "label")
    return span.data["type"] in types

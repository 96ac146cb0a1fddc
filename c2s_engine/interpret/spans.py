"""Stretches of a text."""

from dataclasses import dataclass, field
from typing import Any


@dataclass
class Span:
    """A stretch of the text that was recognised as a whole."""

    kind: str
    start: int
    end: int
    data: dict[str, Any] = field(default_factory=dict)

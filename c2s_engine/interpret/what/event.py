"""Something that happens, as data."""

from dataclasses import dataclass, field
from typing import Any

from c2s_engine.interpret.who.mentions import Entity


@dataclass(eq=False)
class Event:
    """Something that an entity does, with the words that say so."""

    act: str
    agent: Entity
    word: int
    text: str  # the clause from the verb on
    whole: str  # the clause with what stands before the verb
    patient: Entity | None = None
    mode: str = "fact"  # fact, intended, negated, hypothetical, purpose
    hard: bool = False
    order: float = 0.0
    start: int = 0
    end: int = 0
    words: list[int] = field(default_factory=list)
    quantities: list[dict[str, Any]] = field(default_factory=list)
    trigger: dict[str, Any] | None = None
    side: str | None = None
    passive: bool = False
    adverbial: str = ""  # the word that joins its clause to the main one (when, after, before...)
    also: list[Entity] = field(default_factory=list)

    @classmethod
    def echo(cls, other: "Event", **changes: Any) -> "Event":
        """Another event that the words of one tell, too: its agent, clause and place."""
        kept = ("act", "agent", "word", "text", "whole", "order", "start", "end")
        return cls(**{name: getattr(other, name) for name in kept} | {"words": [*other.words]} | changes)

    @property
    def done(self) -> bool:
        return self.mode in ("fact", "intended", "purpose")

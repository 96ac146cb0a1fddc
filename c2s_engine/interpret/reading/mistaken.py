"""Verbs that the parser takes for something else, each with one that it knows: it parses the sentence once more."""

from c2s_engine.interpret.spans import Span

Piece = tuple[str, int, int, Span | None]

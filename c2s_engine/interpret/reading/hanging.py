"""What changes in a tree are made of: hanging a word elsewhere, and what counts as a road user there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.spans import names_one

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

TOWED = language.with_plurals("towed")


def hang(words: list[Word], word: Word, above: Word) -> None:
    """Hang a word on another one."""
    words[word.head].children.remove(word.i)
    above.children.append(word.i)
    above.children.sort()
    word.head = above.i


def road_user(word: Word) -> bool:
    """Whether a word names one who moves, and not a trailer."""
    span = word.span
    return names_one(span, MOVERS) and span is not None and span.data.get("noun") not in TOWED

"""What changes in a tree are made of: a word is attached elsewhere, so that a tree remains, and what counts as a road
user there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOVERS
from c2s_engine.interpret.spans import names_one

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

TOWED = language.with_plurals("towed")


def attach(words: list[Word], word: Word, above: Word, dep: str | None = None) -> None:
    """Hang a word on another one, which comes first to where the word hung if it is a part of what hangs on it."""
    if under(words, above, word):
        _off(words, above)
        above.head, above.dep = above.i if word.head == word.i else word.head, word.dep
        if above.head != above.i:
            _on(words, above)
    _off(words, word)
    word.head, word.dep = above.i, dep or word.dep
    _on(words, word)


def under(words: list[Word], word: Word, above: Word) -> bool:
    """Whether the way up from a word leads to another one."""
    for _ in words:
        if word.head in (above.i, word.i):
            return word.head == above.i and word is not above
        word = words[word.head]
    return False


def _off(words: list[Word], word: Word) -> None:
    if word.head != word.i:
        words[word.head].children.remove(word.i)


def _on(words: list[Word], word: Word) -> None:
    above = words[word.head]
    above.children = sorted([*above.children, word.i])


def road_user(word: Word) -> bool:
    """Whether a word names one who moves, and not a trailer."""
    span = word.span
    return names_one(span, MOVERS) and span is not None and span.data.get("noun") not in TOWED

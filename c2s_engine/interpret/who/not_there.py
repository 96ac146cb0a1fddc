"""Road users that are named and are not there: denied, towed, only looked at, or long gone."""

from __future__ import annotations

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word


class NotThere:
    """The part of Cast that tells what is only named."""

    words: list[Word]
    of: dict[int, Entity]
    onlooker: bool  # whether somebody off the road tells the text

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

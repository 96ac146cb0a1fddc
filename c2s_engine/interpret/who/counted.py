"""How many a plural means."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import ZONES
from c2s_engine.interpret.reading.syntax import Word

COUNTED = re.compile(
    r"(?:, (?:[a-z]+ ){1,2})?[,(]? ?(?:(?P<n>[2-8]|two|three|four|five|six|seven|eight) ?(?:pcs|pieces|pc\b|units"
    r"|animals|of (?:them|em|these)|in (?:total|all|number|a row)|altogether|\)))"
)
MASS = language.words("mass")


class Counted:
    """The part of Cast that counts."""

    words: list[Word]

    def _near(self, word: Word) -> list[str]:
        raise NotImplementedError

    def _count(self, word: Word, before: list[str], data: dict) -> int:
        """How many a noun means: as many as are told, else two."""
        counts = language.table("actors")["counts"]
        if not data.get("plural") or data["type"] in ZONES or data.get("noun") in MASS:
            return 1
        near = self.words[max(0, word.i - 3) : word.i]
        if self.words[word.i - 1].norm in ("a", "an") and language.plurals(word.norm) == [word.norm]:
            return 1  # "a deer"
        units = {w.norm for w in near if w.span is not None and w.span.kind == "quantity"}  # "4 s a deer"
        for text in [t for t in (*before, *self._near(word)) if t not in units]:
            if text.isdigit() and 1 <= int(text) <= 8:
                return int(text)
            if text in counts:
                return int(counts[text])
        after = " ".join(w.norm for w in self.words[word.i + 1 : word.i + 9] if w.sentence == word.sentence)
        told = COUNTED.match(after)
        if told is not None:
            return int(told["n"]) if told["n"].isdigit() else int(counts.get(told["n"], 2))
        return 2

"""The vehicle of who writes a report, which is named without an article: "Hwy 17, tanker, 3/4 full. Me at 85 km/h"."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.titles import Titles

OWN = language.table("ego")["own_vehicle"]
FIRST = frozenset(("i", "me", "my", "we", "our", "us"))


class Writers(Titles):
    """The part of Cast that knows the vehicle of the first person by the words of a report's heading."""

    ego: Entity
    asking: frozenset[int]
    me: Entity

    @property
    def driven_by_me(self) -> bool:
        """Whether the first person is at the wheel of ego."""
        return self.me is self.ego and self._tells_first()

    def _tells_first(self) -> bool:
        """Whether the text is told by somebody who drives."""
        mine = (w for w in self.words if w.norm in FIRST and w.i not in self.asking)
        return self.me is self.ego and any(not w.text.isupper() or len(w.text) == 1 for w in mine)

    def _beside(self, word: Word) -> tuple[str, str]:
        """The words of its sentence before and after a word."""
        own = [w for w in self.words if w.sentence == word.sentence]
        return " ".join(w.norm for w in own if w.i < word.i), " ".join(w.norm for w in own if w.i > word.i)

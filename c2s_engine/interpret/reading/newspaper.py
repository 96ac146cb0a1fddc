"""Headlines of reports: "Lorry hits cyclist in Camden", before the story tells it again from the start."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from c2s_engine.interpret.reading.syntax import Word

LONGEST = 14
DETERMINERS = frozenset(
    ("a", "an", "the", "this", "that", "my", "our", "his", "her", "its", "their", "your", "another")
)


def has_headline(words: list[Word]) -> bool:
    """Whether the first sentence names its road users without articles, and the story behind it is told in the past."""
    first = [w for w in words if w.sentence == 0]
    named = [w for w in first if w.span is not None and w.span.kind in ("ego", "label", "actor")]
    if not named or len(first) > LONGEST or any(w.span is None or w.span.kind != "actor" for w in named):
        return False
    if any(w.norm in DETERMINERS for w in first) or any(
        w.span is not None and w.span.kind == "quantity" for w in first
    ):
        return False
    story = {w.norm for w in words if w.sentence > 0}
    past = any(w.tag == "VBD" for w in words if w.sentence > 0)
    return past and bool(story & {"a", "an", "the"}) and not any(w.tag == "VBD" for w in first)

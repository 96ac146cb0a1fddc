"""What is said by reference to another clause: "and so must ego", "B does likewise", "the two collided"."""

import re
from typing import Any

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast


def echoes(cast: Cast, clauses: Clauses) -> None:
    """What is said by reference to another clause: "and so must ego", "the two collided"."""
    words = cast.words
    for i, word in enumerate(words[:-1]):
        ahead = " ".join(w.norm for w in words[i : i + 7] if w.sentence == word.sentence)
        told = i + 1 >= len(words) or words[i + 1].span is None or not words[i + 1].span.data.get("words")
        ends = i > 0 and words[i - 1].norm in ("before", "until", "till")  # "comes back before they meet"
        if (
            told
            and not ends
            and re.match(
                (
                    r"(the |they |)(two|both|they|vehicles|cars)( vehicles| cars| of them)? (then )?"
                    r"(collide|collided|crash|crashed|meet|met|came into contact|made contact)\b"
                ),
                ahead,
            )
            and not any(e.act == "collide" and abs(e.word - i) < 6 for e in clauses.events)
        ):
            [cast.of[j] for j in sorted(cast.of) if j < i and cast.of[j].mover and not cast.of[j].ego]


def _at(i: int, cast: Cast) -> dict[str, Any]:
    """Where an event is told: at one word."""
    return {"word": i, "words": [i], "order": i, "start": cast.words[i].start, "end": cast.words[i].end}

"""What the other party says of who tells the story: "he claims that I pulled out on him" is not what happened, nor is
what each of two parties says of the other only."""

from __future__ import annotations

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

TELLERS = frozenset(("i", "we", "my", "our", "me", "us"))


def claimed(cast: Cast, clauses: Clauses) -> None:
    """Leave out what others say of the teller of a story, and what two say of each other."""
    _tells(cast)


def _tells(cast: Cast) -> bool:
    """Whether ego tells the story, or somebody for it ("our insured")."""
    words = (cast.words[m.word].norm for m in cast.ego.mentions)
    return any(norm in TELLERS or norm.startswith(("our ", "my ")) or "insured" in norm for norm in words)

"""Headlines that name a collision: "Lorry hits cyclist. The lorry turned left"."""

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast


def story_first(cast: Cast, clauses: Clauses) -> None:
    """Put a blow that a headline tells behind what the story tells of: "Lorry hits cyclist. The lorry turned left"."""
    if not cast.headlined or not clauses.events:
        return

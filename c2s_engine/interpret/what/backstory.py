"""What was over before the story begins: "had come south on the side road and was stopped at the sign"."""

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast


def was_over(cast: Cast, event: Event, clauses: Clauses) -> bool:
    """Whether it was done before the story begins: "had stopped", or "a taxi has stopped" as the first that is said of
    the taxi."""
    word = cast.words[event.word]
    has = next((c for c in word.children if cast.words[c].norm in ("had", "has", "have") and c < event.word), None)
    if has is None or cast.words[has].norm == "had":
        return has is not None
    first = not event.agent.ego and not event.adverbial and word.dep in ("ROOT", "relcl")
    earlier = (e for e in clauses.events if e.agent is event.agent and e.word < event.word)
    return first and all(e.text.startswith("face ") for e in earlier)

"""What was over before the story begins: "had come south on the side road and was stopped at the sign"."""

from c2s_engine.interpret import language
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

SAYS = language.words("says")
STANDS = frozenset(("stationary", "stop"))
WHERE = frozenset(("in", "at", "for", "behind", "on", "waiting", "because", "due"))
LINKED = frozenset(("when", "after", "once", "as", "until", "before"))


def was_over(cast: Cast, event: Event, clauses: Clauses) -> bool:
    """Whether it was done before the story begins: "had stopped", or "a taxi has stopped" as the first that is said of
    the taxi."""
    word = cast.words[event.word]
    if _stood(cast, event):
        return True
    has = next((c for c in word.children if cast.words[c].norm in ("had", "has", "have") and c < event.word), None)
    if has is None or cast.words[has].norm == "had":
        return has is not None
    first = not event.agent.ego and not event.adverbial and word.dep in ("ROOT", "relcl")
    earlier = (e for e in clauses.events if e.agent is event.agent and e.word < event.word)
    return first and all(e.text.startswith("face ") for e in earlier)


def _stood(cast: Cast, event: Event) -> bool:
    """Whether a participle beside a clause tells that somebody stood: "while stopped at the light, V1 was hit"."""
    word = cast.words[event.word]
    before = [w.norm for w in cast.words[max(0, word.i - 1) : word.i] if w.sentence == word.sentence]
    beside = before == [","] and word.i > 1 and word.i - 2 in cast.of
    alone = not any(cast.words[c].dep in ("aux", "auxpass") for c in word.children)
    main = cast.words[word.head]
    placed = before == [","] and main.lemma == "be" and main.i < word.i and cast.words[word.i + 1].norm in WHERE
    beside = beside or placed  # "V1 was northbound, stopped at the light"
    return word.norm in ("stopped", "halted") and (beside or before in (["while"], ["whilst"], ["when"])) and alone


def before_the_story(cast: Cast, clauses: Clauses) -> None:
    """What somebody had done who then stands there is told only to explain how it came to stand there."""
    for event in clauses.events:
        if event.mode != "fact" or event.act in (*STANDS, "collide", "travel") or not _had(cast, event):
            continue
        sentence = cast.words[event.word].sentence
        after = (e for e in clauses.events if e.agent is event.agent and e.done and e.word > event.word)
        stands = (e for e in after if e.act == "stationary" and cast.words[e.word].sentence - sentence <= 1)
        if any(not _had(cast, e) for e in stands):
            event.mode = "hypothetical"


def _had(cast: Cast, event: Event) -> bool:
    """Whether something had happened, not as what somebody tells of the story itself or as what another waits for."""
    word = cast.words[event.word]
    if event.adverbial in LINKED or word.dep == "ccomp" and cast.words[word.head].lemma in SAYS:
        return False
    return any(cast.words[c].norm == "had" and c < event.word for c in word.children)

"""What the other party says of who tells the story: "he claims that I pulled out on him" is not what happened, nor is
what each of two parties says of the other only."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

SAYS = language.words("says")
SEES = frozenset(("see", "notice", "observe", "watch", "spot"))
ASIDE = frozenset(("oncoming", "swerve", "drift", "lane_change", "cut_in", "lose_control", "turn"))
TELLERS = frozenset(("i", "we", "my", "our", "me", "us"))


def claimed(cast: Cast, clauses: Clauses) -> None:
    """Leave out what others say of the teller of a story, and what two say of each other."""
    said = [(e, who) for e in clauses.events if e.mode == "fact" and (who := _told_by(cast, clauses, e)) is not None]
    teller = _tells(cast)
    for event, who in said:
        if teller and event.agent.ego and not who.ego:
            event.mode = "hypothetical"
    for event in clauses.events:
        if event.mode == "fact" and _seen_again(cast, clauses, event):
            event.mode = "hypothetical"


def _seen_again(cast: Cast, clauses: Clauses, event: Event) -> bool:
    """Whether somebody says that he saw come who then struck him, which was told: "he saw V1 come into his lane"."""
    word = cast.words[event.word]
    above = cast.words[word.head]
    if (
        word.dep != "ccomp"
        or above.lemma not in SEES
        or above.dep != "ccomp"
        or cast.words[above.head].lemma not in SAYS
    ):
        return False
    seer = clauses._subject(above)[0]
    told = [e for e in clauses.events if e.agent is event.agent and e.word < event.word and e.done]
    return any(e.act == "collide" and e.patient is seer for e in told) and any(e.act in ASIDE for e in told)


def _tells(cast: Cast) -> bool:
    """Whether ego tells the story, or somebody for it ("our insured")."""
    words = (cast.words[m.word].norm for m in cast.ego.mentions)
    return any(norm in TELLERS or norm.startswith(("our ", "my ")) or "insured" in norm for norm in words)


def _told_by(cast: Cast, clauses: Clauses, event: Event) -> Entity | None:
    """Who says that something happened."""
    word: Word = cast.words[event.word]
    for _ in range(5):
        above = cast.words[word.head]
        if above.i == word.i or word.dep not in ("ccomp", "conj", "xcomp", "advcl"):
            return None
        if word.dep == "ccomp" and above.lemma in SAYS and above.i < event.word:
            return clauses._subject(above)[0]
        word = above
    return None

"""Who strikes several, named one after the other: "hit the man and then the car"."""

from __future__ import annotations

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event


def struck_both(clauses: Clauses) -> None:
    """Let the one who strikes strike each of those that the sentence joins."""
    for event in [e for e in clauses.events if e.act == "collide" and e.mode == "fact" and not e.passive]:
        for number, other in enumerate(_joined(clauses, event), start=1):
            clauses.events.append(Event.echo(event, patient=other, order=event.order + 0.05 * number))


def _joined(clauses: Clauses, event: Event) -> list[Entity]:
    """Who is joined with the one that is struck, as the object of the same verb."""
    verb, of = clauses.words[event.word], clauses.cast.of
    found = [
        i for i in sorted(of) if of[i] is event.patient and event.word < i and clauses.words[i].dep in ("dobj", "pobj")
    ]
    if not found or event.patient is None:
        return []
    after = [w for w in clauses.words[found[0] + 1 :] if w.sentence == verb.sentence and _noun(clauses, w)]
    joined = [w for w in after if w.dep == "conj" and w.head == found[0] or w.head == verb.i and _then(clauses, w)]
    if not any(w.norm in ("and", "then") for w in clauses.words[found[0] : max([w.i for w in joined], default=0)]):
        return []  # "a deer, Subaru, Route 9": no more than named together
    return [e for e in dict.fromkeys(of[w.i] for w in joined) if e not in (event.agent, event.patient, *event.also)]


def _noun(clauses: Clauses, word: Word) -> bool:
    return word.i in clauses.cast.of and word.span is not None and clauses.cast.of[word.i].count == 1


def _then(clauses: Clauses, word: Word) -> bool:
    """Whether the tree has one who is struck next with the verb: "hit the man and then the car"."""
    before = [w.norm for w in clauses.words[max(0, word.i - 3) : word.i]]
    return word.dep in ("conj", "npadvmod") and "then" in before

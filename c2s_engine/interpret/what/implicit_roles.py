"""Who is meant where a clause leaves it unsaid: whom ego follows "60 m behind", who struck V1 that "was struck", who
"did not notice that traffic had stopped and struck V2"."""

from __future__ import annotations

from c2s_engine.interpret import language
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

NOTICES = language.words("notices")
STRIKES = language.words("strikes")


def implicit_roles(cast: Cast, clauses: Clauses) -> None:
    """Fill in agents and patients that follow from the clauses around, once it is known who ego is."""
    for event in clauses.events:
        if event.act == "collide":
            _by_the_other(cast, event)
        if event.act == "follow" and event.agent.ego and event.patient is None and event.done:
            event.patient = None


def reassign_unnoticed_collisions(cast: Cast, clauses: Clauses) -> None:
    """Who "did not notice that traffic had stopped and struck V2" strikes, not the traffic."""
    for event in clauses.events:
        if event.act == "collide":
            _by_who_did_not_notice(cast, clauses, event)


def _by_the_other(cast: Cast, event: Event) -> None:
    """ "V1 was struck": not by itself."""
    word = cast.words[event.word]
    if word.lemma not in STRIKES:
        return
    struck = [cast.of.get(c) for c in word.children if cast.words[c].dep == "nsubjpass"]
    told = any(cast.words[c].dep == "agent" or cast.words[c].norm == "by" for c in word.children)
    if struck and struck[0] is event.agent and event.patient is not None and event.patient.mover and not told:
        event.agent, event.patient = event.patient, event.agent


def _by_who_did_not_notice(cast: Cast, clauses: Clauses, event: Event) -> None:
    """The parser joins "struck" to what was not noticed; it is whose failure that was who strikes."""
    word = cast.words[event.word]
    noticed = cast.words[word.head]
    above = cast.words[noticed.head]
    if word.dep != "conj" or noticed.dep != "ccomp" or above.lemma not in NOTICES:
        return
    who = clauses._subject(above)[0]
    if who is None or who is event.agent or who.person:  # "a neighbour saw a van pass and hit it"
        return
    event.patient = event.agent if event.patient in (None, who) else event.patient
    event.agent = who

"""Yes and no to what a run showed, only where every word of the question was read; else what was not, with the run's
figures."""

from collections.abc import Sequence

from c2s_engine.session.question import Party, Question, of_ego_alone, takes_another
from c2s_engine.structure.event_words import event_phrase
from c2s_engine.structure.facts import EGO, EventFact, ObjectFacts, RunFacts

CONTACT = "hits"


def decided(asks: Question, facts: RunFacts) -> str:
    """Yes or no with what the run shows; empty where the question is not about an event, or leaves something open."""
    if not asks.whether or asks.fact is None:
        return ""
    if asks.absent:
        return f"There is no {asks.absent} in this scene."
    if asks.unread or asks.negated or asks.order or asks.measure or CONTACT in asks.fact.events:
        return ""
    doers, found = _objects(asks.subject, facts), shown_of(asks, facts)
    if not found:
        return _denied(asks, doers)
    if asks.aside:
        return ""
    said = "; ".join(f"{o.name} {event_phrase(e)} at {e.time:.1f} s" for o, e in found[:6])
    if asks.moment_fact is not None:
        return _in_order(asks, found, said, facts)
    if asks.moment or asks.object and not takes_another() & set(asks.fact.events):
        return ""
    if asks.subject.how == "all" and (without := [o.name for o in doers if o not in [f[0] for f in found]]):
        return f"Not all: {said}; {', '.join(without)}: not seen."
    return f"Yes: {said}."


def hedged(asks: Question) -> str:
    """What of a question about the run is not judged, told before the figures; empty where all of it was read."""
    if not asks.whether or not (asks.fact or asks.unread):
        return ""
    if asks.unread:
        return f"I cannot say yes or no: “{asks.unread}” was not understood. The run: "
    return f"I cannot say yes or no: whether “{asks.aside}” is not judged. The run: " if asks.aside else ""


def _objects(party: Party, facts: RunFacts) -> list[ObjectFacts]:
    """Those of the run who are meant; everybody where nobody is named."""
    if party.cids:
        return [o for o in facts.objects if ("E" if o.name == EGO else o.component) in party.cids]
    return [o for o in facts.objects if o.moves and not (party.others and o.name == EGO)]


def shown_of(asks: Question, facts: RunFacts) -> list[tuple[ObjectFacts, EventFact]]:
    """The events that are asked for, with whose they are, in the order of time."""
    assert asks.fact is not None
    doers = _objects(asks.subject, facts)
    others = {o.name for o in _objects(asks.object, facts)} if asks.object.cids else None
    found = [(o, e) for o in doers for e in o.events if e.event in asks.fact.events
             and (others is None or e.other is None or e.other in others)]  # fmt: skip
    return sorted(found, key=lambda f: f[1].time)


def _denied(asks: Question, doers: Sequence[ObjectFacts]) -> str:
    """No; where the run was not searched for it between these two, nothing."""
    assert asks.fact is not None
    named = {*asks.subject.cids, *asks.object.cids}
    unsought = asks.object.cids and "E" not in named and of_ego_alone() & set(asks.fact.events)
    if not doers or unsought:
        return ""
    if not asks.subject.cids:
        return f"No: in the run nobody is seen to {asks.fact.verb}."
    who, does = ", ".join(o.name for o in doers), "do" if len(doers) > 1 else "does"
    return f"No: {who} {does} not {asks.fact.verb} in the run."


def _in_order(asks: Question, found: Sequence[tuple[ObjectFacts, EventFact]], said: str, facts: RunFacts) -> str:
    """Whether it was before or after another event; both, with no verdict, for other words of time."""
    assert asks.moment_fact is not None
    doers = _objects(asks.moment_subject, facts)
    other = sorted(((o, e) for o in doers for e in o.events if e.event in asks.moment_fact.events),
                   key=lambda f: f[1].time)  # fmt: skip
    if not other:
        return f"The run shows no “{asks.moment_fact.verb}”; {said}."
    then = f"{other[0][0].name} {event_phrase(other[0][1])} at {other[0][1].time:.1f} s"
    first, at = found[0][1].time, other[0][1].time
    if asks.moment not in ("before", "after"):
        return f"{said}; {then}."
    holds = first < at if asks.moment == "before" else any(e.time > at for _, e in found)
    return f"{'Yes' if holds else 'No'}: {said}; {then}."

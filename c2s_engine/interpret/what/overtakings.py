"""The course of an overtaking: who pulls out, passes and comes back in does all that in one."""

import re

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import OPPOSITE, side
from c2s_engine.interpret.who.mentions import Entity

BACK = re.compile(r"\b(?:back|again|return\w*|in|re-?join\w*|re-?enter\w*)\b")
COMES_IN = re.compile(r"\b\w+ (?:\w+ly )?back (?:in|over|across)\b")
PART = "part"
"""The mode of what another event tells, too."""


def overtakings(clauses: Clauses) -> None:
    """What belongs to an overtaking is told once: pulling out is part of it, coming back in cuts in on ego."""
    _each_of_several(clauses)
    passing = [e for e in clauses.events if e.act == "overtake" and e.done]
    _comes_back_in(clauses, [e for e in passing if not e.agent.ego and (e.patient is None or e.patient.ego)])
    for event in passing:
        own = [e for e in clauses.events if e.agent is event.agent and e.done and e is not event]
        if event.agent.person or event.agent.ego or not event.agent.mover:
            continue
        out = [e for e in own if e.order < event.order and e.act in ("lane_change", "cut_in", "cut_out")]
        back = [e for e in own if e.order > event.order and e.act in ("lane_change", "cut_in")]
        if event.patient is None or event.patient.ego:
            _past_ego(event, out, back)


def _each_of_several(clauses: Clauses) -> None:
    """Who overtakes "ego and the truck" does so with one after the other: with ego first, the rearmost."""
    for event in [e for e in clauses.events if e.act == "overtake" and e.mode == "fact" and e.patient is not None]:
        verb = clauses.words[event.word]
        behind = [clauses.words[c] for c in verb.children if c > verb.i]
        inner = [clauses.words[c] for w in behind if w.dep == "prep" and w.norm in ("past", "by") for c in w.children]
        told = [w for w in (*behind, *inner) if w.dep in ("dobj", "pobj") and w.i in clauses.cast.of]
        if len(told) != 1 or told[0].i - verb.i > 4:
            continue
        those = [clauses.cast.of[told[0].i], *clauses.cast.both.get(told[0].i, []), *_joined(clauses, told[0].i)]
        those = sorted(dict.fromkeys(e for e in those if e is not event.agent), key=lambda e: not e.ego)
        if len(those) > 1 and event.patient in those:
            event.patient = those[0]
            later = [Event.echo(event, patient=e, order=event.order + n / 100) for n, e in enumerate(those[1:], 1)]
            at = clauses.events.index(event) + 1
            clauses.events[at:at] = later


def _joined(clauses: Clauses, at: int) -> list[Entity]:
    """Those joined to a noun by "and"."""
    joined = [c for c in clauses.words[at].children if clauses.words[c].dep == "conj" and c in clauses.cast.of]
    return [e for c in joined for e in (clauses.cast.of[c],)]


def _comes_back_in(clauses: Clauses, passing: list[Event]) -> None:
    """Who comes back in has passed: "a van overtook us; a car was coming, so he dived back in before us"."""
    for event in [e for e in clauses.events if e.act in ("cut_in", "lane_change", "travel") and e.done]:
        earlier = [e for e in passing if e.order < event.order]
        if event.agent.ego or not earlier or not COMES_IN.search(event.text):
            continue
        subjects = [clauses.words[c] for c in clauses.words[event.word].children]
        pronoun = any(w.dep == "nsubj" and w.tag == "PRP" for w in subjects)
        if pronoun:
            event.agent = earlier[-1].agent


def _past_ego(event: Event, out: list[Event], back: list[Event]) -> None:
    """One that comes from behind: it passes ego by the lane that it pulled out to, and cuts in from there."""
    towards = next((s for e in out if (s := side(e)) is not None), None)
    for change in out if back else ():
        if change.patient is None:
            change.mode = PART
            event.trigger, event.side = event.trigger or change.trigger, event.side or towards
    for change in back:
        home = side(change)
        if BACK.search(change.text) and home in (None, OPPOSITE.get(event.side or towards or "left")):
            change.act, change.patient = "cut_in", event.patient
            change.side = change.side or OPPOSITE.get(event.side or towards or "")

"""What is not done although it should or was meant to be: lights and signs that are not heeded, turns that another
keeps ego from."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.what.towards import side
from c2s_engine.interpret.who.mentions import Cast, Entity

RUNS = {"heed_red": "run_red", "heed_stop": "run_stop"}
HINDERS = language.words("hinders")
BESIDE = re.compile(r"\b(?:next to|beside|alongside|level with|abreast|blind spot)\b")
"""Where one is for whom there is no room, not one who is given way to."""
JUNCTION = frozenset(("turn", "u_turn", "go_straight", "cross_path"))


def unheeded(clauses: Clauses) -> None:
    """Who does not see or obey a light or a sign runs it; who does is only said to."""
    for event in [e for e in clauses.events if e.act in RUNS]:
        if event.mode == "negated":
            event.act, event.mode = RUNS[event.act], "fact"
        else:
            clauses.events.remove(event)
    for event in clauses.events:
        if event.act == "keep_lane" and event.mode == "negated":
            event.act, event.mode = "drift", "fact"  # "fails to keep its lane"


def hindered(cast: Cast, clauses: Clauses) -> None:
    """What another keeps ego from at a junction ego means to do, and gives way: "kept from turning left by a bus"."""
    for event in list(clauses.events):
        if event.act not in (*JUNCTION, "overtake") or not event.agent.ego or event.mode != "negated":
            continue
        verb = _hindering(cast, clauses, event)
        if verb is None:
            continue
        sentence = " ".join(w.norm for w in cast.words if w.sentence == cast.words[event.word].sentence)
        if event.act == "overtake" or BESIDE.search(sentence):
            event.mode = "hypothetical"
            continue
        event.mode = "intended"
        who = _who(cast, event, verb)
        if who is not None:
            told = {"patient": who, "order": event.order - 0.1, "words": [event.word]}
            clauses.events.append(Event.echo(event, act="yield", **told))
            event.patient = None


def _hindering(cast: Cast, clauses: Clauses, event: Event) -> int | None:
    """The verb or adjective that says that ego cannot: "prevents it from", "is unable to", "cannot"."""
    word = cast.words[event.word]
    if any(cast.words[c].norm in ("cannot", "can", "could", "ca") for c in word.children):
        return event.word
    above = cast.words[word.head]
    above = cast.words[above.head] if word.dep == "pcomp" else above
    return above.i if clauses._lemma(above) in HINDERS else None


def _who(cast: Cast, event: Event, verb: int) -> Entity | None:
    """Who is in the way: whom the clause names, else the nearest other of the sentence."""
    sentence = cast.words[verb].sentence
    near = [i for i in cast.of if cast.words[i].sentence == sentence and cast.of[i].mover and not cast.of[i].ego]
    return cast.of[min(near, key=lambda i: abs(i - verb))] if near else None


BACK = re.compile(
    r"\b(?:back|return\w*|in again|(?:its|the|his|her|my) (?:own |original |initial )?lane|ahead of|in front of)\b"
)


def merged_back(clauses: Clauses) -> None:
    """Who moves back after it overtook only ends that: "overtakes a tractor and merges back"."""
    for event in clauses.events:
        if event.act not in ("lane_change", "cut_in") or not event.done or not event.agent.ego:
            continue
        own = [e for e in clauses.events if e.agent is event.agent and e.done and e.order < event.order]
        passes = [e for e in own if e.act == "overtake"]
        out = [e for e in own if e.act == "lane_change"]
        if passes and not out and side(event) is None and BACK.search(event.text):
            event.mode = "hypothetical"

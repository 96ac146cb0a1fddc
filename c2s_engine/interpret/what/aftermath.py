"""What follows a collision of ego's and is no part of the scene: where the wrecks came to rest, who got out, who was
charged with what."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import URGENT, Entity
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast

RESTS = re.compile(
    r"^\w+ (?:\w+ )?(?:to|at) (?:(?:an?|its|their|his|her|the) )?(?:\w+ )?rest\b|^end up\b|^stop facing\b"
    r"|^pull (?:over|off|aside|to the)\b"
)
PUSHES = language.words("pushes")
CHARGES = language.words("charges")
TOLD_BACK = frozenset(("when", "as", "while", "after", "before", "where", "since", "because"))
RUNS = frozenset(("run_red", "run_stop"))
ABOARD = frozenset(("driver", "drivers", "operator", "operators", "passenger", "passengers", "occupant", "occupants"))
THROWN = frozenset(("lose_control", "stop", "leave_road", "drift", "swerve", "oncoming", "cross_path", "u_turn"))
"""What becomes of one that is struck."""
LOOSE = frozenset(("debris", "box", "trash", "obstacle"))


def aftermath(cast: Cast, clauses: Clauses) -> None:
    """Leave out what became of the parties once they had hit each other, and what they were charged with."""
    hits = [e for e in clauses.events if e.act == "collide" and e.done]
    own = [e for e in hits if cast.ego in (e.agent, e.patient, *e.also)]
    for event in clauses.events:
        if event.mode != "fact":
            continue
        if _charged(cast, event):
            _as_charged(event, clauses)
        elif own and event.act != "collide" and _is_over(cast, clauses, event, hits):
            event.mode = "hypothetical"
    if own:
        last = max(e.word for e in own)
        for entity in [e for e in cast.entities if _came_after(e, last, hits, clauses) or _broken(e, last, clauses)]:
            cast.entities.remove(entity)
            clauses.events[:] = [e for e in clauses.events if e.agent is not entity]


def _is_over(cast: Cast, clauses: Clauses, event: Event, hits: list[Event]) -> bool:
    """Whether somebody does it who has had the last collision that is told of him or her."""
    blows = [e for e in hits if event.agent in (e.agent, e.patient, *e.also)]
    if not blows or any(e.word >= event.word for e in blows) or event.adverbial in TOLD_BACK:
        return False
    if any(cast.words[c].norm == "had" for c in cast.words[event.word].children):
        return False
    struck = not any(e.agent is event.agent for e in blows)
    moved = event.passive and clauses._lemma(cast.words[event.word]) in PUSHES
    thrown = ("lose_control", "stop") if event.agent.ego else THROWN
    return RESTS.match(event.text) is not None or moved or struck and event.act in thrown


def _charged(cast: Cast, event: Event) -> bool:
    """Whether it is what somebody is charged with: "was cited for failing to yield"."""
    word = cast.words[event.word]
    before = [w for w in cast.words[max(0, word.i - 9) : word.i] if w.sentence == word.sentence]
    at = next((n for n, w in enumerate(before) if w.lemma in CHARGES or w.norm in CHARGES), None)
    after = before[at + 1 :] if at is not None else []
    alone = not any(w.tag in ("VBD", "VBZ") for w in [*after, word])  # "cited 11-902, failure to yield turning left"
    return any(w.norm in ("for", "with", "of") or w.norm == "," and alone for w in after)


def _as_charged(event: Event, clauses: Clauses) -> None:
    """A light or sign that was run is told by the charge; what else one was charged with is known by the story."""
    told = any(e.act in RUNS and e.agent is event.agent and e is not event for e in clauses.events)
    if event.act not in RUNS or told:
        event.mode = "hypothetical"
    else:
        event.order = min(e.order for e in clauses.events) - 0.1


def _came_after(entity: Entity, last: int, hits: list[Event], clauses: Clauses) -> bool:
    """Whether somebody is only told of after the last collision: who got out, who was hurt, who came to help."""
    if _got_out(entity, last, hits):
        return True
    first = entity.mentions[0].word if entity.mentions else 0
    if first <= last or any(entity in (e.agent, e.patient, *e.also) for e in hits):
        return False
    acts = any(entity in (e.agent, e.patient, *e.also) and e.done and e.act != "travel" for e in clauses.events)
    return entity.type in URGENT or entity.person and entity.type != "animal" and not acts


def _got_out(entity: Entity, last: int, hits: list[Event]) -> bool:
    """Whether somebody is only told of who left a vehicle after the last collision of ego's."""
    struck = any(entity in (e.agent, e.patient, *e.also) for e in hits)
    first = entity.mentions[0].word if entity.mentions else 0
    return entity.person and entity.noun in ABOARD and first > last and not struck


def _broken(entity: Entity, last: int, clauses: Clauses) -> bool:
    """Whether a thing is only told of after the last collision of ego's: what broke, a box that was ticked."""
    told = any(entity in (e.agent, e.patient, *e.also) for e in clauses.events if e.act != "travel")
    first = entity.mentions[0].word if entity.mentions else 0
    return not entity.mover and entity.type in LOOSE and first > last and not told

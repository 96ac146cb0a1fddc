"""Whose part strikes somebody: no party strikes itself."""

from __future__ import annotations

import re

from c2s_engine.interpret.entities import Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses


def own_parts(clauses: Clauses) -> None:
    """ "V1 reversed and did not see V2, and its bumper struck the door of V2": it is the bumper of V1."""
    for event in clauses.events:
        if event.act != "collide" or event.passive or not re.search(rf"@{event.agent.key}\b", event.text):
            continue
        part = next((w for w in _subjects(clauses, clauses.words[event.word]) if _its(clauses, w)), None)
        if part is None or (owner := _besides(clauses, part, event.agent)) is None:
            continue
        event.agent, event.patient = owner, event.agent


def _subjects(clauses: Clauses, verb: Word) -> list[Word]:
    return [clauses.words[c] for c in verb.children if clauses.words[c].dep == "nsubj"]


def _its(clauses: Clauses, part: Word) -> bool:
    return part.i not in clauses.cast.of and any(clauses.words[c].tag == "PRP$" for c in part.children)


def _besides(clauses: Clauses, part: Word, struck: Entity) -> Entity | None:
    """Who else was spoken of before, in the same sentence or the one before it."""
    spoken = [w for w in clauses.words[: part.i] if w.i in clauses.cast.of and w.sentence >= part.sentence - 1]
    others = [w for w in spoken if (e := clauses.cast.of[w.i]) is not struck and (e.mover or e.ego)]
    here = [w for w in others if w.sentence == part.sentence]
    return clauses.cast.of[(here or others)[0].i] if others else None

"""Who struck whom, as the damage tells: "causing damage to the front of V1 and the left side of V2"."""

from __future__ import annotations

import re

from c2s_engine.interpret import language
from c2s_engine.interpret.entities import MOTOR, Entity
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.who.mentions import Cast

DAMAGED = re.compile(r"damaged?|dent(?:s|ed)?|crushed|scratch(?:es|ed)?|scrap(?:es|ed)|crumpled|stove")
FRONT = frozenset(("front", "nose", "bonnet", "hood", "grille", "headlight", "headlights"))
REAR = frozenset(("rear", "back", "tail", "boot", "trunk", "tailgate"))
SIDES = frozenset(("left", "right"))
FLANKS = language.words("flanks") | {"mirror"}
BESIDE = frozenset(("bumper", "end", "corner", "plane", "area", "section", "driver", "passenger", "'s", "-", "light"))
PARTS = FRONT | REAR | SIDES | FLANKS
NEAR = 5


def struck_by_damage(cast: Cast, clauses: Clauses) -> None:
    """Let who is damaged at the front strike the one who is damaged elsewhere, where no more is told than that they
    collided."""
    damaged = _damaged(cast)
    hitter = next((e for e, zone in damaged.items() if zone == "front"), None)
    struck = next((e for e in damaged if e is not hitter), None)
    if hitter is None or struck is None or len(damaged) > 2:
        return
    hits = [e for e in clauses.events if e.act == "collide" and e.done and e.agent in (hitter, struck)]
    hits = [e for e in hits if e.patient in (None, hitter, struck)]
    for event in hits:
        event.mode = "hypothetical"


def _damaged(cast: Cast) -> dict[Entity, str]:
    """Which end or side of each party is damaged."""
    found: dict[Entity, str] = {}
    told = {w.sentence for w in cast.words if DAMAGED.fullmatch(w.norm)}
    heads = {w.sentence + 1 for w in cast.words if w.sentence in told and w.norm == ":"}  # "Damage: front of V1"
    at = 0
    while at < len(cast.words):
        first = cast.words[at]
        if first.sentence not in told | heads or not _of_part(first) or at in cast.of:
            at += 1
            continue
        end = at + 1
        while (
            end < len(cast.words)
            and (_of_part(cast.words[end]) or cast.words[end].norm in BESIDE)
            and cast.words[end].sentence == first.sentence
        ):
            end += 1
        zone, owner = _zone({n for w in cast.words[at:end] for n in w.norm.split("-")}), _owner(cast, at, end)
        if owner is not None and (owner.ego or owner.type in MOTOR):
            found.setdefault(owner, zone)
        at = end
    return found


def _of_part(word: Word) -> bool:
    return not PARTS.isdisjoint(word.norm.split("-"))


def _zone(part: set[str]) -> str:
    side = next(iter(sorted(part & SIDES)), "")
    if part & FLANKS or not part & (FRONT | REAR):
        return f"{side} side".strip()
    return "rear" if part & REAR else "front"


def _owner(cast: Cast, start: int, end: int) -> Entity | None:
    """Whose part it is: of whom it is said to be, else who was named last before it."""
    sentence = cast.words[start].sentence
    if cast.words[min(end, len(cast.words) - 1)].norm in ("of", "on"):
        after = [w.i for w in cast.words[end : end + NEAR] if w.sentence == sentence and w.i in cast.of]
        return cast.of[after[0]] if after else None
    before = [w.i for w in cast.words[:start] if w.sentence == sentence and w.i in cast.of and w.span is not None]
    return cast.of[before[-1]] if before else None

"""Someone named in a condition before the story tells of them: "brakes when a pedestrian is near. A pedestrian ..."."""

import re

from c2s_engine.interpret.entities import Entity, fits
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.who.mentions import Cast

MARKS = frozenset(("when", "whenever", "if", "once", "as", "unless", "until"))
NEAR = re.compile(r"\b(?:closer|nearer|near|within|less|away|below|under|detect\w*|in front|range|in the way|ahead)\b")
VERBS = frozenset(("be", "come", "get", "draw", "approach", "detect", "see", "notice", "recognise", "sense"))


def foretold(cast: Cast) -> None:
    """One that a condition only imagines is the one of its kind that is told of after it."""
    for first in list(cast.entities):
        at = first.mentions[0].word if len(first.mentions) == 1 else None
        if at is None or first.count != 1 or first.roles or not first.mover or not _imagined(cast, cast.words[at]):
            continue
        later = [e for e in cast.entities if e is not first and _told_after(cast, e, at) and _alike(first, e)]
        if len(later) != 1:
            continue
        found = later[0]
        cast.of[at] = found
        cast.subjects = [(i, found if e is first else e) for i, e in cast.subjects]


def _imagined(cast: Cast, noun: Word) -> bool:
    """Whether a noun stands in a condition about nearness, or for any one of its kind."""
    before = {cast.words[c].norm for c in noun.children if c < noun.i}
    if "any" in before:
        return True
    if not before & {"a", "an"}:
        return False
    verb = cast.words[noun.head]
    if noun.dep not in ("nsubj", "dobj") or verb.lemma not in VERBS:
        return False
    marked = any(cast.words[c].norm in MARKS for c in verb.children if c < verb.i)
    clause = " ".join(w.norm for w in cast.words if w.sentence == noun.sentence and w.i >= min(noun.i, verb.i))
    return marked and verb.dep == "advcl" and NEAR.search(clause) is not None


def _told_after(cast: Cast, entity: Entity, at: int) -> bool:
    """Whether one is first spoken of in a later sentence."""
    return bool(entity.mentions) and cast.words[entity.mentions[0].word].sentence > cast.words[at].sentence


def _alike(first: Entity, later: Entity) -> bool:
    """Whether the one told of is of the kind that was imagined, and nothing tells that it is another."""
    return later.count == 1 and fits(later, first.type) and later.ordinal is None and not later.label

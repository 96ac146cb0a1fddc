"""What is said by reference to another clause: "and so must ego", "B does likewise", "the two collided"."""

import re
from typing import Any

from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.event import Event
from c2s_engine.interpret.who.mentions import Cast, Entity

LIKEWISE = re.compile(
    r"(?:(?:do|does|did|doing) (?:the (?:very )?same|likewise|so(?: too| as well)?|this too|that too|too|as well|also)"
    r"|(?:follow|follows|followed|following) suit"
    r"|reacts? (?:likewise|the same way|in the same way)|(?:follows?|followed) (?:his|her|its|their|this|that) example"
    r"|copies|copied|imitates)\b"
)

SIDES = re.compile(r" (?:to|on|onto|towards?) (?:both|either|each|opposite) sides?\b.*")
BARE = re.compile(r"(?:does|did|do)(?: (?:[.,;]|and|but)(?: |$)|$)")
"""A verb that stands for the one before: "two cross, a third does"."""


def echoes(cast: Cast, clauses: Clauses) -> None:
    """What is said by reference to another clause: "and so must ego", "the two collided"."""
    words = cast.words
    for i, word in enumerate(words[:-1]):
        ahead = " ".join(w.norm for w in words[i : i + 7] if w.sentence == word.sentence)
        said = LIKEWISE.match(ahead) and words[i - 1].norm not in ("in", "by", "while", "when", "without")
        if said or _stands_for_verb(i, ahead, cast):
            _likewise(i, ahead, cast, clauses)
        if re.match(r"(?:and )?then (?:an?|the|another|two|three)\b", ahead):
            _gapped(i, cast, clauses)
        if re.match(r"so (must|does|do|did|has|should|will|had)\b|as (does|do|did)\b", ahead):
            target = next((cast.of[w.i] for w in words[i : i + 6] if w.i in cast.of), None)
            earlier = [e for e in clauses.events if e.word < i and e.agent is not target and e.mode == "fact"]
            if target is not None and earlier:
                last = max(earlier, key=lambda e: e.word)
                clauses.events.append(Event.echo(last, agent=target, hard=last.hard, **_at(i, cast)))
        told = i + 1 >= len(words) or words[i + 1].span is None or not words[i + 1].span.data.get("words")
        ends = i > 0 and words[i - 1].norm in ("before", "until", "till")  # "comes back before they meet"
        if (
            told
            and not ends
            and re.match(
                (
                    r"(the |they |)(two|both|they|vehicles|cars)( vehicles| cars| of them)? (then )?"
                    r"(collide|collided|crash|crashed|meet|met|came into contact|made contact)\b"
                ),
                ahead,
            )
            and not any(e.act == "collide" and abs(e.word - i) < 6 for e in clauses.events)
        ):
            before = [cast.of[j] for j in sorted(cast.of) if j < i and cast.of[j].mover and not cast.of[j].ego]
            if before:
                told_here = {"text": ahead, "whole": ahead, "patient": cast.ego, **_at(i, cast)}
                clauses.events.append(Event("collide", before[-1], **told_here))


def _gapped(i: int, cast: Cast, clauses: Clauses) -> None:
    """ "A dog runs across the road, then a girl": the second does what the first did."""
    words = cast.words
    after = [w for w in words[i + 1 : i + 7] if w.sentence == words[i].sentence]
    who = next((w for w in after if w.i in cast.of and w.span is not None), None)
    if who is None:
        return
    entity = cast.of[who.i]
    told = any(e.agent is entity for e in clauses.events)
    before = [e for e in clauses.events if e.word < i and words[e.word].sentence == words[i].sentence and e.done]
    if told or entity.ego or not entity.mover or not before or before[-1].agent.person != entity.person:
        return
    last = max(before, key=lambda e: e.word)
    entity.roles |= last.agent.roles & {"oncoming"}  # "two oncoming cars go by, then a bus"


def _likewise(i: int, said: str, cast: Cast, clauses: Clauses) -> None:
    """ "B does likewise", "the bus follows suit": what the one spoken of before did."""
    own = next((e for e in clauses.events if e.word == i), None)
    who: Entity | None = own.agent if own is not None else None
    if who is None:
        sentence = cast.words[i].sentence
        near = [j for j in sorted(cast.of) if j < i and cast.words[j].sentence == sentence and cast.of[j].mover]
        who = cast.of[near[0]] if near else None
    earlier = [e for e in clauses.events if e.word < i and e.agent is not who and e.done and e.act != "follow"]
    if who is None or not earlier:
        return
    last = max(earlier, key=lambda e: e.word)
    if own is not None:
        clauses.events.remove(own)
    patient = last.patient if last.patient is not who else None
    told = [q for q in last.quantities if q["dimension"] in ("acceleration", "change")]
    both = SIDES.search(last.text) is not None  # ego makes way to its own edge
    same = {"patient": patient, "hard": last.hard, "side": "right" if both else last.side, "quantities": told}
    clauses.events.append(Event.echo(last, agent=who, **same, **_at(i, cast)))


def _stands_for_verb(i: int, ahead: str, cast: Cast) -> bool:
    """Whether "does" or "did" is all that a clause says of its subject: "a third person does"."""
    word = cast.words[i]
    subjects = [c for c in word.children if cast.words[c].dep == "nsubj" and c < i]
    told = any(cast.words[c].dep in ("dobj", "attr", "neg", "xcomp") for c in word.children)
    main = word.dep in ("ROOT", "conj", "ccomp", "parataxis")
    return bool(subjects) and main and not told and subjects[0] in cast.of and BARE.match(ahead) is not None


def _at(i: int, cast: Cast) -> dict[str, Any]:
    """Where an event is told: at one word."""
    return {"word": i, "words": [i], "order": i, "start": cast.words[i].start, "end": cast.words[i].end}

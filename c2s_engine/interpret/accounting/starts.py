"""Where the text does say where somebody starts, in words that led to no field: the assumed place says that."""

from collections.abc import Iterable, Iterator

from c2s_engine.interpret.accounting.clauses import span_of
from c2s_engine.interpret.accounting.links import owners
from c2s_engine.interpret.placing.start import UNSAID
from c2s_engine.interpret.reading.syntax import Word
from c2s_engine.interpret.scene import Scene
from c2s_engine.structure.account import is_set
from c2s_engine.structure.components import Structure

Span = tuple[int, int]

UNREAD = "what the text says of where it starts was not understood ({})"
OF_A_PLACE = ("prep", "prt", "advmod", "npadvmod")
"""Grammatical relations of words of place to their verb or noun."""


def with_unresolved_start_phrases(scene: Scene, structure: Structure, lost: Iterable[Span]) -> Structure:
    """S, in which an assumed start names the words of place in the same clause that led to nothing; `lost`: what of the
    text did not."""
    place = structure.place
    unset = [li.span for li in place.links if li.span and li.field and not is_set(place.spec, li.field)]
    spans = [*unset, *(s for s in lost if s not in structure.clauses)]
    for entity, cid in owners(scene, structure).items():
        component = structure[cid]
        if not any(a.field == "placement.position" and a.reason == UNSAID for a in component.assumed):
            continue
        own = [m.start for m in entity.mentions]
        own += [scene.words[e.word].start for e in scene.clauses.events if e.agent is entity and e.done]
        clauses = [c for c in structure.clauses if any(c[0] <= at < c[1] for at in own)]
        found = {p for c in clauses for p in _phrases(scene, c, spans)}
        phrases = [p for p in found if not any(q != p and q[0] <= p[0] and p[1] <= q[1] for q in found)]
        if phrases:
            reason = UNREAD.format(", ".join(f"“{scene.text[slice(*p)]}”" for p in sorted(phrases)))
            assumed = [a.model_copy(update={"reason": reason}) if a.reason == UNSAID else a for a in component.assumed]
            structure = structure.with_component(component.model_copy(update={"assumed": tuple(assumed)}))
    return structure


def _phrases(scene: Scene, clause: Span, spans: list[Span]) -> Iterator[Span]:
    """The phrases of place in a clause that hold such a span, or that one holds."""
    for span in spans:
        words = [w for w in scene.words if w.start < span[1] and span[0] < w.end and _within(w, clause)]
        tops = [top for w in words if (top := _top(scene, w, clause)).dep in OF_A_PLACE]
        if not tops:
            continue
        if any(w.tag.startswith("VB") for w in words):  # a verb with its place: all of it
            yield span
            continue
        under = [w for w in scene.words if _within(w, clause) and _top(scene, w, clause).i == tops[0].i]
        yield span_of(sorted(under, key=lambda w: w.start))


def _top(scene: Scene, word: Word, clause: Span) -> Word:
    """The word of the clause that a word's phrase hangs on its verb or on a road user with."""
    at = word
    for _ in range(len(scene.words)):
        head = scene.words[at.head]
        ends = head.i == at.i or head.tag.startswith("VB") or head.i in scene.cast.of or not _within(head, clause)
        if ends or at.dep == "punct":
            break
        at = head
    return at


def _within(word: Word, clause: Span) -> bool:
    return clause[0] <= word.start < clause[1]

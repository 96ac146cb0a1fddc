"""What of a text nothing in S says, though no stage named it as lost."""

import re
from collections.abc import Sequence

from c2s_engine.interpret import language
from c2s_engine.interpret.learned.account import (
    absent,
    is_said,
    numbers_of,
    said_words,
    same,
    values_of,
    words_of_fields,
)
from c2s_engine.interpret.learned.relative import relative_amounts
from c2s_engine.interpret.learned.units import ONES, quantities
from c2s_engine.interpret.mentions import mentions
from c2s_engine.session.reader import phrases
from c2s_engine.session.steps import Tools
from c2s_engine.structure.account import meets
from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.objects import types
from c2s_engine.structure.sentences import sentence
from c2s_engine.structure.stems import stems
from c2s_engine.structure.vocabulary import ON_FOOT

SHOWN = 60
"""Characters of a text by which it is named."""
JOINED = re.compile(r"(?:(?:and|but|then|or)\b\s*)*", re.IGNORECASE)
SMALL = stems("a an the its his her with of by for from to at in on onto along and but then or")
REASON = "nothing in S says it"

_NOT = re.compile(r"(?:\b(?:not|never|no longer|without)|n['’]t)\s+(\w+)", re.IGNORECASE)

Span = tuple[int, int]


async def without_effect(
    text: str, structure: Structure, tools: Tools, before: Structure | None = None
) -> tuple[Unmet, ...]:
    """The phrases of a text of which no word is in what S says, in its order: of S's own text, or of a change that made
    S what it is of what it was `before`; of a change also the quantities. What lies in such a phrase, or was named as
    lost, is not named again."""
    own = structure.text == text
    lost = [*structure.not_understood, *structure.background, *(u for c in structure.components for u in c.unmet)]
    known = [u.span for u in lost if u.span] if own else []
    rests = [li.span for c in structure.components for li in c.links if li.span and li.field] if own else []
    said = frozenset(s for c in structure.components for s in (*stems(_told(c, structure)), *said_words(c, structure)))
    said |= _of_fields(structure, before)
    if before is not None and (gone := _is_less(before, structure)):
        said |= {s for c in before.components for s in (*stems(_told(c, before)), *said_words(c, before))}
    nobody = SMALL | stems(" ".join((*language.table("trade")["again"], *ONES, *_nouns(text, structure))))
    nobody |= frozenset() if own else stems(" ".join(language.table("trade")["asks"]))
    found: list[Span] = []
    numbers, fields = numbers_of(structure), words_of_fields(structure)
    for start, end in await phrases(text, tools):
        begin = start + JOINED.match(text[start:end]).end()  # type: ignore[union-attr]
        words = {word for word in stems(text[begin:end]) - nobody if len(word) > 1}  # no units
        if words and not words & said and not meets((begin, end), *rests, *known, *found) \
                and not is_said(text[begin:end], numbers, fields):
            found.append((begin, end))
    if before is not None:
        there, new = types(structure) | types(before), types(structure) - types(before)
        becomes = [(n.start, n.end) for n in mentions(text) if any(map(n.fits, new))]
        found = [span for span in found if not meets(span, *becomes)]
        found += [span for span in absent(mentions(text), there) if not meets(span, *found)]
        found += [span for span in _nobody(text, there) if not meets(span, *found)]
        found += [span for span in _negated(text, structure, before) if not meets(span, *found)]
        found += [span for span in ([] if gone else _removals(text)) if not meets(span, *found)]
    if before is not None:
        found += [span for span in _directions(text, structure, before) if not meets(span, *found)]
    if not own:
        found += [span for span in _amounts(text, structure) if not meets(span, *found)]
    return tuple(Unmet(text=text[a:b].strip(" ,;.\n"), reason=REASON, span=(a, b)) for a, b in sorted(found))


def _of_fields(structure: Structure, before: Structure | None) -> frozenset[str]:
    """The stems of the words for fields that became another."""
    found: set[str] = set()
    for component in structure.components if before is not None else ():
        assert before is not None
        was = dict(values_of(before[component.id].spec.model_dump())) if component.id in before else {}
        now = dict(values_of(component.spec.model_dump()))
        for path in {p for p in now | was if now.get(p) != was.get(p)}:
            found |= stems(" ".join(language.table("trade")["fields"].get(path.rsplit(".", 1)[-1], ())))
    return frozenset(found)


def _is_less(before: Structure, structure: Structure) -> bool:
    """Whether a change took something away: an object, a phase, or what a field said."""
    was, now = ({(c.id, path) for c in s.components for path, _ in values_of(c.spec.model_dump(exclude_defaults=True))}
                for s in (before, structure))  # fmt: skip
    return bool(was - now)


def _nobody(text: str, there: frozenset[str]) -> list[Span]:
    """Where a change names somebody on foot or riding whom nobody of S can be, but for those spoken of again."""
    again = stems(" ".join(language.table("trade")["again"]))
    named = (n for n in mentions(text) if not stems(text[n.start : n.end]) & again)
    return list(absent(named, there, (*ON_FOOT, "bicycle")))


def _negated(text: str, structure: Structure, before: Structure) -> list[Span]:
    """Where a change says that something is not done which somebody whom it changed still does."""
    does: set[str] = set()
    for component in structure.components:
        if component.id not in before or before[component.id].spec != component.spec:
            own = said_words(component, structure).items()
            does |= {word for word, field in own if field.startswith(("phases", "reaction"))}
    return [m.span() for m in _NOT.finditer(text) if stems(m[1]) & does]


def _removals(text: str) -> list[Span]:
    """Where a text asks that something be removed."""
    verbs = "|".join(language.table("trade")["removes"])
    return [m.span() for m in re.finditer(rf"\b(?:{verbs})\b[^,.;]*?(?=[,.;]|\s+and\b|$)", text, re.IGNORECASE)]


def _directions(text: str, structure: Structure, before: Structure) -> list[Span]:
    """Where a change that moved somebody says a direction that nobody has whom it changed."""
    was = {c.id: c.spec for c in before.objects}
    moved = [c for c in structure.objects if getattr(was.get(c.id), "placement", None) != c.spec.placement]  # type: ignore
    changed = [c for c in structure.components if c.id not in before or before[c.id].spec != c.spec]
    said = frozenset(word for c in changed for word in (*said_words(c, structure), *stems(_told(c, structure))))
    words = language.alternatives(language.table("trade")["directions"])
    return [m.span() for m in re.finditer(rf"\b(?:{words})\b", text, re.IGNORECASE)
            if moved and not stems(m[0]) & said]  # fmt: skip


def _amounts(text: str, structure: Structure) -> list[Span]:
    """Where quantities stand in a change that no field of S has; one by how much something changes is in none."""
    relative = [span for span, _, _, _ in relative_amounts(text)]
    held = [number for _, _, number in numbers_of(structure)]
    return [span for span, value, _ in quantities(text)
            if span not in relative and not any(same(number, value) for number in held)]  # fmt: skip


def _nouns(text: str, structure: Structure) -> list[str]:
    """The nouns of a text that mean somebody of S."""
    return [text[n.start : n.end] for n in mentions(text) if any(map(n.fits, types(structure)))]


def _told(component: Component, structure: Structure) -> str:
    """What a component says, in its sentence, the usual one and its fields."""
    fields = component.spec.model_dump(exclude_defaults=True)
    return f"{component.description} {sentence(component, structure)} {fields}"


def phrases_sentence(found: Sequence[Unmet], of: str = "") -> str:
    """These phrases in a sentence, with the beginning of the text that they are of."""
    said = " ".join(of.split())
    short = said if len(said) <= SHOWN else f"{said[:SHOWN].rsplit(' ', 1)[0]} ..."
    whose = f"Of “{short}”: " if said else ""
    words = "; ".join(f"“{unmet.text}”" for unmet in found)
    return f"{whose}Nothing in S says: {words}." if found else whose

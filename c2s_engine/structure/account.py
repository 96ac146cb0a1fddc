"""The account of the text: every clause became fields of S, or is background, cannot be said, or was not understood.

A view of S as it stands, never stored: so an edit of S changes it. Nothing of the text is outside it.
"""

import re
from collections.abc import Iterable, Sequence
from typing import Literal

from c2s_engine.structure.components import ComponentId, Frozen, Structure, Unmet
from c2s_engine.structure.leaves import value_at
from c2s_engine.structure.requirements import Result, tally
from c2s_engine.structure.specs import Spec

Status = Literal["understood", "partly", "background", "not_expressible", "not_understood"]
Span = tuple[int, int]

STATUS_WORDS: dict[Status, str] = {
    "understood": "understood", "partly": "partly understood", "background": "background",
    "not_expressible": "not expressible",
    "not_understood": "not understood",
}  # fmt: skip
NOBODY = "no component of S uses it"
UNSAID = "no field of S says it"
GONE = "{} is not in S"

CLAUSE = 0.8
"""The share of a clause's characters from which on a phrase is that clause, but for what joins it."""
_BREAK = re.compile(r"(?<=[.!?;:])[\"')\]”’]*\s+|\s*\n\s*|(?<=,)\s+(?=(?:and|but|while|when|so|then|which|who)\b)")


class Clause(Frozen):
    """A piece of the text and what became of it: understood where the fields that it became are in S and nothing of it
    is lost, partly where something is. `lost`: what in it could not be said or read, with the reasons.

    `fields`: the fields of S that it became, where the method tells ("O1.phases.0")."""

    span: Span
    text: str
    status: Status
    components: tuple[ComponentId, ...] = ()
    fields: tuple[str, ...] = ()
    lost: tuple[Unmet, ...] = ()
    unread: tuple[str, ...] = ()
    """Its words on which no field rests: lost, or said by others as well."""

    @property
    def reason(self) -> str:
        """Why it is not (wholly) in S; empty where it is."""
        return "; ".join(dict.fromkeys(u.reason for u in self.lost))


def account(structure: Structure, idle: Sequence[Unmet] = ()) -> tuple[Clause, ...]:
    """Every clause of S's text, in order; all that is not white space lies in exactly one of them. `idle`: phrases of
    the text without which S would be the same."""
    return tuple(_clause(structure, span, idle) for span in covering(structure.text, structure.clauses))


def count_lost_clauses(structure: Structure, idle: Sequence[Unmet] = ()) -> int:
    """How many clauses of the text nothing, or not all, of S stands for. Of `idle`, phrases without which S stays the
    same, those count that are clauses: what a single word says S may hold from elsewhere."""
    clauses = account(structure, idle_clauses(structure, idle))
    return sum(1 for c in clauses if c.status not in ("understood", "background"))


def unread_words(words: Iterable[str]) -> str:
    """In a sentence, the words of a text on which no field rests; "" for none."""
    said = ", ".join(f"“{word}”" for word in dict.fromkeys(words))
    return f"No field of S rests on {said}, unless other words say the same." if said else ""


def idle_clauses(structure: Structure, idle: Sequence[Unmet]) -> list[Unmet]:
    """Of the phrases without which S would be the same, those that are clauses of the text, or nearly."""
    spans = covering(structure.text, structure.clauses)
    return [u for u in idle if u.span and any(_most_of(span, u.span) for span in spans)]


def _most_of(clause: Span, phrase: Span) -> bool:
    return min(phrase[1], clause[1]) - max(phrase[0], clause[0]) > CLAUSE * (clause[1] - clause[0])


def requirements_met(structure: Structure, results: Sequence[Result], idle: Sequence[Unmet] = ()) -> str:
    """How much of what S requires was met, and how much of the text S does not hold, and so does not require; empty
    where nothing is required."""
    met, required = tally(results)
    if not required:
        return ""
    lost = count_lost_clauses(structure, idle)
    are = "clauses of the text are" if lost > 1 else "clause of the text is"
    found = f"{met} of {required} requirements met" + (f"; {lost} {are} not fully in S" if lost else "")
    apart = ", ".join(c.id for c in structure.components if c.conflict)
    return found + (f"; code by hand of {apart} is in conflict with S" if apart else "")


def covering(text: str, clauses: Sequence[Span] = ()) -> list[Span]:
    """Spans that hold every character of the text but white space, each once: the given ones where they lie in the
    text and do not overlap, and between them what punctuation parts. What has no letter or digit joins a neighbour."""
    found: list[Span] = []
    at = 0
    for start, end in sorted(clauses):
        start, end = max(start, at), min(end, len(text))
        if start < end:
            found += [*_parted(text, at, start), *_trimmed(text, start, end)]
            at = end
    return _wordy(text, found + _parted(text, at, len(text)))


def _parted(text: str, start: int, end: int) -> list[Span]:
    """The clauses between two places, by punctuation."""
    cuts = [start, *(m.end() for m in _BREAK.finditer(text, start, end)), end]
    return [s for a, b in zip(cuts, cuts[1:], strict=False) for s in _trimmed(text, a, b)]


def _trimmed(text: str, start: int, end: int) -> list[Span]:
    piece = text[start:end]
    inner = piece.strip()
    begin = start + len(piece) - len(piece.lstrip())
    return [(begin, begin + len(inner))] if inner else []


def _wordy(text: str, spans: list[Span]) -> list[Span]:
    """The spans, those of signs alone joined to the one before, or to the first of words."""
    found: list[Span] = []
    for start, end in spans:
        wordless = not any(ch.isalnum() for ch in text[start:end])
        if found and (wordless or not any(ch.isalnum() for ch in text[slice(*found[-1])])):
            found[-1] = (found[-1][0], end)
        else:
            found.append((start, end))
    return found


def _clause(structure: Structure, span: Span, idle: Sequence[Unmet]) -> Clause:
    components = [c.id for c in structure.components if any(meets(link.span, span) for link in c.links)]
    said = dict.fromkeys(
        (c.id, li.field) for c in structure.components for li in c.links if li.field and meets(li.span, span)
    )
    fields = [f"{cid}.{path}" for cid, path in said if is_set(structure[cid].spec, path)]
    gone = [GONE.format(f"{cid}.{path}") for cid, path in said if f"{cid}.{path}" not in fields]
    unmet = _inside((u for c in structure.components for u in c.unmet), span)
    missed = _inside((*structure.not_understood, *idle), span)
    background = _inside(structure.background, span)
    whole = structure.text[slice(*span)]
    missed += tuple(Unmet(text=whole, reason=reason, span=span) for reason in gone)
    status: Status = "understood"
    if background:
        status = "background"
    elif fields and (missed or unmet):
        status = "partly"
    elif missed or unmet:
        status = "not_understood" if missed else "not_expressible"
    elif not components:
        status, missed = "not_understood", (Unmet(text=whole, reason=NOBODY, span=span),)
    return Clause(
        span=span, text=whole, status=status, components=tuple(components),
        fields=tuple(fields), lost=(*background, *missed, *unmet),
        unread=tuple(structure.text[a:b] for a, b in structure.unread if meets((a, b), span)),
    )  # fmt: skip


def is_set(spec: Spec, path: str) -> bool:
    """Whether a field of a spec says something: it is there, and neither empty nor no."""
    return value_at(spec, path) not in (None, (), "", False, "none")


def _inside(notes: Iterable[Unmet], span: Span) -> tuple[Unmet, ...]:
    return tuple(n for n in notes if meets(n.span, span))


def meets(span: Span | None, *others: Span) -> bool:
    """Whether a span has a character in common with one of others."""
    return span is not None and any(span[0] < end and start < span[1] for start, end in others)

"""What of a text makes no difference to S, though no stage named it as lost: the text is read without each phrase."""

import asyncio
import re
from collections.abc import Sequence
from typing import Any

import snowballstemmer

from c2s_engine.session.reader import Unreadable, phrases, read, route
from c2s_engine.session.steps import Tools
from c2s_engine.structure.account import is_set
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.edits import Edit, apply
from c2s_engine.structure.sentences import sentence

REASON = "S would be the same without it"
SHOWN = 60
"""Characters of a text by which it is named."""
JOINED = re.compile(r"(?:(?:and|but|then|or)\b\s*)*", re.IGNORECASE)
WORD = re.compile(r"[^\W_]+")
SMALL = re.compile(r"an?|the|its|his|her|with|of|by|for|from|to|at|in|on|onto|along|and|but|then|or", re.IGNORECASE)
MOST = 80
"""Readings of one text (some 60 ms each)."""
UNSAID = "nothing in S says it"
SAID = {REASON: "S would be the same without", UNSAID: "Nothing in S says"}

Span = tuple[int, int]


async def without_effect(text: str, tools: Tools, read_so: Structure | None = None) -> tuple[Unmet, ...]:
    """The phrases without which the embedded interpreter reads the same S, in the order of the text; what is within
    such a phrase, or was named as lost, is not named again. Where a model has read the text (`read_so`), those of them,
    and of what the interpreter does not understand, of which no word is in what that S says; none where only the model
    could read it. Raises Unreadable where the text cannot be read."""
    by_model = read_so is not None and read_so.read_by not in ("", "embedded")
    try:
        own = await read(text, tools)
    except Unreadable:
        if by_model:
            return ()
        raise
    found = await _without(text, (await phrases(text, tools, own.clauses))[:MOST], own, tools)
    if read_so is None or not by_model:
        return _notes(text, found, REASON)
    known = [u.span for u in _lost(read_so) if u.span]
    missed = [*found, *(u.span for u in own.not_understood if u.span)]
    unsaid = [s for s in missed if not _within(s, known) and not says(read_so, text[slice(*s)])]
    return _notes(text, unsaid, UNSAID)


def says(structure: Structure, phrase: str) -> bool:
    """Whether some word of a phrase, but for small ones, is in what S says in its sentences and fields."""
    stem = snowballstemmer.stemmer("english").stemWords
    told = " ".join(
        f"{c.description} {sentence(c, structure)} {c.spec.model_dump(exclude_defaults=True)}"
        for c in structure.components
    )
    words = [w for w in WORD.findall(phrase.lower()) if not SMALL.fullmatch(w)]
    return not words or bool(set(stem(words)) & set(stem(WORD.findall(told.lower().replace("_", " ")))))


def _notes(text: str, spans: Sequence[Span], reason: str) -> tuple[Unmet, ...]:
    outer = [s for s in set(spans) if not any(s != o and o[0] <= s[0] and s[1] <= o[1] for o in spans)]
    return tuple(Unmet(text=text[a:b].strip(" ,;.\n"), reason=reason, span=(a, b)) for a, b in sorted(outer))


def _within(span: Span, others: Sequence[Span]) -> bool:
    return any(a <= span[0] and span[1] <= b for a, b in others)


async def _without(text: str, parts: Sequence[tuple[Span, str]], structure: Structure, tools: Tools) -> list[Span]:
    """The spans of those phrases without which a text is read as the same S."""
    meant, known = _meant(structure), [u.span for u in _lost(structure) if u.span]
    found: list[Span] = []
    for (start, end), rest in parts:
        begin = start + JOINED.match(text[start:end]).end()  # type: ignore[union-attr]
        if _within((begin, end), [*found, *known]):
            continue
        try:  # a turn that is given up lets the reader finish: it would have to be started anew
            same = _same(_meant(await asyncio.shield(read(rest, tools))), meant)
        except Unreadable:
            continue
        if same and not _is_mostly_in_fields(structure, (start, end)):
            found.append((start, end))
    return found


async def edit_phrases_without_effect(text: str, upon: Structure, tools: Tools,
                                      learned: bool = False) -> tuple[Unmet, ...]:  # fmt: skip
    """The phrases of a change upon S without which it would be the same change, in the order of the text; of another
    description, those without which its S would be the same. None at all where the model that reads changes first
    (`learned`) has read it otherwise than the rules, which are asked here. Raises Unreadable."""
    asked = await route(text, upon, tools)
    if learned:
        by_model = await route(text, upon, tools, learned=upon)
        if _meant(_changed(upon, by_model.edits)) != _meant(_changed(upon, asked.edits)):
            return ()
    if asked.kind == "scenario":
        return await without_effect(text, tools)
    if asked.kind != "edit" or not asked.edits:
        return ()
    meant = _meant(_changed(upon, asked.edits))
    found: list[tuple[int, int]] = []
    for (start, end), rest in (await phrases(text, tools))[:MOST]:
        if any(a <= start and end <= b for a, b in found):
            continue
        without = await asyncio.shield(route(rest, upon, tools))
        if without.kind == "edit" and without.edits and _meant(_changed(upon, without.edits)) == meant:
            found.append((start, end))
    return tuple(Unmet(text=text[a:b].strip(" ,;.\n"), reason=REASON, span=(a, b)) for a, b in sorted(found))


def _changed(structure: Structure, edits: Sequence[Edit]) -> Structure:
    for edit in edits:
        structure = apply(structure, edit)
    return structure


def phrases_sentence(found: Sequence[Unmet], of: str = "") -> str:
    """These phrases in a sentence, with the beginning of the text that they are of."""
    said = " ".join(of.split())
    short = said if len(said) <= SHOWN else f"{said[:SHOWN].rsplit(' ', 1)[0]} ..."
    whose = f"Of “{short}”: " if said else ""
    by_reason: dict[str, list[str]] = {}
    for unmet in found:
        by_reason.setdefault(SAID.get(unmet.reason, SAID[REASON]), []).append(f"“{unmet.text}”")
    return whose + " ".join(f"{head}: {'; '.join(words)}." for head, words in by_reason.items())


def _is_mostly_in_fields(structure: Structure, phrase: tuple[int, int]) -> bool:
    """Whether S says what most words of a phrase say: other words, or what is usual, say it, too."""
    links = [(c.spec, li) for c in structure.components for li in c.links if li.span and li.field]
    fields = [li.span for spec, li in links if li.span and is_set(spec, li.field)]
    words = [m.span() for m in WORD.finditer(structure.text, *phrase) if not SMALL.fullmatch(m[0])]
    said = [word for word in words if any(a < word[1] and word[0] < b for a, b in fields)]
    return len(said) > len(words) / 2


def _lost(structure: Structure) -> list[Unmet]:
    return [*structure.not_understood, *structure.background, *(u for c in structure.components for u in c.unmet)]


def _same(without: list[Any], meant: list[Any]) -> bool:
    """Whether S is the same without a phrase; what it takes for granted with the phrase, the text without may say."""
    return len(without) == len(meant) and all(
        (cid, spec) == (other, held) and all(a in more for a in assumed)
        for (cid, spec, assumed), (other, held, more) in zip(without, meant, strict=True)
    )


def _meant(structure: Structure) -> list[Any]:
    """By component what S says, whatever its objects are called, and what it takes for granted."""
    return [
        (c.id, c.spec.model_dump(mode="json", exclude={"name"}), [(a.field, a.value) for a in c.assumed])
        for c in structure.components
    ]

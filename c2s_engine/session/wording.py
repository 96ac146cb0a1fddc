"""A component's sentence in other words: what the change of words says goes into that component's fields.

The old and the new sentence are read amid the same other sentences; fields in which the readings differ are set, and
nothing else, so that what was edited by hand since, or cannot be said in a sentence, stays.
"""

import re
from collections.abc import Callable, Sequence
from difflib import SequenceMatcher
from typing import Any, TypeGuard

from c2s_engine.session.no_effect import edit_phrases_without_effect
from c2s_engine.session.reader import Unreadable, phrases, read, route
from c2s_engine.structure.components import Component, Structure, Unmet
from c2s_engine.structure.edits import Edit, EditError, SetDescription, SetField, SetSpec, apply

NOWHERE = "no field of S says it"
Span = tuple[int, int]
Sentences = Callable[[Structure, str], str]
_WORD = re.compile(r"\w+(?:[.'’-]\w+)*")


async def reworded(structure: Structure, edits: Sequence[Edit], tools: Any) -> tuple[list[Edit], list[str]]:
    """The edits, each new sentence followed by the edits of fields that it means; and a sentence on each.

    A sentence that comes with edits of its component's fields only says what they do."""
    found: list[Edit] = []
    replies = []
    told = {e.component for e in edits if isinstance(e, SetSpec) or isinstance(e, SetField) and not _rewords(e)}
    for edit in edits:
        after = apply(structure, edit)
        found.append(edit)
        if not _rewords(edit) or edit.component in told:
            structure = after
            continue
        if structure[edit.component].description != after[edit.component].description:
            meant, lost, reply = await _meant(structure, after, edit.component, tools)
            new = after[edit.component]
            unmet = (*(u for u in new.unmet if u.reason != NOWHERE or u.text in new.description), *lost)
            found[-1] = SetDescription(component=new.id, description=new.description, unmet=tuple(dict.fromkeys(unmet)))
            found += meant
            replies.append(reply)
            for one in meant:
                after = apply(after, one)
        structure = after
    return found, replies


def _rewords(edit: Edit) -> TypeGuard[SetDescription | SetField]:
    return isinstance(edit, SetDescription) or isinstance(edit, SetField) and edit.path == "description"


async def _meant(before: Structure, after: Structure, cid: str, tools: Any) -> tuple[list[Edit], list[Unmet], str]:
    """The edits of fields that a new sentence means, what of its new words is in no field, and what to say of both."""
    sentence = after[cid].description
    whole = [Unmet(text=sentence, reason=NOWHERE)] if sentence.strip() else []
    reading = after
    try:
        was, becomes, sentences = await _readings(before, after, cid, tools)
    except Unreadable as error:
        return [], whole, f"{cid}: the sentence is kept, the fields are unchanged: {error}"
    if becomes is None:
        said = f"{cid}: the sentence is kept, the fields are unchanged: it does not read as a description of {cid}."
        return [], whole, said
    old = was.spec.model_dump(mode="json") if was is not None else {}
    new, assumed = becomes.spec.model_dump(mode="json"), {a.field.split(".")[0] for a in becomes.assumed}
    changes: list[Edit] = []
    refused = []
    for path, value in new.items():
        if value == old.get(path) or path in ("component", "name") or (was is None and path in assumed):
            continue
        edit = SetField(component=cid, path=path, value=value)
        try:
            after = apply(after, edit)
        except EditError as error:
            refused.append(str(error))
            continue
        changes.append(edit)
    lost: list[str] = []
    if not changes and not refused:  # what a scene does not say may still be understood as a change
        asked = await route(sentence, before, tools)
        changes = [e for e in asked.edits if isinstance(e, SetField | SetSpec) and e.component == cid]
        if changes:
            spans = [u.span for u in await edit_phrases_without_effect(sentence, before, tools) if u.span]
            lost = [sentence[a:b] for a, b in spans if _meets((a, b), _new(before[cid].description, sentence))]
    if not lost and (not changes or becomes.spec != getattr(was, "spec", None)):
        lost = await _without_effect(before[cid].description, reading, becomes, sentences, tools)
    told = [str(c.path) if isinstance(c, SetField) else "all" for c in changes]
    reply = f"{cid}: the sentence was read; {', '.join(told).replace('_', ' ')} changed." if told else (
        f"{cid}: the sentence was read; it says nothing that changes its fields.")  # fmt: skip
    words = [text.strip(" ,;.") for text in lost]
    if words:
        named = "; ".join(f"“{text}”" for text in words)
        kept = f"{named} {'is' if len(words) == 1 else 'are'} not in S: the sentence is kept, and that is marked in it."
        reply = f"{reply} {kept}" if told else f"{cid}: {kept}"
    said = " ".join([reply, *(f"{r}." for r in refused)])
    return changes, [Unmet(text=text, reason=NOWHERE) for text in words], said


async def _without_effect(
    old: str, structure: Structure, meant: Component, sentences: "Sentences", tools: Any
) -> list[str]:
    """The phrases among the new words of a sentence without which it would say the same of its component."""
    sentence, cid = structure[meant.id].description, meant.id
    new, found = _new(old, sentence), list[Span]()
    here = structure.ids.index(cid) if sentences is _all else None
    for span, rest in await phrases(sentence, tools):
        if not _meets(span, new) or any(a <= span[0] and span[1] <= b for a, b in found):
            continue
        without = structure.with_component(structure[cid].model_copy(update={"description": rest}))
        try:
            read_so = _component(await read(sentences(without, cid), tools), cid, here)
        except (Unreadable, IndexError):
            continue
        if read_so is not None and read_so.spec == meant.spec:
            found.append(span)
    return [sentence[a:b] for a, b in sorted(found)]


def _new(old: str, sentence: str) -> list[Span]:
    """The words of a sentence that are not those of the old one."""
    words = list(_WORD.finditer(sentence))
    codes = SequenceMatcher(None, _WORD.findall(old), [w[0] for w in words], autojunk=False).get_opcodes()
    return [(words[c].start(), words[d - 1].end()) for _, _, _, c, d in (o for o in codes if o[0] != "equal") if d > c]


def _meets(span: Span, others: Sequence[Span]) -> bool:
    """Whether all words of a phrase are among others."""
    return any(a <= span[0] and span[1] <= b for a, b in others)


async def _readings(
    before: Structure, after: Structure, cid: str, tools: Any
) -> tuple[Component | None, Component | None, "Sentences"]:
    """The component as the old and the new sentence say it, and among which sentences it says so."""
    for sentences in (_all, _alone):
        try:
            found = [await read(sentences(s, cid), tools) for s in (before, after)]
        except Unreadable:
            if sentences is _alone:
                raise
            continue
        if sentences is _alone or all(len(f.objects) == len(before.objects) for f in found):
            break
    here = before.ids.index(cid) if sentences is _all else None
    was, becomes = (_component(f, cid, here) for f in found)
    return was, becomes, sentences


def _component(found: Structure, cid: str, here: int | None) -> Component | None:
    if not cid.startswith("O"):
        return found[cid]
    if here is not None:
        return found.components[here]
    return found.objects[0] if found.objects else None


def _all(structure: Structure, cid: str) -> str:
    """Every component's sentence, in S's order."""
    return " ".join(_closed(c) for c in structure.components if c.description)


def _alone(structure: Structure, cid: str) -> str:
    """The component's sentence after ego's, without which a text tells of no scene."""
    component = structure[cid]
    return _closed(component) if cid == "E" else f"{_closed(structure.ego)} {_closed(component)}"


def _closed(component: Component) -> str:
    text = component.description.strip() or "Ego drives."
    return text if text[-1] in ".!?" else f"{text}."

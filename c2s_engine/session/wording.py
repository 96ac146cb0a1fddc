"""A component's sentence in other words: what the change of words says goes into that component's fields.

The new sentence is read as a change of its component; what that would change of others is left alone, so that what was
edited by hand since, or cannot be said in a sentence, stays.
"""

import re
from collections.abc import Sequence
from difflib import SequenceMatcher
from typing import Any, TypeGuard

from c2s_engine.session.no_effect import without_effect
from c2s_engine.session.reader import Unreadable, change
from c2s_engine.structure.account import UNSAID
from c2s_engine.structure.components import Structure, Unmet
from c2s_engine.structure.edits import Edit, SetDescription, SetField, SetSpec, apply
from c2s_engine.structure.sentences import sentence as usual_sentence
from c2s_engine.structure.specs import ObjectSpec

Span = tuple[int, int]
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
            unmet = (*(u for u in new.unmet if u.reason != UNSAID or u.text in new.description), *lost)
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
    if not sentence.strip():
        return [], [], f"{cid}: the sentence is empty; the fields are unchanged."
    try:
        asked = await change(f"{'ego' if cid == 'E' else cid}: {sentence}", before, tools)
    except Unreadable as error:
        whole = [Unmet(text=sentence, reason=UNSAID)]
        return [], whole, f"{cid}: the sentence is kept, the fields are unchanged: {error}"
    edits = [e for e in asked if isinstance(e, SetSpec) and e.component == cid]
    changes: list[Edit] = []
    told: list[str] = []
    for edit in edits:
        old, new = before[cid].spec.model_dump(mode="json"), edit.spec.model_dump(mode="json")
        changed = [path for path in new if new[path] != old.get(path) and path not in ("component", "name")]
        changes += [SetField(component=cid, path=path, value=new[path]) for path in changed]
        told += changed
    for made in changes:
        after = apply(after, made)
    new_words = _new(before[cid].description, sentence)
    unsaid = after.with_component(after[cid].model_copy(update={"description": ""}))
    idle = await without_effect(sentence, unsaid, tools)
    words = [u.text for u in idle if u.span and _meets(u.span, new_words)]
    words += _others(sentence, new_words, after, cid)
    reply = f"{cid}: the sentence was read; {', '.join(told).replace('_', ' ')} changed." if told else (
        f"{cid}: the sentence was read; it says nothing that changes its fields.")  # fmt: skip
    if words:
        named = "; ".join(f"“{text}”" for text in words)
        kept = f"{named} {'is' if len(words) == 1 else 'are'} not in S: the sentence is kept, and that is marked in it."
        reply = f"{reply} {kept}" if told else f"{cid}: {kept}"
    return changes, [Unmet(text=text, reason=UNSAID) for text in words], reply


def _others(sentence: str, new: Sequence[Span], after: Structure, cid: str) -> list[str]:
    """The others that the new words of a sentence name and that its fields do not."""
    names = {c.spec.name.replace("_", " ") for c in after.objects if isinstance(c.spec, ObjectSpec) and c.id != cid}
    said, named = usual_sentence(after[cid], after), []
    for word in (re.compile(rf"\b{re.escape(name)}\b", re.IGNORECASE) for name in sorted({"ego", *names})):
        found = word.search(sentence)
        if found and _meets(found.span(), new) and not word.search(said):
            named.append(found[0])
    return named


def _new(old: str, sentence: str) -> list[Span]:
    """The words of a sentence that are not those of the old one."""
    words = list(_WORD.finditer(sentence))
    codes = SequenceMatcher(None, _WORD.findall(old), [w[0] for w in words], autojunk=False).get_opcodes()
    return [(words[c].start(), words[d - 1].end()) for _, _, _, c, d in (o for o in codes if o[0] != "equal") if d > c]


def _meets(span: Span, others: Sequence[Span]) -> bool:
    """Whether all words of a phrase are among others."""
    return any(a <= span[0] and span[1] <= b for a, b in others)

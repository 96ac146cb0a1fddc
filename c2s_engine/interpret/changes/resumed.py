"""What somebody does when he has done what he does already: "once it has overtaken ego, the car cuts in".

"Thereafter the car cuts in" is read instead.
"""

import re
from functools import cache

from c2s_engine.interpret import language
from c2s_engine.interpret.changes.refer import actions_of, refer, spec_of
from c2s_engine.structure.components import Component, Structure


def resumed(sentence: str, structure: Structure) -> str:
    """The sentence with "thereafter" for a clause that only tells the end of what the same one does; else as it is."""
    match = next((m for pattern in _patterns() if (m := pattern.match(sentence))), None)
    if match is None:
        return sentence
    said = match.groupdict()
    doer = _doer(said.get("who"), said["then"], said["done"], structure)
    if doer is None:
        return sentence
    return f"thereafter {doer.id.lower()}{said.get('should') or ''} {sentence[match.end() :]}"


def _doer(who: str | None, then: str, done: str, structure: Structure) -> Component | None:
    """The one who has done it and does something then; None where these are two, or where he does not do it."""
    named = [refer(words, structure, alone=False) for words in (who, then) if words]
    meant = {c.id for c in named if c is not None}
    acts = next((a for pattern, a in _table()["acts"] if re.search(pattern, done)), None)
    there = [c for c in structure.objects if _does(c, acts)]
    if meant:
        there = [c for c in there if meant == {c.id}]
    return there[0] if len(there) == 1 else None


def _does(component: Component, acts: list[str] | None) -> bool:
    """Whether somebody does one of these, or moves at all where it is not said what."""
    found = actions_of(component)
    return bool(set(found) & set(acts)) if acts else bool(found) and spec_of(component).speed != 0.0


def _table() -> dict[str, list[tuple[str, list[str]]]]:
    found: dict[str, list[tuple[str, list[str]]]] = language.table("wordings")["resumed"]
    return found


@cache
def _patterns() -> list[re.Pattern[str]]:
    table = language.table("wordings")["resumed"]
    return [re.compile(language.filled(form, table["words"])) for form in table["forms"]]

"""Refinements without a model: the common forms of change become edits that touch only what was meant."""

import re
from typing import Any

from c2s_engine.interpret import changes, describe, language, scan
from c2s_engine.structure.components import Structure
from c2s_engine.structure.edits import Edit, EditError, SetField, apply

Found = tuple[list[Edit], str]


def edits_of(text: str, structure: Structure) -> tuple[list[Edit], list[str]]:
    """The edits that a text asks for and what each does, in order; empty where nothing was understood."""
    edits: list[Edit] = []
    said: list[str] = []
    current = structure
    before = ""
    for clause in clauses_of(text):
        clause = _whole(clause, before, next((e.component for e in reversed(edits) if _of_one(e)), None))
        before = clause
        for form in changes.FORMS:
            found = form(clause, current)
            if found is None:
                continue
            new, words = found
            try:
                for edit in new:
                    current = apply(current, edit)
            except EditError as error:
                said.append(str(error))
                break
            edits += new
            said.append(words)
            break
    return [*edits, *described(structure, current)], said


def _of_one(edit: Edit) -> bool:
    return str(getattr(edit, "component", None) or "").startswith("O")


def _whole(clause: str, before: str, topic: str | None) -> str:
    """The clause with what it leaves out: "it" is whom the one before changed, "the child too" has what was said there,
    and a bare number has its unit.
    """
    table = language.table("refine")
    if topic is not None:
        clause = re.sub(r"^(then )?(?:it|he|she|they)\b", rf"\g<1>{topic.lower()}", clause)
    named = scan.names(before)
    if (too := re.match(table["as_well"], clause)) and named and scan.names(clause):
        head = re.sub(r"\b(?:the|an?|my|our)\s*$", "", before[: named[0].start])
        return f"{head}{too['who']}{before[named[0].end :]}"
    unit = re.search(table["unit"], before)
    return f"{clause} {unit[1]}" if unit and re.search(r"[a-z] \d+$", clause) else clause


def described(before: Structure, after: Structure) -> list[Edit]:
    """The sentences of the components whose specs changed."""
    names = {c.id: c.spec.name for c in after.objects}  # type: ignore[union-attr]
    edits: list[Edit] = []
    for component in after.components:
        if component.id in before and before[component.id].spec == component.spec or component.id == "T":
            continue
        spec: Any = component.spec
        if component.id == "E":
            words = describe.ego(spec, after.place.spec, names)  # type: ignore[arg-type]
        elif component.id.startswith("O"):
            words = describe.obj(spec, names)
        else:
            words = describe.place(spec) if component.id == "R" else describe.settings(spec)
        if words != component.description:
            edits.append(SetField(component=component.id, path="description", value=words))
    return edits


def clauses_of(text: str) -> list[str]:
    """The single demands of a text: "make the lead a truck and remove the rain" has two."""
    plain = " ".join(scan.normalised(text).replace("?", " ").replace("!", " ").split())
    table = language.table("refine")
    plain = re.sub(table["openers"], "", plain)
    plain = re.sub(table["the_same_but"], r"\g<what> instead", plain)
    starts = table["clause_starts"]
    parts = re.split(
        rf"(?:[.;]\s+|,?\s+(?:and|but)\s+(?=(?:then )?{starts})|,?\s+(?=then {starts})|,\s+(?={starts}))", plain
    )
    return [re.sub(table["closers"], "", p.strip(" .,;")) for p in parts if p.strip(" .,;")]


__all__: list[Any] = ["clauses_of", "edits_of"]

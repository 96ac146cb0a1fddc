"""What stands at the end of a turn."""

from collections.abc import Collection
from typing import Any

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.account import requirements_met
from c2s_engine.structure.components import Component, Structure, field_words
from c2s_engine.structure.diagnostics import StageResult
from c2s_engine.structure.edits import (
    AddObject,
    Edit,
    MoveObject,
    RemoveObject,
    Replace,
    SetCode,
    SetDescription,
    SetField,
    SetProgram,
    SetSpec,
)
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.measures import Measures
from c2s_engine.structure.program import Program
from c2s_engine.structure.progress import Finished
from c2s_engine.structure.quantity import ends, in_words
from c2s_engine.structure.requirements import Requirement, Result
from c2s_engine.structure.values import text_of

KEPT_DETAILS = ("map", "room", "folder", "places", "passages")
"""What saving the program, other runs of it and the status line need, and the passages of the last answer."""
NOTHING = "nothing changed"
"""The summary of a turn that left S and its program as they were: a question, say."""


class State(BaseModel):
    """S, its program, how the checks of it went, and what its rollouts showed."""

    model_config = ConfigDict(frozen=True)  # fields of later versions are passed over

    structure: Structure = Structure()
    program: Program = Program(text="")
    stages: tuple[StageResult, ...] = ()
    facts: tuple[RunFacts, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    results: tuple[Result, ...] = ()
    measures: tuple[Measures, ...] = ()
    details: dict[str, Any] = {}

    def after(self, finished: Finished) -> "State":
        """What stands at the end of a turn upon this; a turn that changed nothing leaves runs and verdicts as well."""
        if not finished.details.get("unchanged"):
            return State.of(finished)
        kept = {k: finished.details[k] for k in KEPT_DETAILS if k in finished.details}
        return self.model_copy(update={"details": {**self.details, **kept}})

    @classmethod
    def of(cls, finished: Finished) -> "State":
        return cls(
            structure=finished.structure,
            program=finished.program,
            stages=finished.stages,
            facts=finished.facts,
            requirements=finished.requirements,
            results=finished.results,
            measures=finished.measures,
            details={k: finished.details[k] for k in KEPT_DETAILS if k in finished.details},
        )

    def same(self, other: "State") -> bool:
        """Whether S and its program are those of another state: nothing to undo from one to the other."""
        return (self.structure, self.program) == (other.structure, other.program)

    def finished(self) -> Finished:
        """The event that tells a front to show this."""
        ok = all(s.ok for s in self.stages)
        return Finished(
            ok=ok,
            structure=self.structure,
            program=self.program,
            stages=self.stages,
            facts=self.facts,
            requirements=self.requirements,
            results=self.results,
            measures=self.measures,
            details=self.details,
        )


def cleared(structure: Structure, components: Collection[str] = ()) -> Structure:
    """The structure with those components' fragments (default: all that the engine wrote) marked as not written."""

    def clear(component: Component) -> Component:
        ours = component.origin in ("rendered", "generated")
        asked = component.id in components if components else True
        return component.model_copy(update={"key": ""}) if ours and asked else component

    for component in structure.components:
        structure = structure.with_component(clear(component))
    return structure


def futile(finished: Finished) -> bool:
    """Whether a turn came to nothing: a text that could not be read, a change that was not understood."""
    unread = any(s.name == "interpret" and not s.ok for s in finished.stages)
    told = finished.details
    return unread or bool(told.get("unchanged")) and told.get("turn") in ("edit", "scenario")


def summary(before: State, after: State) -> str:
    """In a few words, what a turn changed."""
    old = {c.id: c for c in before.structure.components}
    new = {c.id: c for c in after.structure.components}
    changed = [i for i in new if i in old and (old[i].spec, old[i].code) != (new[i].spec, new[i].code)]
    parts = [
        f"{word} {', '.join(ids)}"
        for word, ids in (
            ("added", [i for i in new if i not in old]),
            ("removed", [i for i in old if i not in new]),
            ("changed", changed),
        )
        if ids
    ]
    failed = next((s.name for s in after.stages if not s.ok), "")
    if failed and after != before:
        parts.append(f"{failed} fails")
    if parts and not failed and (met := requirements_met(after.structure, after.results)):
        parts.append(met)
    return "; ".join(parts) or (NOTHING if after.same(before) else "other words")


def edit_words(edit: Edit) -> str:
    """What an edit of S does, in a few words, as the history names it."""
    if isinstance(edit, SetProgram):
        return "code edited by hand"
    if isinstance(edit, Replace):
        return "program opened"
    if isinstance(edit, AddObject):
        return f"add {edit.spec.type.replace('_', ' ')}"
    if isinstance(edit, RemoveObject | MoveObject):
        return f"{edit.kind} {edit.component}"
    return f"{edit.component}: {_of_component(edit)}"


def _of_component(edit: SetCode | SetDescription | SetSpec | SetField) -> str:
    if isinstance(edit, SetCode):
        return "written from its fields again" if edit.code is None else "code by hand"
    if not isinstance(edit, SetField):
        return f"“{edit.description}”" if edit.description else "other fields"
    value = edit.value
    if edit.path == "description":
        return f"“{value}”"
    shown = in_words(edit.path, value) if ends(value) else text_of(value).replace("_", " ")
    return f"{field_words(edit.path)} {shown or 'left open'}"

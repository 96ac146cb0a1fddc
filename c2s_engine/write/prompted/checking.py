"""A fragment checked on the prefix of the program that it ends, and mended as far as that is certain."""

from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass

from c2s_engine.check.protocol import CheckReport, Upto
from c2s_engine.structure.components import Component, ComponentId, Structure
from c2s_engine.structure.diagnostics import Diagnostic, TextEdit
from c2s_engine.structure.program import FragmentSpan, Program, assemble, border, parted

Check = Callable[[str, Sequence[FragmentSpan], Upto], Awaitable[CheckReport]]
Fix = Callable[[str, Sequence[Diagnostic]], str]
"""Program text and its diagnostics to the text with all certain corrections made."""

ROUNDS = 4
STAGES = ("parse", "safety", "compile", "sample", "run")


@dataclass(frozen=True)
class Verdict:
    """What became of a fragment: its code (perhaps corrected), how far it came, and what stands against it."""

    code: str
    stage: int
    diagnostic: Diagnostic | None = None
    fixed: int = 0

    @property
    def ok(self) -> bool:
        return self.diagnostic is None


def upto(cid: ComponentId) -> Upto:
    """How far a prefix can be checked: before ego is there, no scene is worth sampling."""
    return "compile" if cid in ("G", "R") else "sample"


def prefix(structure: Structure, cid: ComponentId, code: str | None = None) -> Program:
    """The program up to and with a component (with that code in it)."""
    ids = structure.ids[: structure.ids.index(cid) + 1]
    kept = structure
    for component in structure.components:
        if component.id not in ids:
            kept = kept.with_component(component.model_copy(update={"code": ""}))
    if code is not None:
        kept = kept.with_component(with_code(kept[cid], code))
    return assemble(kept)


def with_code(component: Component, code: str) -> Component:
    """The component with a generated fragment, under its border line."""
    text = f"{border(component)}\n{code.strip()}\n"
    return component.model_copy(update={"code": text, "origin": "generated", "conflict": None})


def body(code: str) -> str:
    """A fragment without its border line."""
    return parted(code)[1]


async def verdict(structure: Structure, cid: ComponentId, code: str, check: Check, fix: Fix | None = None) -> Verdict:
    """Check a fragment on its prefix; corrections that a diagnostic carries are made, as long as they help."""
    fixed = 0
    while True:
        program = prefix(structure, cid, code)
        report = await check(program.text, program.spans, upto(cid))
        found = first_error(report)
        if found is None:
            return Verdict(code, len(STAGES), None, fixed)
        corrected = corrections(program, cid, report, fix)
        if corrected is None or corrected == code or fixed == ROUNDS:
            return Verdict(code, stage_of(found), local(found, program.span_of(cid)), fixed)
        code, fixed = corrected, fixed + 1


def first_error(report: CheckReport) -> Diagnostic | None:
    """The first finding that stopped a check."""
    for stage in report.stages:
        if not stage.ok:
            errors = [d for d in stage.diagnostics if d.severity == "error"]
            return errors[0] if errors else Diagnostic(stage=stage.name, message=f"the {stage.name} stage failed")
    return None


def stage_of(diagnostic: Diagnostic) -> int:
    return STAGES.index(diagnostic.stage) if diagnostic.stage in STAGES else 0


def local(diagnostic: Diagnostic, span: FragmentSpan | None) -> Diagnostic:
    """The finding with its line counted within the fragment's body (1-based); no line where it lies elsewhere."""
    if diagnostic.line is None or span is None or not span.first < diagnostic.line <= span.last:
        return diagnostic.model_copy(update={"line": None})
    return diagnostic.model_copy(update={"line": diagnostic.line - span.first})


def corrections(program: Program, cid: ComponentId, report: CheckReport, fix: Fix | None) -> str | None:
    """The fragment's body after the certain corrections of a report; none where there is nothing to correct."""
    diagnostics = [d for s in report.stages for d in s.diagnostics]
    span = program.span_of(cid)
    if span is None:
        return None
    inside = [d.edit for d in diagnostics if d.edit and span.first < d.edit.first <= d.edit.last <= span.last]
    if inside:
        text = applied(program.text, inside)
    elif fix is not None:
        text = fix(program.text, diagnostics)
    else:
        return None
    lines, before = text.splitlines(), program.text.splitlines()[: span.first]
    if lines[: span.first] != before:
        return None  # a correction outside the fragment is not this component's to make
    return "\n".join(lines[span.first :]).strip("\n")


def applied(text: str, edits: Sequence[TextEdit]) -> str:
    """The text after edits; where two overlap, the later one of them is left out."""
    lines = text.splitlines()
    done: list[TextEdit] = []
    for edit in edits:
        if all(edit.last < other.first or edit.first > other.last for other in done):
            done.append(edit)
    for edit in sorted(done, key=lambda e: e.first, reverse=True):
        lines[edit.first - 1 : edit.last] = edit.text.splitlines()
    return "\n".join(lines) + "\n"

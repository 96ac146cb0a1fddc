"""From an exception to a diagnostic: which line of the user's program, which component, why, and what to do."""

import re
import traceback
from typing import Any

from c2s_engine.check import catalogue, errors, fixes
from c2s_engine.structure.diagnostics import Diagnostic, StageName
from c2s_engine.structure.facts import RunFacts
from c2s_engine.structure.program import FragmentSpan


class Program:
    """The checked text with its lines and the components that they belong to."""

    def __init__(self, text: str, filename: str, spans: Any = ()) -> None:
        self.text = text
        self.filename = filename
        self.lines = text.split("\n")
        self.lines = [line + "\n" for line in self.lines[:-1]] + ([self.lines[-1]] if self.lines[-1] else [])
        self.spans = tuple(s if isinstance(s, FragmentSpan) else FragmentSpan.model_validate(s) for s in spans)

    def component_at(self, line: int | None) -> str | None:
        if line is None:
            return None
        return next((s.component for s in self.spans if s.first <= line <= s.last), None)

    def line(self, number: int | None) -> str:
        if number is None or not 1 <= number <= len(self.lines):
            return ""
        return self.lines[number - 1].rstrip("\r\n")

    def locate(self, diagnostic: Diagnostic) -> Diagnostic:
        """The diagnostic with the component and the text of its line."""
        diagnostic = fixes.attach(diagnostic, self.line(diagnostic.line))
        return diagnostic.model_copy(
            update={
                "component": diagnostic.component or self.component_at(diagnostic.line),
                "text": diagnostic.text or self.line(diagnostic.line).strip(),
            }
        )


def diagnose(error: BaseException, stage: StageName, program: Program) -> Diagnostic:
    """The diagnostic of an exception that a stage raised."""
    line, column = position(error, program)
    found = errors.explain(error, stage, program.lines, line)
    if found.line is not None:
        line, column = found.line, None
    diagnostic = Diagnostic(
        stage=stage,
        message=found.message,
        code=found.code,
        line=line,
        column=column,
        fix=found.fix,
        edit=found.edit,
    )
    return program.locate(diagnostic)


AT_ONCE = 0.25  # s


def ending(facts: RunFacts, program: Program) -> list[Diagnostic]:
    """What the end of a run says: that it failed (who, when, on which line), or that it was over at once."""
    reason = facts.reason or f"the run was {facts.ended_by}"
    if facts.ended_by not in ("rejected", "error"):
        if facts.ended_by != "terminated" or facts.duration > AT_ONCE:
            return []
        found = re.search(r"line (\d+)", reason)
        return [program.locate(catalogue.finding("ends_at_once", int(found[1]) if found else None, None))]
    said = re.fullmatch(r"(?P<when>at .*?)?(?:, )?(?:line (?P<line>\d+))?: (?P<text>.*)", reason, re.S)
    line = int(said["line"]) if said and said["line"] else None
    text = said["text"] if said else reason
    if required := re.search(r"requirement on line (\d+)", text):
        failed = program.locate(catalogue.finding("run_requirement", int(required[1]), None))
        when = f" ({said['when']})" if said and said["when"] else ""
        return [failed.model_copy(update={"message": f"{failed.message}: {failed.text}{when}"})]
    kind, _, words = text.partition(": ")
    doing = re.search(r"\bin (\w+) of ", said["when"] or "") if said else None
    hit = catalogue.find([kind], words, program.line(line), doing[1] if doing else "") if words else None
    if hit is None:
        hit = catalogue.entries()["run_" + facts.ended_by], {}
        message = reason
    else:
        message = catalogue.fill(hit[0].message, hit[1]) + (f" ({said['when']})" if said and said["when"] else "")
    entry, values = hit
    diagnostic = Diagnostic(
        stage="run",
        code=entry.code,
        message=message,
        line=line,
        fix=catalogue.fill(entry.fix, values),
        edit=fixes.propose(entry, values, program.lines, line),
    )
    return [program.locate(diagnostic)]


def position(error: BaseException, program: Program) -> tuple[int | None, int | None]:
    """Line and column (1-based) in the user's program, as far as the exception tells."""
    line = getattr(error, "lineno", None)
    name = getattr(error, "filename", None)
    if isinstance(line, int) and (name in (None, program.filename)):
        return min(line, max(1, len(program.lines))), _column(getattr(error, "offset", None))
    location = getattr(error, "_scenic_location", None)
    if location is not None and location.filename == program.filename:
        return location.lineno, None
    current: BaseException | None = error
    while current is not None:
        frames = [f for f in traceback.extract_tb(current.__traceback__) if f.filename == program.filename]
        if frames:
            column = frames[-1].colno
            return frames[-1].lineno, None if column is None else column + 1
        current = current.__cause__ or current.__context__
    return lines_of(error), None


made_on: dict[int, int] = {}
"""Line of the program on which a random value or object was made, by its id (naming.py)."""


def lines_of(error: BaseException) -> int | None:
    """Where an exception was raised while a random value was drawn: the line on which that value was made."""
    current: BaseException | None = error
    found: int | None = None
    if not made_on:
        return None
    while current is not None and found is None:
        tb = current.__traceback__
        while tb is not None:
            owner = tb.tb_frame.f_locals.get("self")
            found = made_on.get(id(owner), found) if owner is not None else found
            tb = tb.tb_next
        current = current.__cause__ or current.__context__
    return found


def _column(offset: Any) -> int | None:
    return offset if isinstance(offset, int) and offset > 0 else None

"""What a check reports: stages, diagnostics, and the edits that mend them."""

from typing import Literal

from pydantic import BaseModel, ConfigDict

StageName = Literal["interpret", "resolve", "write", "parse", "safety", "compile", "sample", "run", "solve"]
Severity = Literal["error", "warning", "info"]


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class TextEdit(_Frozen):
    """Replace lines `first`..`last` of the program (1-based, inclusive) by `text`."""

    first: int
    last: int
    text: str
    reason: str


class Diagnostic(_Frozen):
    """One finding: where, why, and what to do."""

    stage: StageName
    message: str
    code: str = ""
    severity: Severity = "error"
    component: str | None = None
    line: int | None = None
    column: int | None = None
    text: str = ""
    fix: str = ""
    edit: TextEdit | None = None


class StageResult(_Frozen):
    """How one stage went."""

    name: StageName
    ok: bool
    seconds: float = 0.0
    diagnostics: tuple[Diagnostic, ...] = ()

"""What an exception means to the author of a program: cause, code, fix."""

from dataclasses import dataclass

from c2s_engine.structure.diagnostics import StageName


@dataclass(frozen=True)
class Explained:
    message: str
    code: str = ""
    fix: str = ""


def explain(error: BaseException, stage: StageName, line: str) -> Explained:
    """The explanation of an exception."""
    text = str(error) or type(error).__name__
    return Explained(message=f"{type(error).__name__}: {text}", code=type(error).__name__)

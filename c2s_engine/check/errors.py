"""What an exception means to the author of a program: cause, code, fix, edit."""

import dataclasses
import re
from dataclasses import dataclass

from c2s_engine.check import catalogue, fixes
from c2s_engine.structure.diagnostics import StageName, TextEdit


@dataclass(frozen=True)
class Explained:
    message: str
    code: str = ""
    fix: str = ""
    edit: TextEdit | None = None
    line: int | None = None  # where it is another line than that of the exception


def explain(error: BaseException, stage: StageName, lines: list[str], number: int | None) -> Explained:
    """The explanation of an exception that was raised on a line (1-based) of the program."""
    text = _text(error)
    line = lines[number - 1].rstrip("\r\n") if number is not None and 1 <= number <= len(lines) else ""
    kinds = [k.__name__ for k in type(error).__mro__]
    found = catalogue.find(kinds, text, line)
    if found is None:
        return Explained(message=f"{type(error).__name__}: {text}", code=type(error).__name__)
    entry, values = found
    edit = fixes.propose(entry, values, lines, number)
    if entry.code == "missing_comma" and edit is None and number is not None:
        head = fixes.head_of(lines, number)
        if head != number:
            return dataclasses.replace(explain(error, stage, lines, head), line=head)
    return Explained(
        message=catalogue.fill(entry.message, values),
        code=entry.code,
        fix=catalogue.fill(entry.fix, values),
        edit=edit,
    )


def _text(error: BaseException) -> str:
    text = str(error) or type(error).__name__
    return re.sub(r" object at 0x[0-9a-f]+", "", text)[:500]

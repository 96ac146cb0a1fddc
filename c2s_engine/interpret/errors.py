"""What can go wrong with a text, as sentences for the user."""

import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from c2s_engine.structure.edits import EditError


class InterpretError(ValueError):
    """A text that no scenario can be read from; the message says what would do."""


class InterpreterFault(RuntimeError):
    """A fault of the interpreter, not of the text: what failed, where, and what to do."""


@contextmanager
def faults() -> Iterator[None]:
    """Tell what fails inside as an InterpreterFault that names the place; the first failure is its cause."""
    try:
        yield
    except (InterpretError, InterpreterFault):
        raise
    except EditError as error:  # what S refuses, with why
        raise InterpreterFault(f"{error}. Nothing was changed.") from None
    except Exception as error:
        frames = traceback.extract_tb(error.__traceback__)
        at = next(f for f in reversed(frames) if "c2s_engine" in Path(f.filename).parts)
        raise InterpreterFault(
            f"c2s failed at this text ({type(error).__name__} in {Path(at.filename).name}, line {at.lineno}); the "
            "fault is in c2s, please report it with the text. Nothing was changed; shorter sentences may do."
        ) from error

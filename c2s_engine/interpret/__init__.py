"""Text to S without a language model, and what a turn upon S asks for."""

import re

# The language's tables hold some 4,000 patterns. `re` keeps 512 and, when they are full, compiles each anew at every
# use, which took five sixths of the time of a turn. Where a Python has no such limit, this line changes nothing.
re._MAXCACHE = 8192  # type: ignore[attr-defined]

from c2s_engine.interpret.embedded import (  # noqa: E402
    EmbeddedInterpreter,
    Interpretation,
    InterpreterFault,
    InterpretError,
)

__all__ = ["EmbeddedInterpreter", "InterpretError", "Interpretation", "InterpreterFault"]

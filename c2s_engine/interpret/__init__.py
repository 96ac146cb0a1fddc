"""Text to S, and what a turn upon S asks for."""

from c2s_engine.interpret.errors import InterpreterFault, InterpretError

__all__ = ["InterpretError", "InterpreterFault"]

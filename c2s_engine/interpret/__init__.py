"""Text to S without a language model, and what a turn upon S asks for."""

from c2s_engine.interpret.embedded import EmbeddedInterpreter, Interpretation, InterpretError

__all__ = ["EmbeddedInterpreter", "InterpretError", "Interpretation"]

"""Understanding with a language model: components, typed specs, settings, turns."""

from c2s_engine.interpret.llm.typed import Reading, TypedReader, interpret

__all__ = ["Reading", "TypedReader", "interpret"]

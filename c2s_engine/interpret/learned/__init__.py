"""Understanding with the learned reader: a small model fine-tuned to answer a text with S in short notation."""

from c2s_engine.interpret.learned.reader import LearnedReader

__all__ = ["LearnedReader"]

"""Understanding with the learned reader: a small model fine-tuned to answer a text with S in short notation."""

from c2s_engine.interpret.learned.change import Change, read_change
from c2s_engine.interpret.learned.decoder import Answer, ReaderError, installed, loaded
from c2s_engine.interpret.learned.reader import Read, asked, learned, reading

__all__ = [
    "Answer", "Change", "Read", "ReaderError", "asked", "installed", "learned", "loaded", "read_change", "reading",
]  # fmt: skip

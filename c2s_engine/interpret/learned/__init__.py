"""Understanding with the learned reader: a small model fine-tuned to answer a text with S in short notation."""

from c2s_engine.interpret.learned.decoder import Answer, ReaderError, installed, loaded
from c2s_engine.interpret.learned.reader import asked, reading
from c2s_engine.interpret.llm.typed import Embedded, Reading

__all__ = ["Answer", "ReaderError", "asked", "installed", "learned", "loaded", "reading"]


def learned(text: str, embedded: Embedded) -> tuple[Answer, Reading]:
    """The model's answer to a text, and what is read of it; raises ReaderError, and what the embedded interpreter
    raises where that has to stand in."""
    answer = loaded().answer(asked(text))
    return answer, reading(answer.text, text, embedded)

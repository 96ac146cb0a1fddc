"""An answer to a question from retrieved passages, in a model's words, with the passages that it rests on cited."""

import re
from collections.abc import Sequence

from c2s_engine.interpret.llm.asking import OnEvent, prompt
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import AnswerUnusable
from c2s_engine.models.messages import question as asked
from c2s_engine.structure.progress import Passage

LONGEST = 1200
"""Characters of a passage that the model is shown."""
ANSWER_TOKENS = 400
_THOUGHT = re.compile(r"<think(?:ing)?>.*?(?:</think(?:ing)?>|\Z)", re.S)
_CITED = re.compile(r"\[(\d+(?:\s*,\s*\d+)*)\]")


async def answer(
    question: str, passages: Sequence[Passage], client: OllamaClient, on_event: OnEvent | None = None
) -> str:
    """The answer; raises ModelError, also where it cites no passage that was shown."""
    shown = "\n\n".join(
        f"[{i}] {p.title}{f' ({p.clause})' if p.clause else ''}\n{p.text[:LONGEST].strip()}"
        for i, p in enumerate(passages, 1)
    )
    told = asked(
        prompt("answer"), f"Passages:\n\n{shown}\n\nQuestion: {question}", purpose="answer", answer_tokens=ANSWER_TOKENS
    )
    reply = await client.chat(told, on_event)
    text = _THOUGHT.sub("", reply.text).strip()
    cited = {int(n) for found in _CITED.findall(text) for n in found.split(",")}
    if not text:
        raise AnswerUnusable("it is empty")
    if not cited:
        raise AnswerUnusable("it cites no passage")
    if wrong := sorted(n for n in cited if not 1 <= n <= len(passages)):
        raise AnswerUnusable(f"it cites passage {wrong[0]}, which does not exist")
    return text

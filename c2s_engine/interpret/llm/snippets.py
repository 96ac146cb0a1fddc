"""A sentence on a component's code by a model, for the index of users' own programs."""

import re

from c2s_engine.interpret.llm.asking import FATAL, prompt
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.models.messages import question

KINDS = {"R": "the place", "E": "ego", "O": "another road user or thing", "T": "the restrictions"}
LONGEST = 3000
"""Characters of code that are shown."""
_THOUGHT = re.compile(r"<think(?:ing)?>.*?(?:</think(?:ing)?>|\Z)", re.S)


class Describer:
    """Asks for each component; where the model has no answer the sentence is empty, and what is in S stands."""

    def __init__(self, client: OllamaClient) -> None:
        self.client = client
        self._gone = False

    async def __call__(self, component: str, code: str) -> str:
        if self._gone:
            return ""
        told = question(
            prompt("snippet", kind=KINDS[component]), code[:LONGEST], purpose="describe snippet", answer_tokens=80
        )
        try:
            text = (await self.client.chat(told)).text
        except ModelError as error:
            self._gone = isinstance(error, FATAL)
            return ""
        lines = [line.strip(' *`"') for line in _THOUGHT.sub("", text).splitlines() if line.strip()]
        return lines[0][:300] if lines else ""

"""The ways in which Ollama can be asked for a form. Which of them a model keeps to differs by family and version.

What Ollama's issue tracker tells, and the probe looks for: with `think=false` /api/chat ignores `format` for qwen3.5
and 3.6, while /api/generate holds to it from the first token (14645); qwen3-vl puts the form into `thinking` (12831);
gpt-oss thinks whatever `think=false` says (11691), and knows levels; /api/generate never thinks where there is a
form (17544); with thinking on, gemma 4 fences its JSON (15416).
"""

from collections.abc import Sequence
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

from c2s_engine.models.messages import Message

Endpoint = Literal["chat", "generate"]
Think = bool | Literal["low", "medium", "high"]


class Way(BaseModel):
    """One way of asking: the endpoint, and what a model that can think is told about thinking."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    endpoint: Endpoint = "chat"
    think: Think = False

    def __str__(self) -> str:
        return f"/api/{self.endpoint} with think={str(self.think).lower()}"


CHAT, GENERATE = Way(), Way(endpoint="generate")
THINKING = (Way(think="low"), Way(think=True))
"""Ways for models that can think: the answer comes apart from the thoughts."""


def pieces(chunk: Any) -> tuple[str, str]:
    """(answer, thoughts) in a piece of either endpoint's stream."""
    part = getattr(chunk, "message", None)
    if part is None:
        return chunk.response or "", chunk.thinking or ""
    return part.content or "", part.thinking or ""


async def begin(api: Any, way: Way, messages: Sequence[Message], think: dict[str, Any], **options: Any) -> Any:
    """The stream of an answer. `api`: an `ollama.AsyncClient`; `think`: the argument, left out where it is refused."""
    if way.endpoint == "chat":
        return await api.chat(messages=[m.model_dump() for m in messages], stream=True, **think, **options)
    system = "\n\n".join(m.content for m in messages if m.role == "system")
    return await api.generate(system=system, prompt=_prompt(messages), stream=True, **think, **options)


def _prompt(messages: Sequence[Message]) -> str:
    """Turns as the one prompt that /api/generate takes."""
    lead = {"assistant": "You answered:\n"}
    return "\n\n".join(lead.get(m.role, "") + m.content for m in messages if m.role != "system")

"""One question to a model and its answer, independent of the client that carries them."""

import hashlib
import json
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

from c2s_engine.structure.components import ComponentId

CHARACTERS_PER_TOKEN = 4.0
"""The approximation by which prompts are budgeted before a model has counted them: English and code, 3.5 to 4.5."""


def approximate_tokens(text: str) -> int:
    """Tokens of a text, estimated as one per four characters, rounded up."""
    return -int(-len(text) // CHARACTERS_PER_TOKEN)


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Message(_Frozen):
    role: Literal["system", "user", "assistant"]
    content: str


class Question(_Frozen):
    """What is asked: the messages, the JSON schema that the answer must have, and what it is for."""

    messages: tuple[Message, ...]
    schema_: dict[str, Any] | None = None
    purpose: str = "chat"
    component: ComponentId | None = None
    answer_tokens: int | None = None

    @property
    def tokens(self) -> int:
        """The prompt's length, estimated; about four tokens go to each message's frame."""
        return sum(approximate_tokens(m.content) + 4 for m in self.messages)

    def digest(self, model: str, options: dict[str, Any]) -> str:
        """The address of the answer: everything that it depends on, nothing else."""
        what = {
            "model": model,
            "options": options,
            "messages": [m.model_dump() for m in self.messages],
            "format": self.schema_,
        }
        return hashlib.sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()


def question(system: str, user: str, *, schema: dict[str, Any] | None = None, **more: Any) -> Question:
    """A question of one system and one user message."""
    messages = (Message(role="system", content=system), Message(role="user", content=user))
    return Question(messages=messages, schema_=schema, **more)


class Reply(_Frozen):
    """A whole answer, with what it cost."""

    text: str
    thinking: str = ""
    prompt_tokens: int = 0
    answer_tokens: int = 0
    seconds: float = 0.0
    done_reason: str = "stop"
    replayed: bool = False


class Piece(_Frozen):
    """A piece of an answer as it streams; `reply` stands in the last one."""

    text: str = ""
    thinking: bool = False
    restarted: bool = False
    reply: Reply | None = None

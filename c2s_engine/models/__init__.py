"""Language-model clients and the token ledger."""

from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import ModelError
from c2s_engine.models.ledger import Ledger
from c2s_engine.models.messages import Message, Question, Reply, approximate_tokens, question
from c2s_engine.models.settings import ModelSettings

__all__ = [
    "Ledger",
    "Message",
    "ModelError",
    "ModelSettings",
    "OllamaClient",
    "Question",
    "Reply",
    "approximate_tokens",
    "question",
]

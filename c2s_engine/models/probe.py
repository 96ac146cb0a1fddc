"""What a model can do, tried once and remembered: does it keep to a JSON schema, does it think?"""

import json
from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from c2s_engine import paths
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import AnswerRepeats, AnswerTruncated
from c2s_engine.models.messages import question

SCHEMA = {
    "type": "object",
    "properties": {"colour": {"enum": ["red", "green"]}, "count": {"type": "integer"}},
    "required": ["colour", "count"],
    "additionalProperties": False,
}
"""Nothing in the probe's question asks for JSON: an answer of this form shows that the schema was held to."""


class Probe(BaseModel):
    """What was found about a model."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    model: str
    digest: str = ""
    honours_format: bool
    thinks: bool
    context_length: int = 0


async def probe(client: OllamaClient, folder: Path | None = None, again: bool = False) -> Probe:
    """The probe of the client's model, from the cache where the model's digest is the same; raises ModelError."""
    model = client.settings.model
    capabilities = await client.capabilities()
    digest = next((m["digest"] for m in await client.models() if m["name"] in (model, f"{model}:latest")), "")
    path = (folder or paths.cache_folder() / "models") / f"{_filename(model)}.json"
    known = _known(path)
    if known and known.digest == digest and not again:
        return known
    asked = question(
        "Answer in plain words.", "Name a colour of a traffic light.", schema=SCHEMA, purpose="probe", answer_tokens=64
    )
    try:
        reply = await client.chat(asked)
        text, thinking = reply.text, reply.thinking
    except (AnswerTruncated, AnswerRepeats):
        text, thinking = "", ""
    loaded = (await client.api.ps()).models
    found = Probe(
        model=model,
        digest=digest,
        honours_format=_holds(text),
        thinks=bool(thinking) or "thinking" in capabilities,
        context_length=next((m.context_length or 0 for m in loaded if m.model == model), 0),
    )
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(found.model_dump_json(indent=1), encoding="utf-8")
    return found


async def keeps_to_forms(client: OllamaClient, folder: Path | None = None) -> bool:
    """Whether the client's model keeps to a JSON schema, by the probe; True where it is not to be tried out."""
    settings = client.settings
    if not settings.probe or settings.record == "replay":
        known = _known((folder or paths.cache_folder() / "models") / f"{_filename(settings.model)}.json")
        return known is None or not settings.probe or known.honours_format
    if client.keeps_to_forms is None:
        client.keeps_to_forms = (await probe(client, folder)).honours_format
    return client.keeps_to_forms


def _known(path: Path) -> Probe | None:
    try:
        return Probe.model_validate_json(path.read_text(encoding="utf-8"))
    except (OSError, ValidationError):
        return None


def _holds(text: str) -> bool:
    try:
        value = json.loads(text)
    except ValueError:
        return False
    return isinstance(value, dict) and value.get("colour") in ("red", "green") and isinstance(value.get("count"), int)


def _filename(model: str) -> str:
    return "".join(c if c.isalnum() or c in "-._" else "_" for c in model)

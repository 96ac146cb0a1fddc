"""What a model can do, tried out and remembered: in which ways it keeps to a JSON schema, and whether it thinks.

Remembered by the model's digest and the server's version, since either changes what holds.
"""

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, ValidationError

from c2s_engine import paths
from c2s_engine.models.client import OllamaClient
from c2s_engine.models.errors import (
    AnswerRepeats,
    AnswerTruncated,
    AnswerUnusable,
    ModelCutOff,
    ModelError,
    ModelFailed,
    ModelRefused,
)
from c2s_engine.models.messages import question
from c2s_engine.models.ways import CHAT, GENERATE, THINKING, Way

SCHEMA = {
    "type": "object",
    "properties": {"colour": {"enum": ["green", "red"]}, "wheels": {"type": "integer", "minimum": 0, "maximum": 9}},
    "required": ["colour", "wheels"],
    "additionalProperties": False,
}
ASKED = question(
    "Answer in plain words, in one sentence.",
    "Which colour of a traffic light tells drivers to stop, and how many wheels does a car have?",
    schema=SCHEMA,
    purpose="probe",
    answer_tokens=64,
)
"""Nothing in it asks for JSON, on the contrary: a form in the answer shows that the schema was enforced."""
RIGHT = {"colour": "red", "wheels": 4}

OF_THE_WAY = (AnswerRepeats, AnswerTruncated, AnswerUnusable, ModelCutOff, ModelFailed)
"""Faults that speak against one way of asking; others (nobody there, no such model) end the probe."""


class Tried(BaseModel):
    """What came of asking in one way. `fault`: why it does not hold, a phrase; `right`: whether the answer is true."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    way: Way
    holds: bool
    right: bool = False
    tokens: int = 0
    seconds: float = 0.0
    fault: str = ""


class Probe(BaseModel):
    """What was found about a model on a server."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    model: str
    digest: str = ""
    server: str = ""
    thinks: bool
    context_length: int = 0
    tried: tuple[Tried, ...] = ()

    @property
    def honours_format(self) -> bool:
        """Whether the model keeps to a JSON schema in any of the ways tried."""
        return self.best() is not None

    def best(self, ways: Sequence[Way] = ()) -> Way | None:
        """The way (of those given) that holds: with a true answer if there is one, then with the fewest tokens."""
        held = [t for t in self.tried if t.holds and (not ways or t.way in ways)]
        return min(held, key=lambda t: (not t.right, t.tokens)).way if held else None

    def of(self, way: Way) -> Tried | None:
        """What came of a way; None where it was not tried."""
        return next((t for t in self.tried if t.way == way), None)


def ways_for(client: OllamaClient, thinks: bool) -> tuple[Way, ...]:
    """The ways that are worth trying: the settings' own, else from the cheapest to the dearest."""
    if client.settings.way:
        return (client.settings.way,)
    return (CHAT, GENERATE, *(THINKING if thinks else ()))


async def probe(
    client: OllamaClient,
    folder: Path | None = None,
    again: bool = False,
    every: bool = False,
    on_way: Callable[[Tried], Any] = lambda tried: None,
) -> Probe:
    """The probe of the client's model; raises ModelError. What is known of this digest and server is not tried again.

    `every`: try all ways, not only until one holds; `on_way` is told what came of each.
    """
    model = client.settings.model
    thinks = "thinking" in await client.capabilities()
    digest, server = (await client.installed(model) or {}).get("digest", ""), await client.version()
    path = _path(model, digest, server, folder)
    found = _read(path) or Probe(model=model, digest=digest, server=server, thinks=thinks)
    if again:
        found = found.model_copy(update={"tried": ()})
    ways, refused = ways_for(client, thinks), []
    for way in ways:
        tried = found.of(way)
        if tried is None:
            try:
                tried = await _try(client, way)
            except ModelRefused as error:
                refused.append(error)
                tried = Tried(way=way, holds=False, fault=_phrase(error))
            found = found.model_copy(update={"tried": (*found.tried, tried), "thinks": thinks})
        on_way(tried)
        if tried.holds and tried.right and not every:
            break
    if len(refused) == len(ways):
        raise refused[0]
    loaded = (await client.api.ps()).models
    context = next((m.context_length or 0 for m in loaded if m.model in (model, f"{model}:latest")), 0)
    found = found.model_copy(update={"context_length": context or found.context_length})
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(found.model_dump_json(indent=1), encoding="utf-8")
    return found


async def known(client: OllamaClient, folder: Path | None = None) -> Probe | None:
    """What was found before about the client's model, without asking it; raises ModelError."""
    model = client.settings.model
    digest = (await client.installed(model) or {}).get("digest", "")
    return _read(_path(model, digest, await client.version(), folder))


async def keeps_to_forms(client: OllamaClient, folder: Path | None = None) -> bool:
    """Whether the client's model keeps to a JSON schema, by the probe; the client then asks in the way that holds.

    True where it is not to be tried out."""
    settings = client.settings
    if not settings.probe:
        return True
    if client.keeps_to_forms is None:
        replayed = settings.record == "replay"  # there is no server to ask
        found = _latest(settings.model, folder) if replayed else await probe(client, folder)
        best = found.best((settings.way,) if settings.way else ()) if found else None
        client.keeps_to_forms = found is None or best is not None
        client.way = best or client.way
    return client.keeps_to_forms


async def _try(client: OllamaClient, way: Way) -> Tried:
    """Ask in one way; the client's own way is left as it was. Raises ModelRefused and what speaks against every way."""
    before, client.way = client.way, way
    try:
        reply = await client.chat(ASKED)
    except OF_THE_WAY as error:
        return Tried(way=way, holds=False, fault=_phrase(error))
    finally:
        client.way = before
    value, text = _form(reply.text), reply.text.strip()[:60]
    fault = "" if value else f"the form is ignored: {text!r}" if text else "the answer is empty"
    spent = {"tokens": reply.answer_tokens, "seconds": round(reply.seconds, 2)}
    return Tried(way=way, holds=bool(value), right=value == RIGHT, fault=fault, **spent)


def _form(text: str) -> dict[str, Any] | None:
    """The answer as a form of SCHEMA; None where it is none."""
    try:
        value = json.loads(text)
    except ValueError:
        return None
    if not isinstance(value, dict) or set(value) != {"colour", "wheels"}:
        return None
    wheels = value["wheels"]
    whole = isinstance(wheels, int) and not isinstance(wheels, bool) and 0 <= wheels <= 9
    return value if value["colour"] in ("green", "red") and whole else None


def _phrase(error: ModelError) -> str:
    return str(error).rstrip(".")


def _path(model: str, digest: str, server: str, folder: Path | None) -> Path:
    name = "-".join(_plain(part) for part in (model, digest.removeprefix("sha256:")[:12], server) if part)
    return (folder or paths.cache_folder() / "models") / f"{name}.json"


def _latest(model: str, folder: Path | None) -> Probe | None:
    """What was found last about a model, on whatever server."""
    files = (folder or paths.cache_folder() / "models").glob(f"{_plain(model)}*.json")
    found = (_read(f) for f in sorted(files, key=lambda f: f.stat().st_mtime, reverse=True))
    return next((p for p in found if p and p.model == model), None)


def _read(path: Path) -> Probe | None:
    try:
        return Probe.model_validate_json(path.read_text(encoding="utf-8"))
    except (OSError, ValidationError):
        return None


def _plain(text: str) -> str:
    return "".join(c if c.isalnum() or c in "-._" else "_" for c in text)

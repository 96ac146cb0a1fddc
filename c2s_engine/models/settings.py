"""How a model is reached and asked: the user's settings, with the host from OLLAMA_HOST where none is given."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from c2s_engine.models.errors import BadSettings
from c2s_engine.models.ways import Endpoint, Think, Way

DEFAULT_HOST = "http://127.0.0.1:11434"


def default_host() -> str:
    """The host that Ollama's own tools would use."""
    return os.environ.get("OLLAMA_HOST") or DEFAULT_HOST


class ModelSettings(BaseModel):
    """One model at one host. `num_ctx` is the same for every call: a change makes Ollama load the model anew."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    model: str = Field("", description="the model's name as Ollama lists it; empty: none")
    host: str = Field(default_factory=default_host, description="where Ollama listens; default OLLAMA_HOST")
    num_ctx: int = Field(8192, ge=1024, description="context size, tokens")
    answer_tokens: int = Field(1536, ge=16, description="longest answer, tokens (num_predict)")
    timeout: float = Field(180.0, gt=0, description="longest silence of the model, s (loading it included)")
    connect_timeout: float = Field(5.0, gt=0, description="longest wait for the connection, s")
    keep_alive: str = Field("30m", description="how long Ollama keeps the model loaded after a call")
    think: Think | None = Field(None, description="whether a thinking model may think; none: as the probe found")
    endpoint: Endpoint | None = Field(None, description="where forms are asked for; none: as the probe found")
    thinking_tokens: int = Field(2048, ge=0, description="room for thoughts where a model may think, tokens")
    temperature: float = Field(0.0, ge=0)
    seed: int = Field(0, description="of the model's sampling")
    retries: int = Field(2, ge=0, description="further tries after a fault that may pass")
    backoff: float = Field(0.5, ge=0, description="pause before the first further try, s; doubled each time")
    probe: bool = Field(True, description="whether a model is tried out before its first form (does it keep to one?)")
    record: Literal["off", "record", "replay"] = Field(
        "off", description="record: keep every answer; replay: answer from what was kept, without a model"
    )
    record_folder: Path | None = Field(None, description="where recorded answers lie; default: in the data folder")

    @property
    def way(self) -> Way | None:
        """How forms are asked for where `think` or `endpoint` say so; else the probe finds it."""
        if self.think is None and self.endpoint is None:
            return None
        return Way(endpoint=self.endpoint or "chat", think=self.think or False)


def settings_for(model: str, table: Mapping[str, Any], host: str = "") -> ModelSettings:
    """The settings of one model: config.toml's [ollama], over it [ollama.models."NAME"]; raises BadSettings."""
    general = {name: value for name, value in table.items() if name != "models"}
    own = table.get("models", {}).get(model, {}) if isinstance(table.get("models", {}), Mapping) else {}
    values = {"host": default_host(), **general, **own, "model": model, **({"host": host} if host else {})}
    try:
        return ModelSettings.model_validate(values)
    except ValidationError as error:
        first = error.errors()[0]
        raise BadSettings(".".join(map(str, first["loc"])), first["msg"]) from None
